#include "brain/CalibrationBoards.hpp"
#include "brain/CalibrationStep.hpp"
#include "math/Angles.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

namespace naocal {

TEST_CASE("the head takes every pair of angles in random order, each from both sides") {
  // Proves that all pairs are there, that another seed gives another order, that the last piece of the way goes the way
  // that is recorded, and that a smaller share looks nearer to the middle.
  const CompensatedAngles stand;
  const std::size_t turns = *jointNumber("HeadYaw"), nods = *jointNumber("HeadPitch");
  const auto looks = [&](const CalibrationRound& round) {
    std::vector<std::pair<double, double>> result;
    for (const CalibrationStep& step : round) {
      if (step.pictures > 0) {
        result.emplace_back(std::round(degrees(step.points.back()[turns])),
                            std::round(degrees(step.points.back()[nods])));
      }
    }
    return result;
  };
  RoundOptions options{2, radians(1), 0, 1};
  const CalibrationRound round = headRound(stand, {-45, 0, 45}, {-10, 10}, 1, options);
  const auto first = looks(round);
  CHECK(first.size() == 12);
  CHECK(std::set(first.begin(), first.end()).size() == 6);
  std::map<std::string, double> sides;
  for (const CalibrationStep& step : round) {
    if (step.pictures > 0) {
      for (const std::size_t joint : {turns, nods}) {
        const double last = step.points.back()[joint] - step.points.front()[joint];
        CHECK(last == Approx(radians(1) * step.taken.joints.approach[joint]));
        sides[step.taken.pose] += step.taken.joints.approach[joint];
      }
      CHECK(step.taken.repeatKind == RepeatKind::reapproach);
    }
  }
  for (const auto& [pose, sum] : sides) {
    CHECK(sum == 0);
  }
  options.seed = 2;
  CHECK(looks(headRound(stand, {-45, 0, 45}, {-10, 10}, 1, options)) != first);
  for (const auto& [turned, nodded] : looks(headRound(stand, {-40, 0, 40}, {-10, 10}, 0.5, options))) {
    CHECK(std::abs(turned) <= 20);
    CHECK(std::abs(nodded) == 5);
  }
}

TEST_CASE("boards that share a marker are refused before a calibration begins") {
  // Proves it, and that the refusal names the marker's boards.
  const auto boards = [](int second) {
    nlohmann::json list = nlohmann::json::array();
    for (const auto& [id, first] : {std::pair{"A", 0}, std::pair{"B", second}}) {
      list.push_back({{"id", id},
                      {"dictionary", "DICT_4X4_100"},
                      {"squaresX", 7},
                      {"squaresY", 5},
                      {"squareLength", 0.08},
                      {"markerLength", 0.06},
                      {"firstMarkerId", first}});
    }
    return list;
  };
  CHECK(boards(17).get<CalibrationBoards>().boards.size() == 2);
  try {
    boards(16).get<CalibrationBoards>();
    FAIL("was taken");
  } catch (const std::exception& error) {
    INFO(error.what());
    CHECK(std::string{error.what()}.find("boards") == 0);
    CHECK(std::string{error.what()}.find('A') != std::string::npos);
  }
}

} // namespace naocal
