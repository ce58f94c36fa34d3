#include "blind/Bench.hpp"

#include <catch2/catch.hpp>

namespace blind {

TEST_CASE("an answer is right in class when its first candidate cannot be told from the truth") {
  // Proves the marks for naming (first, first three, equivalence class), for the interval of the size, and for the
  // error after adding the suggestion.
  json said = diagnosis("effect-missing");
  said["ranking"] = {candidate("backlash", "LKneePitch", {"elasticity@LKneePitch"}),
                     candidate("elasticity", "LKneePitch")};
  said["ranking"][1]["unknowns"] = {{"c", {{"value", 0.0066}, {"sigma", 0.0004}}}};
  said["suggested"] = json::array({"backlash@LKneePitch"});
  Bench bench;
  bench.add(truthOf("s1", "catalogue", json::array({knee(40)})), said, {{"beforePx", 0.8}, {"afterPx", 0.54}});
  const Marks marked = bench.marked();
  CHECK(marked.detected == true);
  CHECK(marked.top1 == false);
  CHECK(marked.top3 == true);
  CHECK(marked.inClass == true);
  CHECK(marked.covered == std::vector<bool>{true});
  CHECK(marked.errorFell == true);
  CHECK(marked.nearFloor == true);
}

TEST_CASE("a wrong name, a wide miss of the size and a risen error count as such") {
  // Proves that each of these marks can be negative.
  json said = diagnosis("effect-missing");
  said["ranking"] = {candidate("focalLength", "top"), candidate("elasticity", "LKneePitch")};
  said["ranking"][1]["unknowns"] = {{"c", {{"value", 0.008}, {"sigma", 0.0004}}}};
  said["suggested"] = json::array({"focalLength@top"});
  Bench bench;
  bench.add(truthOf("s1", "catalogue", json::array({knee(40)})), said, {{"beforePx", 0.8}, {"afterPx", 0.81}});
  const Marks marked = bench.marked();
  CHECK(marked.inClass == false);
  CHECK(marked.covered == std::vector<bool>{false});
  CHECK(marked.errorFell == false);
  CHECK(marked.nearFloor == false);
}

TEST_CASE("sound captures that are called bad are no detection, and a suggestion that cannot be tried lowers nothing") {
  // Proves that neither the wrong verdict nor a failed calibration with the suggestion improves a mark.
  json said = diagnosis("bad-captures");
  Bench bench;
  bench.add(truthOf("s1", "catalogue", json::array({knee(40)})), said);
  CHECK(bench.marked().alarmed);
  CHECK(bench.marked().detected == false);
  CHECK(!bench.marked().errorFell);
  said["suggested"] = json::array({"elasticity@LKneePitch"});
  bench.add(truthOf("s1", "catalogue", json::array({knee(40)})), said);
  CHECK(bench.marked().errorFell == false);
  CHECK(bench.marked().nearFloor == false);
}

TEST_CASE("two hidden effects ask for two suggestions and count further ones") {
  // Proves that one suggestion does not count for two effects, that extra suggestions are counted, and that an effect
  // ranked as trivial needs no suggestion.
  json second = knee(40);
  second["effect"] = "focalLength";
  second["at"] = "top";
  json said = diagnosis("effect-missing");
  said["suggested"] = json::array({"elasticity@LKneePitch", "hysteresis@HeadYaw"});
  Bench bench;
  bench.add(truthOf("s1", "pair", {knee(40), second}), said);
  CHECK(bench.marked().bothFound == false);
  CHECK(bench.marked().extra == 1);
  said["suggested"] = json::array({"elasticity@LKneePitch", "focalLength@top"});
  bench.add(truthOf("s1", "pair", {knee(40), second}), said);
  CHECK(bench.marked().bothFound == true);
  CHECK(bench.marked().extra == 0);
  said["suggested"] = json::array({"elasticity@LKneePitch"});
  said["ranking"].push_back({{"effect", "focalLength"}, {"at", "top"}, {"state", "trivial"}});
  bench.add(truthOf("s1", "pair", {knee(40), second}), said);
  CHECK(bench.marked().bothFound == true); // reported as trivial
}

TEST_CASE("outside the catalogue the word, the joint and the driver must be right") {
  // Proves that verdict, joint and driver are all required, and that "q" and the joint's name denote the same driver.
  json ripple = knee(40);
  ripple["effect"] = "kneeRipple";
  ripple["drivers"] = json::array({"q"});
  json said = diagnosis("unknown-effect");
  const auto marked = [&](const std::string& at, const std::string& driver) {
    said["drivers"] = json::array({{{"at", at}, {"driver", driver}}});
    Bench bench;
    bench.add(truthOf("s1", "outside", json::array({ripple})), said);
    return *bench.marked().placeAndDriver;
  };
  CHECK(marked("LKneePitch", "q"));
  CHECK(marked("LKneePitch", "LKneePitch"));
  CHECK_FALSE(marked("LKneePitch", "t"));
  CHECK_FALSE(marked("LHipPitch", "q"));
  said["verdict"] = "effect-missing";
  CHECK_FALSE(marked("LKneePitch", "q"));
}

TEST_CASE("offsets count by the intervals and bounds that people see") {
  // Proves the marks for offsets: beyond the bound and coverage, before and after adding the suggestions; averages take
  // precedence; unlearned offsets do not count; rms relative to the fit with fixed noise.
  json truth = truthOf("s1", "catalogue", json::array({knee(40)}));
  truth["offsets"] = {{"LKneePitch", 0.01}, {"LHipPitch", 0.02}};
  json said = diagnosis("effect-missing");
  said["suggested"] = json::array({"elasticity@LKneePitch", "focalLength@top"});
  json solved{{"solved", solvedKnee(0.014, 0.001)},
              {"solvedWithSuggested", solvedKnee(0.0115, 0.001)},
              {"solvedWithFixedNoise", solvedKnee(0.01, 0.001)}};
  solved["solvedWithFixedNoise"]["rmsPx"] = 0.5;
  const auto marked = [&] {
    Bench bench;
    bench.add(truth, said, json::object(), solved);
    return bench.marked();
  };
  CHECK(marked().given.usableBeyond == true);
  CHECK(marked().given.inside == std::vector<bool>{false});
  CHECK(marked().given.widths.at(0) == Approx(1)); // without a bound: 3.5 sigma
  CHECK(marked().added.usableBeyond == false);
  CHECK(marked().added.inside == std::vector<bool>{true});
  CHECK(*marked().rmsRatio == Approx(1.2));
  CHECK(marked().extraNamed == true);
  solved["solved"]["effects"][0]["unknowns"]["o"]["averaged"] = {
      {"value", 0.0125}, {"sigma", 0.0005}, {"interval", {0.009, 0.018}}, {"bound", {0.0095, 0.02}}};
  CHECK(marked().given.inside == std::vector<bool>{true});
  CHECK(marked().given.usableBeyond == false); // 5 sigmas off, but within the bound
  CHECK(marked().given.widths.at(0) == Approx(3));
  solved["solved"] = solvedKnee(0.014, 0.001, false);
  CHECK_FALSE(marked().given.usableBeyond.has_value());
  CHECK(marked().given.beyond == true);
  solved["solved"]["effects"][0]["unknowns"]["o"]["learned"] = 0.1;
  CHECK(marked().given.inside.empty());
}

TEST_CASE("an event counts as timed between the readings around it, by words or by a number") {
  // Proves the sentences and numbers that count as naming a board, a stance and a joint; a wrong time or another board
  // does not count.
  const auto marked = [](const std::string& what, const std::string& at, json said) {
    json truth = truthOf("s1", "event", json::array());
    truth["event"] = {{"what", what}, {"at", at}, {"before", 40.0}, {"after", 47.5}};
    Bench bench;
    bench.add(truth, std::move(said));
    return std::pair{*bench.marked().eventNamed, *bench.marked().eventTimed};
  };
  json said = diagnosis("bad-captures");
  said["suspicious"] = {{{"why", "board B moved 43.2 s after the first capture"}}};
  CHECK(marked("kicked board", "B", said) == std::pair{true, true});
  CHECK(marked("kicked board", "A", said) == std::pair{false, false});
  CHECK(marked("slipped robot", "0", said) == std::pair{false, false});
  said["suspicious"] = {{{"why", "the robot in stance 0 moved 50.2 s after the first capture"}}};
  CHECK(marked("slipped robot", "0", said) == std::pair{true, false});
  said["suspicious"] = {{{"why", "LKneePitch stands otherwise from some time on"}, {"time", 44}}};
  CHECK(marked("offset step", "LKneePitch", said) == std::pair{true, true});
  said = diagnosis("unknown-effect");
  said["drivers"] = {{{"at", "LKneePitch"}, {"driver", "t"}, {"expression", "a*(t > 41.3 ? 1 : 0)"}}};
  CHECK(marked("offset step", "LKneePitch", said) == std::pair{true, true});
  said["drivers"][0]["expression"] = "a*t";
  CHECK(marked("offset step", "LKneePitch", said) == std::pair{true, false});
}

TEST_CASE("readings that jitter are adequate, with their level in the result, and a spring is an elasticity") {
  // Proves that a level within 20 % counts and one too high or missing does not (one too low is not tested), and that
  // a spring counts as the elasticity of its motor.
  json truth = truthOf("s1", "jitter", json::array());
  truth["jitter"] = 0.0011;
  const auto level = [&](json solved) {
    Bench bench;
    bench.add(truth, diagnosis("adequate"), json::object(), {{"solved", std::move(solved)}});
    CHECK(bench.marked().jitterAdequate == true);
    return *bench.marked().jitterLevel;
  };
  json solved = solvedKnee(0, 1);
  CHECK(level(solved));
  solved["noise"]["jitter"] = 0.0014;
  CHECK_FALSE(level(solved));
  solved["noise"].erase("jitter");
  CHECK_FALSE(level(solved));
  CHECK(canonicalMotor("spring@RHipYawPitch") == "elasticity@LHipYawPitch");
}

TEST_CASE("theory's power follows the noncentral chi-square of a corrected test") {
  // Compares with published power: 75 candidates, one and two unknowns; with lambda = 0 the power is the level, 5 %.
  CHECK(theoreticalPower(20, 1, 75) == Approx(0.87).margin(0.015));
  CHECK(theoreticalPower(40, 2, 75) == Approx(0.995).margin(0.01));
  CHECK(theoreticalPower(0, 1, 1) == Approx(0.05));
}

} // namespace blind
