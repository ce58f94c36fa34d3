#include "writer/Design.hpp"

#include "world/Drawing.hpp"
#include "world/Flaws.hpp"
#include "world/RandomStream.hpp"
#include "writer/Corruption.hpp"

#include <array>
#include <cmath>

namespace blind {

namespace {

const std::array<int, 6> poseCounts{8, 12, 16, 20, 20, 30};
const std::array<double, 5> sizes{10, 20, 40, 100, 0};

/// Names of all noise regimes.
const std::vector<std::string>& noiseRegimes() {
  static const std::vector<std::string> regimes{"clean",         "heavy tails",   "quantised",    "stiction 0.02",
                                                "stiction 0.05", "stiction 0.10", "picture bias", "foreshortening"};
  return regimes;
}

class Designer {
public:
  Designer(const DesignCounts& counts, std::uint64_t seed) : counts_{counts}, chance_{seed, "design"} {}

  std::vector<DesignItem> items() {
    for (const std::string& noise : noiseRegimes()) {
      repeat(counts_.controls, {"control", "", 0, 0, noise});
    }
    for (const char* kind : {"idle temperature", "sorted poses"}) {
      repeat(2 * counts_.sets, {"decoy", kind});
    }
    for (const FlawFamily& family : catalogue()) {
      for (const double size : sizes) {
        repeat(counts_.sets, {"catalogue", family.effect, size});
      }
    }
    repeat(5 * counts_.sets, {"pair", "", 40, 20});
    for (const FlawFamily& family : offCatalogue()) {
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
  /// Sets for which an incomplete model must still give honest results.
  void addWrongModels() {
    for (const FlawFamily& family : catalogue()) {
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

  /// Draws what the item leaves open. Rendered sets are added, since they cannot be sized as exactly.
  void repeat(int count, DesignItem item) {
    const bool renderable = item.group == "control" || item.group == "catalogue";
    const double share = renderable ? counts_.pictureShare : 0;
    const int rendered = static_cast<int>(std::lround(count * share / (1 - share)));
    const bool open = item.poses == 0 || (item.group != "pair" && item.group != "outside");
    for (int i = 0; i < count + rendered; ++i) {
      DesignItem one = item;
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

  const DesignCounts& counts_;
  RandomStream chance_;
  std::vector<DesignItem> items_;
};

/// The regime of that name; numbers in it are degrees ("stiction 0.05"). Unknown words are ignored.
NoiseRegime noiseRegime(const std::string& name) {
  NoiseRegime regime;
  regime.name = name;
  regime.heavyTails = name == "heavy tails";
  regime.foreshortened = name == "foreshortening";
  regime.pictureBias = name == "picture bias" ? 0.1 : 0;
  regime.quantised = name == "quantised" || name.starts_with("stiction");
  if (name.starts_with("stiction")) {
    regime.stiction = std::stod(name.substr(9)) * radiansPerDegree;
  }
  if (name.starts_with("jitter")) { // in whole steps, like real encoders
    regime.quantised = true;
    regime.jitter = std::stod(name.substr(7)) * radiansPerDegree;
  }
  return regime;
}

} // namespace

std::vector<DesignItem> drawDesign(const DesignCounts& counts, std::uint64_t seed) {
  return Designer{counts, seed}.items();
}

SessionPlan drawPlan(const DesignItem& item, RandomStream& chance) {
  SessionPlan plan;
  plan.poses = item.poses;
  plan.boards = 3 + chance.below(2);
  plan.mainSide = chance.below(2);
  plan.bothSides = item.poses >= 12 && item.group != "absorbed" && chance.uniform() < 0.5;
  plan.rests = chance.uniform() < 0.15;
  plan.restands = chance.uniform() < 0.25;
  plan.warmAnyhow = item.kind == "idle temperature";
  plan.sortedByKnee = item.kind == "sorted poses";
  plan.sameTemperature = item.kind == "constant temperature";
  plan.speed = item.kind == "no motion" ? 0 : plan.speed;
  plan.noise = noiseRegime(item.noise);
  if (item.group == "jitter") {
    plan.repeats = item.kind == "rest" ? RepeatKind::rest : RepeatKind::reapproach;
    plan.restands = false;
  }
  if (item.pictures) {
    constexpr double foundCorners = 0.1; // residual error of a good detector [px]
    plan.noise.pixel = foundCorners;
  }
  return plan;
}

Robot drawRobot(const Drawing& drawing, std::size_t boards, RandomStream& chance) {
  Robot robot;
  robot.drawing = &drawing;
  robot.offsets.resize(static_cast<Eigen::Index>(drawing.joints.size()));
  for (double& offset : robot.offsets) {
    offset = chance.uniformWithin(6.5 * radiansPerDegree);
  }
  for (std::size_t i = 0; i < drawing.joints.size(); ++i) {
    if (!drawing.joints[i].drivenBy.empty()) {
      robot.offsets[static_cast<Eigen::Index>(i)] = robot.offsets[drawing.joint(drawing.joints[i].drivenBy)];
    }
  }
  for (Eigen::Vector3d& turns : robot.mountTurns) {
    for (double& turn : turns) {
      turn = chance.uniformWithin(2 * radiansPerDegree);
    }
  }
  robot.flaws.joints.resize(drawing.joints.size());
  robot.flaws.boards.resize(boards);
  return robot;
}

Robot withoutFlaws(Robot robot) {
  Flaws none;
  none.joints.resize(robot.flaws.joints.size());
  none.boards.resize(robot.flaws.boards.size());
  robot.flaws = none;
  return robot;
}

} // namespace blind
