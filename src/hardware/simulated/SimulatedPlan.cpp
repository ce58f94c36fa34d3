#include "hardware/simulated/SimulatedPlan.hpp"

#include "data/BoardFile.hpp"
#include "io/Files.hpp"
#include "io/JsonReader.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

constexpr Range fewDegrees{0, 20, "degrees"}, fractions{0, 1, "s"}, periods{0.01, 1, "s"}, shares{0, 1, ""},
    greyLevels{0, 50, "grey levels"};

/// Reads an optional number within `range`; `unit` converts it to the plan's unit.
void take(const JsonCursor& top, const char* key, const Range& range, double unit, double& value) {
  if (const auto given = top.find(key)) {
    value = unit * given->number(range);
  }
}

void take(const JsonCursor& top, const char* key, const Range& range, Seconds& value) {
  double number = value.count();
  take(top, key, range, 1, number);
  value = Seconds{number};
}

std::vector<Board> placedBoards(const JsonCursor& place) {
  std::vector<Board> boards;
  for (const JsonCursor& one : place.elements()) {
    boards.push_back(readBoard(one));
    if (!boards.back().placement || !boards.back().pattern) {
      one.refuse("a ChArUco board with its placement on the floor, to be simulated");
    }
  }
  requireDistinctMarkers(boards, place);
  return boards;
}

} // namespace

RawAngles SimulatedPlan::standingAngles() {
  RawAngles angles;
  const auto set = [&](std::string_view joint, double value) { angles[*jointIndex(joint)] = radians(value); };
  for (const std::string side : {"L", "R"}) {
    set(side + "ShoulderPitch", 85);
    set(side + "ShoulderRoll", side == "L" ? 8 : -8);
    set(side + "ElbowRoll", side == "L" ? -5 : 5);
    set(side + "HipPitch", -26);
    set(side + "KneePitch", 52);
    set(side + "AnklePitch", -26);
  }
  return angles;
}

SimulatedErrors drawErrors(const Robot& drawing, const SimulatedPlan& plan) {
  RandomStream errorChance{plan.seed, "errors"}, playChance{plan.seed, "play"};
  SimulatedErrors errors{drawErrors(drawing, plan.offsetRange, plan.mountRange, plan.mountShiftRange, errorChance),
                         std::vector<double>(drawing.joints.size())};
  for (double& play : errors.play) {
    play = std::abs(playChance.uniformWithin(plan.playRange));
  }
  for (std::size_t joint = 0; joint < drawing.joints.size(); ++joint) {
    errors.play[joint] = errors.play[drawing.joints[joint].motor];
  }
  return errors;
}

SimulatedPlan readSimulatedPlan(const std::filesystem::path& file, SimulatedPlan plan) {
  const nlohmann::json document = parseJson(readFile(file), file.string());
  const JsonCursor top{document, file.string()};
  constexpr std::array known{"model",
                             "seed",
                             "pace",
                             "offsetRangeDegrees",
                             "mountRangeDegrees",
                             "playRangeDegrees",
                             "droopDegreesPerNewtonMetre",
                             "periodSeconds",
                             "exposureSeconds",
                             "readOutSeconds",
                             "jitterSeconds",
                             "lostShare",
                             "pictureNoise",
                             "boards"};
  for (const auto& [key, place] : top.members()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      place.refuse("a key of a simulated robot (SimulatedPlan.hpp)", "the key \"" + key + "\"");
    }
  }
  if (const auto model = top.find("model")) {
    plan.model = model->text();
  }
  if (const auto seed = top.find("seed")) {
    plan.seed = std::uint64_t(seed->integer(0, maxInteger));
  }
  if (const auto pace = top.find("pace")) {
    plan.pace = Pace(pace->wordIndex({"real", "quick"}));
  }
  take(top, "offsetRangeDegrees", fewDegrees, radians(1), plan.offsetRange);
  take(top, "mountRangeDegrees", fewDegrees, radians(1), plan.mountRange);
  take(top, "playRangeDegrees", fewDegrees, radians(1), plan.playRange);
  take(top, "droopDegreesPerNewtonMetre", fewDegrees, radians(1), plan.servos.droop);
  take(top, "periodSeconds", periods, plan.cameras.period);
  take(top, "exposureSeconds", fractions, plan.cameras.exposure);
  take(top, "readOutSeconds", fractions, plan.cameras.readOut);
  take(top, "jitterSeconds", fractions, plan.cameras.jitter);
  take(top, "lostShare", shares, 1, plan.cameras.lostShare);
  take(top, "pictureNoise", greyLevels, 1, plan.cameras.appearance.noise);
  if (const auto boards = top.find("boards")) {
    plan.boards = placedBoards(*boards);
  }
  return plan;
}

} // namespace naocal
