#pragma once

#include "world/RandomStream.hpp"
#include "writer/SessionPlanner.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace blind {

/// One set to be written.
struct DesignItem {
  std::string group; // control, decoy, catalogue, pair, outside, absorbed, corrupted, sized, camera, twin, event,
                     // jitter
  std::string kind;  // effect, decoy, absorbed case or corruption; empty: drawn
  double noncentrality = 0; // target; 0: physical or plausible size
  int poses = 20;
  std::string noise = "clean";
  bool pictures = false;
  double plausible = 0; // size in units of the plausible size; 0: not sized this way
};

/// Small, medium and large effects, in plausible sizes.
constexpr std::array<double, 3> plausibleSizes{0.5, 1, 2};

/// Numbers of sets.
struct DesignCounts {
  int controls = 4;        // per noise regime
  int sets = 1;            // per effect and size; otherwise per case
  double pictureShare = 0; // fraction of controls and catalogued effects rendered as images, in addition
  std::string only;        // a single group; empty: all
};

/// All sets of a benchmark in random order: every prefix is a fair sample.
std::vector<DesignItem> drawDesign(const DesignCounts& counts, std::uint64_t seed);

/// The session plan of an item; draws what the item leaves open.
SessionPlan drawPlan(const DesignItem& item, RandomStream& chance);

/// A robot without flaws, with offsets within 6.5 degrees and camera mounts within 2 degrees.
Robot drawRobot(const Drawing& drawing, std::size_t boards, RandomStream& chance);

/// The same robot without flaws; keeps offsets and mounts.
Robot withoutFlaws(Robot robot);

} // namespace blind
