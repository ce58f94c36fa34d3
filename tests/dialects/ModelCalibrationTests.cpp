#include "dialects/ModelCalibration.hpp"

#include "RobotV6.hpp"
#include "calibration/Calibration.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "simulation/HandMadePoses.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

const std::map<std::string, CameraIntrinsics> lenses{{"top", {640, 480, 600, 610, 321, 242, {0.1, 0, 0, 0, 0}}}};

RobotCalibration sample() {
  RobotCalibration calibration;
  calibration.offsets = {{"LKneePitch", 0.03}, {"HeadYaw", -0.01}};
  calibration.cameras["top"] = {Eigen::Vector3d{0.01, 0.02, 0.03}, Eigen::Vector3d{0.001, 0.002, 0.003},
                                CameraIntrinsics{640, 480, 606, 616.1, 331, 239, {0.15, -0.02, 0.001, 0.002, 0}}};
  calibration.headId = "head";
  return calibration;
}

} // namespace

TEST_CASE("a calibration and the unknowns of a model are the same numbers") {
  // Proves both directions by each other, and the lens's relation to the captures' by hand.
  const auto values = valuesFromCalibration(sample(), lenses);
  CHECK(values.at("jointOffset@LKneePitch.o") == 0.03);
  CHECK(values.at("focalLength@top.s") == Approx(0.01));
  CHECK(values.at("principalPoint@top.x") == Approx(10));
  CHECK(values.at("principalPoint@top.y") == Approx(-3));
  CHECK(values.at("radialDistortion@top.k1") == Approx(0.05));
  CHECK(values.at("tangentialDistortion@top.p2") == Approx(0.002));
  const RobotCalibration back = calibrationFromValues(values, lenses);
  CHECK(back.offsets == sample().offsets);
  const CameraCalibration &one = back.cameras.at("top"), other = sample().cameras.at("top");
  CHECK(*one.rotation == *other.rotation);
  CHECK(*one.translation == *other.translation);
  CHECK(one.lens->fx == Approx(606));
  CHECK(one.lens->fy == Approx(616.1));
  CHECK(one.lens->distortion[1] == Approx(-0.02));
}

TEST_CASE("a lens of larger pictures starts as that of the captures' size") {
  // Proves the scale about the picture's edge: a lens of 1280 x 960 whose rays are those of the captures' changes
  // nothing.
  RobotCalibration calibration;
  calibration.cameras["top"].lens =
      CameraIntrinsics{1280, 960, 1200, 1220, 2 * 321.5 - 0.5, 2 * 242.5 - 0.5, {0.1, 0, 0, 0, 0}};
  for (const auto& [name, value] : valuesFromCalibration(calibration, lenses)) {
    INFO(name);
    CHECK(std::abs(value) < 1e-9);
  }
}

TEST_CASE("a calibration's file holds it whole, and refuses other numbers") {
  // Proves the round trip of CALIBRATION.json, and place and reason of refusals.
  const nlohmann::json json = calibrationJson(sample());
  CHECK(calibrationJson(parseCalibration(nlohmann::json::parse(json.dump()), "start.json")) == json);
  const auto refusal = [](nlohmann::json document) {
    try {
      (void)parseCalibration(document, "start.json");
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{"not refused"};
  };
  nlohmann::json broken = json;
  broken["offsets"]["LeftKnee"] = 0.1;
  CHECK(refusal(broken).find("LeftKnee") != std::string::npos);
  broken = json;
  broken["cameras"]["top"]["rotation"] = {0, 0};
  CHECK(refusal(broken).find("cameras.top.rotation") != std::string::npos);
  broken = json;
  broken["format"] = "naocal-model";
  CHECK(refusal(broken).find("naocal-calibration") != std::string::npos);
}

TEST_CASE("a search that starts at a calibration finds the same answer, sooner if it was near") {
  // Proves that the start changes only the way: the same estimates from the drawing, from the truth and from a start
  // that is 10 degrees off; and that numbers that the model lacks are named.
  SimulationPlan plan = handMadePlan(v6(), 8);
  const Measurements measurements = buildMeasurements({simulate(v6(), plan, 6).set}, v6());
  const Model model = buildModel(measurements);
  const CalibrationResult plain = calibrate(measurements, model);
  const auto solveFrom = [&](const RobotCalibration& calibration) {
    CalibrationOptions options;
    options.start = startAt(valuesFromCalibration(calibration, {}), measurements, model).unknowns;
    return calibrate(measurements, model, options);
  };
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < model.unknownCount(); ++i) {
    values[model.names()[i]] = plain.unknowns[static_cast<Eigen::Index>(i)];
  }
  RobotCalibration near = calibrationFromValues(values, {}), far;
  far.offsets["LKneePitch"] = near.offsets.at("LKneePitch") + radians(10);
  for (const RobotCalibration& start : {near, far}) {
    const CalibrationResult result = solveFrom(start);
    CHECK(result.converged);
    CHECK((result.unknowns - plain.unknowns).cwiseAbs().maxCoeff() < 1e-4);
  }
  CHECK(solveFrom(near).iterations <= plain.iterations);
  near.cameras["top"].translation = Eigen::Vector3d{0.001, 0, 0};
  const SearchStart start = startAt(valuesFromCalibration(near, {}), measurements, model);
  CHECK(start.unused == std::vector<std::string>{"cameraTranslation@top.x"});
  CHECK(start.count == near.offsets.size() + 6);
}

} // namespace naocal
