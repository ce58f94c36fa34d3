#include "writer/Design.hpp"

#include "writer/Chance.hpp"
#include "writer/Corruption.hpp"
#include "writer/Families.hpp"

#include <array>
#include <cmath>

namespace blind {

namespace {

const std::array<int, 6> poseCounts{8, 12, 16, 20, 20, 30};
const std::array<double, 5> sizes{10, 20, 40, 100, 0};

class Designer {
public:
  Designer(const Counts& counts, std::uint64_t seed) : counts_{counts}, chance_{seed, "design"} {}

  std::vector<Item> items() {
    for (const std::string& noise : noiseRegimes()) {
      repeat(counts_.controls, {"control", "", 0, 0, noise});
    }
    for (const char* kind : {"idle temperature", "sorted poses"}) {
      repeat(2 * counts_.sets, {"decoy", kind});
    }
    for (const Family& family : catalogue()) {
      for (const double size : sizes) {
        repeat(counts_.sets, {"catalogue", family.effect, size});
      }
    }
    repeat(5 * counts_.sets, {"pair", "", 40, 20});
    for (const Family& family : outside()) {
      repeat(counts_.sets, {"outside", family.effect, 0, 20, "clean"});
      for (const double size : {40.0, 80.0}) {
        repeat(counts_.sets, {"outside", family.effect, size, 20, "stiction 0.05"});
      }
    }
    for (const std::string& kind : absorbedKinds()) {
      repeat(counts_.sets, {"absorbed", kind});
    }
    for (const std::string& kind : corruptions()) {
      repeat(counts_.sets, {"corrupted", kind});
    }
    addWrongModels();
    for (std::size_t i = items_.size(); i > 1; --i) {
      std::swap(items_[i - 1], items_[chance_.below(static_cast<int>(i))]);
    }
    return std::move(items_);
  }

private:
  /// Sets on which a fit that misses something must stay honest.
  void addWrongModels() {
    for (const Family& family : catalogue()) {
      for (const double size : plausibleSizes) {
        repeat(counts_.sets, {"sized", family.effect, 0, 0, "clean", false, size});
      }
    }
    for (const std::string& family : cameraFamilies()) {
      for (int i = 0; i < 3 * counts_.sets; ++i) {
        repeat(1, {"camera", family, 0, 0, "clean", false, chance_.between(0.1, 2)});
      }
    }
    repeat(6 * counts_.sets, {"twin", ""});
    for (const std::string& kind : eventKinds()) {
      repeat(3 * counts_.sets, {"event", kind});
    }
    for (const char* kind : {"rest", "reapproach"}) {
      for (const char* noise : {"jitter 0.015", "jitter 0.03", "jitter 0.05", "jitter 0.10"}) {
        repeat(counts_.sets, {"jitter", kind, 0, 0, noise});
      }
    }
  }

  /// What the item leaves open is drawn. Rendered sets come on top: they cannot be sized as exactly.
  void repeat(int count, Item item) {
    const bool renderable = item.group == "control" || item.group == "catalogue";
    const double share = renderable ? counts_.pictureShare : 0;
    const int rendered = static_cast<int>(std::lround(count * share / (1 - share)));
    const bool open = item.poses == 0 || (item.group != "pair" && item.group != "outside");
    for (int i = 0; i < count + rendered; ++i) {
      Item one = item;
      if (open) {
        one.poses = poseCounts[chance_.below(static_cast<int>(poseCounts.size()))];
      }
      if (item.group != "control" && item.group != "outside" && item.group != "jitter") {
        one.noise = noiseRegimes()[chance_.below(static_cast<int>(noiseRegimes().size()))];
      }
      one.pictures = i >= count;
      if (counts_.only.empty() || counts_.only == item.group) {
        items_.push_back(std::move(one));
      }
    }
  }

  const Counts& counts_;
  Chance chance_;
  std::vector<Item> items_;
};

} // namespace

const std::vector<std::string>& noiseRegimes() {
  static const std::vector<std::string> regimes{"clean",         "heavy tails",   "quantised",    "stiction 0.02",
                                                "stiction 0.05", "stiction 0.10", "picture bias", "foreshortening"};
  return regimes;
}

std::vector<Item> design(const Counts& counts, std::uint64_t seed) {
  return Designer{counts, seed}.items();
}

} // namespace blind
