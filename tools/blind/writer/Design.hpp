#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace blind {

/// One set that is to be written: what kind of question it asks.
struct Item {
  std::string group;        // control, decoy, catalogue, pair, outside, absorbed, corrupted
  std::string kind;         // which effect, decoy, absorbed case or corruption; empty: drawn for the set
  double noncentrality = 0; // wanted; 0: a physical size
  int poses = 20;
  std::string noise = "clean";
  bool pictures = false;
};

/// How many sets of each kind.
struct Counts {
  int controls = 4;        // per regime of noise
  int sets = 1;            // per effect and size, per case of the other groups
  double pictureShare = 0; // of controls and catalogued effects: so many are rendered as pictures, on top
  std::string only;        // one group alone; empty: all
};

const std::vector<std::string>& noiseRegimes();

/// All sets of a benchmark in a random order: any beginning of it is a fair sample.
std::vector<Item> design(const Counts& counts, std::uint64_t seed);

} // namespace blind
