#include "blind/Bench.hpp"

#include <catch2/catch.hpp>

namespace blind {
namespace {

json machineTruth(const std::string& set, const std::string& group, const std::string& kind) {
  json truth = truthOf(set, group, json::array());
  truth.update({{"machine", true}, {"noise", "wrist camera"}, {"kind", kind}});
  return truth;
}

json suspecting(json entry) {
  json said = diagnosis("bad-captures");
  said["suspicious"] = json::array({std::move(entry)});
  return said;
}

} // namespace

TEST_CASE("a wrong set-up is named when its label stands first") {
  // Proves both outcomes.
  json truth = machineTruth("s1", "setup", "reversedJoint");
  truth["setUp"] = "reversedJoint@joint4";
  for (const char* said : {"reversedJoint@joint4", "reversedJoint@joint3"}) {
    Bench bench;
    bench.add(truth, suspecting({{"setUp", said}, {"why", "it turns the other way"}}));
    CHECK(bench.marked().culpritNamed == (std::string{said} == "reversedJoint@joint4"));
  }
}

TEST_CASE("a bad reading is named by its capture, unless an effect is suggested as well") {
  // Proves the three outcomes.
  json truth = machineTruth("s1", "reading", "bad reading");
  truth["badCapture"] = 7;
  const auto named = [&](int capture, std::vector<std::string> suggested) {
    json said = suspecting({{"capture", capture}, {"why", "does not belong to the rest"}});
    said["suggested"] = suggested;
    Bench bench;
    bench.add(truth, said);
    return *bench.marked().culpritNamed;
  };
  CHECK(named(7, {}));
  CHECK_FALSE(named(8, {}));
  CHECK_FALSE(named(7, {"encoderGain@joint2"}));
}

TEST_CASE("what moved beside a machine is named by its id and timed by the first capture after it") {
  // Proves that both are judged on their own.
  json truth = machineTruth("s1", "event", "moved");
  truth["event"] = {{"what", "moved board"}, {"at", "board"}, {"before", 50}, {"after", 60}, {"from", 12}};
  for (const int from : {12, 13}) {
    Bench bench;
    bench.add(truth, suspecting({{"moved", "board"}, {"from", from}, {"why", "board board moved"}}));
    CHECK(bench.marked().eventNamed == true);
    CHECK(bench.marked().eventTimed == (from == 12));
  }
}

TEST_CASE("an effect of a machine that is said to be trivial counts as detected, of the right name only") {
  // Proves that negligible effects are judged by their name, where the verdict need not ask for them.
  for (const char* first : {"LKneePitch", "LHipPitch"}) {
    json truth = machineTruth("s1", "catalogue", "elasticity");
    truth["effects"] = json::array({knee(40)});
    json said = diagnosis("adequate");
    said["ranking"] = json::array({candidate("elasticity", first)});
    said["ranking"][0]["state"] = "trivial";
    Bench bench;
    bench.add(truth, said);
    CHECK(bench.marked().detected == (std::string{first} == "LKneePitch"));
  }
}

TEST_CASE("a benchmark of machines has its own figures, by how they are measured") {
  // Proves that alarms and unexplained misfits of controls are counted by kind of measurement.
  Bench bench;
  bench.add(machineTruth("s1", "control", ""), diagnosis("inconclusive"));
  bench.add(machineTruth("s2", "control", ""), diagnosis("bad-captures"));
  const Tally tally = tallyCases(readCases(bench.path()));
  CHECK(tally.machines);
  CHECK(tally.falseAlarms.at("wrist camera").rate() == 0.5);
  CHECK(tally.misfitSaid.at("wrist camera").rate() == 0.5);
  CHECK(requiredFigures(tally).front().what == "false alarms on controls, wrist camera");
}

} // namespace blind
