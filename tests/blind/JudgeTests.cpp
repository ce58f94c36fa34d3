#include "TemporaryFolder.hpp"
#include "judge/Tally.hpp"
#include "seal/Seal.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace blind {
namespace {

using nlohmann::json;

json knee(double noncentrality) {
  return {{"effect", "elasticity"},
          {"at", "LKneePitch"},
          {"unknowns", {{"c", {{"value", 0.006}, {"unit", "rad/Nm"}}}}},
          {"noncentrality", noncentrality},
          {"kept", 0.4}};
}

json truthOf(const std::string& set, const std::string& group, json effects) {
  return {{"set", set},        {"group", group}, {"kind", ""},         {"noise", "clean"},    {"poses", 20},
          {"pictures", false}, {"wanted", 40},   {"effects", effects}, {"lockedFloorPx", 0.5}};
}

json diagnosis(const std::string& verdict) {
  return {{"verdict", verdict}, {"ranking", json::array()}, {"suggested", json::array()}, {"drivers", json::array()}};
}

/// A benchmark's folder with hand-made truths and answers.
class Bench {
public:
  void add(const json& truth, const json& said, json locked = json::object()) {
    const std::string set = truth.at("set");
    const std::string bytes = sealed(truth.dump(), "key");
    writeFile(path() / "truth" / "key", "key");
    writeFile(path() / "truth" / (set + ".sealed"), bytes);
    writeFile(path() / "manifest" / (set + ".json"), json{{"truthSha256", sha256Hex(bytes)}}.dump());
    writeFile(
        path() / "answers" / (set + ".json"),
        json{{"set", set}, {"truthSha256", sha256Hex(bytes)}, {"exitCode", 0}, {"locked", locked}, {"diagnosis", said}}
            .dump());
  }
  Marks marked() const { return marks(readCases(path()).front()); }
  const std::filesystem::path& path() const { return folder_.path(); }

private:
  naocal::TemporaryFolder folder_;
};

json candidate(const std::string& effect, const std::string& at, std::vector<std::string> equivalent = {}) {
  return {{"effect", effect}, {"at", at}, {"state", "present"}, {"equivalent", equivalent}};
}

} // namespace

TEST_CASE("a truth that was changed after sealing is refused, and so is an answer to another one") {
  // Proves that neither truths nor answers can be exchanged unnoticed once the hash is published.
  Bench bench;
  bench.add(truthOf("s1", "control", json::array()), diagnosis("adequate"));
  CHECK(readCases(bench.path()).size() == 1);
  SECTION("truth") {
    std::string bytes = readFile(bench.path() / "truth" / "s1.sealed");
    bytes[10] = static_cast<char>(bytes[10] ^ 1);
    writeFile(bench.path() / "truth" / "s1.sealed", bytes);
    CHECK_THROWS_WITH(readCases(bench.path()), Catch::Contains("not the one that was sealed"));
  }
  SECTION("answer") {
    json answer = json::parse(readFile(bench.path() / "answers" / "s1.json"));
    answer["truthSha256"] = "0";
    writeFile(bench.path() / "answers" / "s1.json", answer.dump());
    CHECK_THROWS_WITH(readCases(bench.path()), Catch::Contains("another sealed truth"));
  }
}

TEST_CASE("sealing hides the text and opening brings it back") {
  // Proves the round trip over several blocks; it is a seal against changing, not against reading.
  const std::string text(100, 'a');
  const std::string bytes = sealed(text, "key");
  CHECK(bytes.find("aa") == bytes.npos);
  CHECK(opened(bytes, "key") == text);
  CHECK(opened(bytes, "other") != text);
}

TEST_CASE("an answer is right in class when its first candidate cannot be told from the truth") {
  // Proves the marks for naming: first, first three, class, and the interval of the size.
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
  // Proves that the marks can be bad.
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
  // Proves that neither an answer of the wrong kind nor a calibration that failed makes a figure look better.
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
  // Proves that one suggestion does not stand for two effects, and that extras are counted.
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
}

TEST_CASE("outside the catalogue the word, the joint and the driver must be right") {
  // Proves all three, and that a joint's own angle has two names.
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

TEST_CASE("theory's power follows the noncentral chi-square of a corrected test") {
  // Proves it against published values: 75 candidates, one unknown.
  CHECK(theoreticalPower(20, 1, 75) == Approx(0.87).margin(0.015));
  CHECK(theoreticalPower(40, 2, 75) == Approx(0.995).margin(0.01));
  CHECK(theoreticalPower(0, 1, 1) == Approx(0.05));
}

TEST_CASE("a tally of controls counts alarms by regime with a band") {
  // Proves pooling and the band's ends: 1 of 4 lies within 0.6 and 80.6 %.
  Bench bench;
  for (int i = 0; i < 4; ++i) {
    bench.add(truthOf("s" + std::to_string(i), "control", json::array()),
              diagnosis(i == 0 ? "unknown-effect" : "adequate"));
  }
  const Tally counted = tally(readCases(bench.path()));
  const Share& clean = counted.falseAlarms.at("clean");
  CHECK(clean.rate() == 0.25);
  CHECK(clean.low() == Approx(0.0063).margin(1e-3));
  CHECK(clean.high() == Approx(0.8059).margin(1e-3));
  CHECK(evaluationJson(counted).at("falseAlarms").at("clean").at("sets") == 4);
  CHECK_FALSE(requiredFigures(counted).front().met);
}

} // namespace blind
