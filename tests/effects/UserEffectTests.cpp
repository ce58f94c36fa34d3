#include "effects/UserEffect.hpp"

#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "robot/Kinematics.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <thread>

namespace naocal {
namespace {

const char* const cable = R"json({"name": "kneeCable", "at": "LKneePitch", "correction": "a*sin(3*q) + b*abs(tau)",
  "unknowns": {"a": {"unit": "rad", "sigma": 0.01}, "b": {"unit": "rad/Nm", "sigma": 0.005}}})json";

struct Bench {
  Bench() {
    const auto joints = static_cast<Eigen::Index>(robot.joints.size());
    instant.time = Seconds{12};
    instant.q = Eigen::VectorXd::LinSpaced(joints, 0.2, 0.4);
    instant.torque = -2 * instant.q;
    instant.velocity = 3 * instant.q;
    instant.approach = 4 * instant.q;
    instant.temperature = 5 * instant.q;
    instant.current = 6 * instant.q;
    instant.com = {0.02, 0.03};
    instant.imu = {0.01, 0.05};
  }
  Effect effect(const std::string& text) const {
    const nlohmann::json json = parseJson(text, "model.json");
    return parseUserEffect(JsonCursor{json, "model.json"}, robot);
  }
  /// Error message for the cable's definition with one part replaced; "accepted" if there is none.
  std::string refusal(const std::string& from, const std::string& to) const {
    std::string text = cable;
    text.replace(text.find(from), from.size(), to);
    try {
      effect(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
  double correction(const Effect& effect, std::size_t joint, const std::vector<double>& values) const {
    ModelState modelState = nominalState(robot, {robot.joints.size(), robot.lengths.size(), 0});
    effect.correct(modelState, instant, joint, values);
    return modelState.angle(joint);
  }
  Robot robot = loadRobot(configurationDirectory(), "V6");
  RobotSample instant;
};

} // namespace

TEST_CASE("a person's own effect corrects as its expression says, in several threads at once") {
  // Proves values, drivers found in the expression, the place, and thread safety.
  const Bench bench;
  const Effect effect = bench.effect(cable);
  const std::size_t knee = *bench.robot.jointIndex("LKneePitch");
  const double q = bench.instant.q[static_cast<Eigen::Index>(knee)];
  CHECK(bench.correction(effect, knee, {0.01, 0.002}) == Approx(0.01 * std::sin(3 * q) + 0.002 * 2 * q));
  CHECK(effect.drivers == std::vector<Driver>{Driver::angle, Driver::torque});
  CHECK(effect.onlyAtMotor == knee);
  std::vector<int> wrong(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    threads.emplace_back([&, i] {
      for (int k = 0; k < 2000; ++k) {
        const double a = 0.001 * k * static_cast<double>(i + 1);
        wrong[i] += std::abs(bench.correction(effect, knee, {a, 0}) - a * std::sin(3 * q)) > 1e-12;
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  CHECK(wrong == std::vector<int>(4, 0));
}

TEST_CASE("an expression may use every name of the contract") {
  // Proves that each name refers to its own quantity.
  const Bench bench;
  const RobotSample& at = bench.instant;
  const auto joint = [&](const char* name) { return static_cast<Eigen::Index>(*bench.robot.jointIndex(name)); };
  const std::vector<std::pair<std::string, double>> names{{"q", at.q[3]},
                                                          {"tau", at.torque[3]},
                                                          {"qd", at.velocity[3]},
                                                          {"approach", at.approach[3]},
                                                          {"T", at.temperature[3]},
                                                          {"current", at.current[3]},
                                                          {"t", at.time.count()},
                                                          {"HeadYaw", at.q[joint("HeadYaw")]},
                                                          {"tau_RKneePitch", at.torque[joint("RKneePitch")]},
                                                          {"imu_x", at.imu.x()},
                                                          {"imu_y", at.imu.y()},
                                                          {"com_x", at.com.x()},
                                                          {"com_y", at.com.y()}};
  for (const auto& [name, value] : names) {
    INFO(name);
    const Effect effect = bench.effect(R"json({"name": "own", "at": "*", "unknowns": {"a": {"unit": "1", "sigma": 1}},
      "correction": "a*)json" + name + "\"}");
    CHECK(bench.correction(effect, 3, {2}) == Approx(2 * value));
    CHECK(effect.drivers.size() + effect.remoteDrivers.size() == 1);
    CHECK_FALSE(effect.onlyAtMotor);
  }
}

TEST_CASE("a correction is one value and assigns nothing") {
  // Proves the sentences with their positions for what muParser accepts beyond one value, wherever it stands; commas
  // between a function's arguments and all comparisons remain.
  using Catch::Contains;
  const Bench bench;
  const std::string whole = "a*sin(3*q) + b*abs(tau)";
  const auto several = [&](const std::string& text, std::size_t letter) {
    CAPTURE(text);
    CHECK_THAT(bench.refusal(whole, text),
               Contains(fmt::format("several values, separated by a comma; add them (at letter {})", letter)));
  };
  const auto assigns = [&](const std::string& text, std::size_t letter) {
    CAPTURE(text);
    CHECK_THAT(bench.refusal(whole, text),
               Contains(fmt::format("= assigns a value; compare with == (at letter {})", letter)));
  };
  several("a,a", 2);
  several("max(a,b), b", 9);
  several(",a", 1);
  assigns("a*q + 0*(q=1)", 11);
  assigns("q=a", 2);
  assigns("a*(q==1) + 0*(b=1)", 16);
  for (const char* text : {"a*max(0, q)", "a*min(max(0,q),1)", "a*(q>=0.1)*(q<=1) + b*(q!=0)*(q==q)", "(a + b)*q"}) {
    CAPTURE(text);
    CHECK(bench.refusal(whole, text) == "accepted");
  }
  for (const char* text : {"(a,a)", "a*(q,1)", "a===1", "a*(q=>1)", ",", "=", "a,"}) {
    CAPTURE(text);
    CHECK(bench.refusal(whole, text) != "accepted");
  }
}

TEST_CASE("what is wrong with a person's effect is said with its place and what is near") {
  // Proves the message of each refusal; all are InputErrors.
  using Catch::Contains;
  const Bench bench;
  CHECK_THAT(bench.refusal("tau", "taw"), Contains("'taw'") && Contains("tau") && Contains("correction"));
  CHECK_THAT(bench.refusal("\"rad\"", "\"deg\""), Contains("unknowns.a.unit") && Contains("rad"));
  CHECK_THAT(bench.refusal("0.01", "0"), Contains("unknowns.a.sigma") && Contains("above 0"));
  CHECK_THAT(bench.refusal("0.01", "-1"), Contains("unknowns.a.sigma"));
  CHECK_THAT(bench.refusal("LKneePitch", "LKnee"), Contains("LKneePitch") && Contains("at:"));
  CHECK_THAT(bench.refusal("sin(3*q)", "sin(3*q"), Contains("at letter"));
  CHECK_THAT(bench.refusal("sin(3*q)", "sinn(3*q)"),
             Contains("\"sinn\" is no function; near it are") && Contains(" sin, "));
  CHECK_THAT(bench.refusal("sin(3*q)", "q(3)"), Contains("\"q\" is no function"));
  CHECK_THAT(bench.refusal("a*sin", "0.1 + a*sin"), Contains("0 where its unknowns are 0"));
  CHECK_THAT(bench.refusal("\"a\":", "\"q\":"), Contains("already stands for something else"));
  const nlohmann::json twice = nlohmann::json::array({parseJson(cable, ""), parseJson(cable, "")});
  CHECK_THROWS_WITH(parseUserEffects(JsonCursor{twice, "model.json"}, bench.robot), Contains("no other effect"));
  nlohmann::json builtIn = parseJson(cable, "");
  builtIn["name"] = "backlash";
  const nlohmann::json list = nlohmann::json::array({builtIn});
  CHECK_THROWS_WITH(parseUserEffects(JsonCursor{list, "model.json"}, bench.robot), Contains("no other effect"));
}

} // namespace naocal
