#include "effects/UserEffect.hpp"
#include "fuzz/driver/Reader.hpp"
#include "robot/Robot.hpp"

#include <array>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// The input is the correction of an effect with the unknowns a and b; what is accepted is evaluated.
void evaluateCorrection(std::string_view bytes) {
  static const Robot robot = loadRobot(configurationDirectory(), "V6");
  const std::string quoted = nlohmann::json(bytes).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const nlohmann::json definition{
      {"name", "cable"},
      {"at", "LKneePitch"},
      {"correction", nlohmann::json::parse(quoted)},
      {"unknowns", {{"a", {{"unit", "rad"}, {"sigma", 0.01}}}, {"b", {{"unit", "rad/Nm"}, {"sigma", 0.005}}}}}};
  const Effect effect = parseUserEffect(JsonCursor{definition, "model.json"}, robot);
  const Eigen::VectorXd numbers = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()));
  RobotSample instant;
  instant.q = instant.velocity = instant.approach = instant.temperature = instant.current = instant.torque = numbers;
  ModelState state = nominalState(robot, {robot.joints.size(), robot.lengths.size(), 0});
  effect.correct(state, instant, *robot.jointIndex("LKneePitch"), std::array{0.01, -0.005});
}

const Reader expressionReader{"expression", evaluateCorrection};

} // namespace
} // namespace naocal
