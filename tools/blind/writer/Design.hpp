#pragma once

#include "writer/RandomStream.hpp"
#include "writer/SessionPlanner.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace blind {

/// One set that is to be written: what kind of question it asks.
struct DesignItem {
  std::string group; // control, decoy, catalogue, pair, outside, absorbed, corrupted, sized, camera, twin, event,
                     // jitter
  std::string kind;  // which effect, decoy, absorbed case or corruption; empty: drawn for the set
  double noncentrality = 0; // wanted; 0: a physical size, or the next
  int poses = 20;
  std::string noise = "clean";
  bool pictures = false;
  double plausible = 0; // so many times as large as is plausible; 0: not sized so
};

/// Small, medium and large effects, in plausible sizes.
constexpr std::array<double, 3> plausibleSizes{0.5, 1, 2};

/// How many sets of each kind.
struct DesignCounts {
  int controls = 4;        // per regime of noise
  int sets = 1;            // per effect and size, per case of the other groups
  double pictureShare = 0; // of controls and catalogued effects: so many are rendered as pictures, on top
  std::string only;        // one group alone; empty: all
};

const std::vector<std::string>& noiseRegimes();

/// All sets of a benchmark in a random order: any beginning of it is a fair sample.
std::vector<DesignItem> drawDesign(const DesignCounts& counts, std::uint64_t seed);

/// How the session of an item is held: what the item leaves open is drawn.
SessionPlan drawPlan(const DesignItem& item, RandomStream& chance);

/// A robot without flaws but with offsets within 6.5 degrees and camera mounts within 2 degrees.
Robot drawRobot(const Drawing& drawing, std::size_t boards, RandomStream& chance);

/// The same robot with its offsets and mounts, all else sound.
Robot withoutFlaws(Robot robot);

NoiseRegime noiseRegime(const std::string& name);

} // namespace blind
