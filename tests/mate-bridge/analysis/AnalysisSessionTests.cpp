#include "analysis/AnalysisSession.hpp"

#include "TemporaryFolder.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>

using namespace naocal;
using Json = nlohmann::json;

namespace {

/// Captures of a simulated robot with a hidden effect, and the effect's label.
struct FlawedSet {
  FlawedSet() {
    const Robot robot = loadRobot(configurationDirectory(), "V6");
    SimulationPlan plan;
    plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 14, 1);
    plan.samples = 2;
    plan.repeatKind = RepeatKind::reapproach;
    plan.hiddenFlaw = true;
    const Simulation simulation = simulate(robot, plan, 1);
    writeCaptureSet(simulation.set, folder.path() / "flawed");
    for (const TrueEffect& effect : simulation.truth.effects) {
      if (effect.effect != "jointOffset" && effect.effect != "cameraRotation") {
        flaw = effect.effect + "@" + effect.at;
      }
    }
  }
  TemporaryFolder folder;
  std::string flaw;
};

/// The same captures without motor currents.
Dataset withoutCurrents(Dataset opened) {
  for (CaptureSet& set : opened.sets) {
    for (Capture& capture : set.captures) {
      capture.joints.current.clear();
    }
  }
  return opened;
}

/// A session and its last message of each kind.
struct Bench {
  FlawedSet set;
  std::map<std::string, Json> told;
  AnalysisSession session{withoutCurrents(openDataset({(set.folder.path() / "flawed").string()})),
                          [this](const std::string& kind, const Json& content) { told[kind] = content; }};
};

} // namespace

TEST_CASE("adding what is missing lets the error on unseen poses fall to the noise, and going back brings it back",
          "[slow]") {
  // Proves a user's loop: held-out errors before and after adding a hidden effect. That the effect is found is tested
  // with the diagnosis.
  Bench bench;
  REQUIRE_FALSE(bench.set.flaw.empty());
  bench.session.fit();
  bench.session.search();
  const Json before = bench.told["ladder"]["rungs"][0];
  CHECK(bench.told["diagnosis"]["candidates"][0]["label"] == bench.set.flaw);

  bench.session.add({bench.set.flaw});
  CHECK(bench.told["fit"]["with"] == Json::array({bench.set.flaw}));
  bench.session.search();
  const Json after = bench.told["ladder"]["rungs"][1];
  CHECK(after["heldOut"] < 0.7 * before["heldOut"].get<double>());
  CHECK(after["heldOut"] < 1.3 * after["floor"].get<double>());

  bench.session.goTo(0);
  CHECK(bench.told["fit"]["rms"] == before["rms"]);
  CHECK(bench.told["ladder"]["at"] == 0);
  CHECK(bench.told["ladder"]["rungs"].size() == 2);
}

TEST_CASE("an own effect is fitted like the built-in ones, and a broken one changes nothing", "[slow]") {
  // Proves defineEffect and its refusals; valid expressions are tested with the effects.
  Bench bench;
  bench.session.fit();
  const Json fit = bench.told["fit"];
  Json effect{{"name", "softness"},
              {"at", "LKneePitch"},
              {"correction", "a*tau"},
              {"unknowns", {{"a", {{"unit", "rad/Nm"}, {"sigma", 0.01}}}}}};
  Json broken = effect;
  broken["correction"] = "a*tua";
  CHECK_THROWS_AS(bench.session.defineEffect(broken), InputError);
  CHECK(bench.told["ladder"]["rungs"].size() == 1);
  bench.session.defineEffect(effect);
  CHECK(bench.told["fit"]["with"] == Json::array({"softness@LKneePitch"}));
  CHECK(bench.told["fit"]["rms"] < fit["rms"]);
  CHECK(bench.told["set"]["own"][0] == effect);
}

TEST_CASE("an own effect that is changed can be taken back, and one for every joint is asked for", "[slow]") {
  // Proves that a changed definition belongs to its revision, that goTo restores the former one, and that an effect at
  // every joint appears among the candidates. A refused definition changes nothing.
  Bench bench;
  bench.session.fit();
  Json effect{{"name", "softness"},
              {"at", "LKneePitch"},
              {"correction", "a*tau"},
              {"unknowns", {{"a", {{"unit", "rad/Nm"}, {"sigma", 0.01}}}}}};
  bench.session.defineEffect(effect);
  const Json before = bench.told["fit"]["rms"];
  effect["correction"] = "a*sin(q)";
  effect["unknowns"]["a"]["unit"] = "rad";
  bench.session.defineEffect(effect);
  CHECK(bench.told["set"]["own"][0]["correction"] == "a*sin(q)");
  CHECK(bench.told["fit"]["rms"] != before);
  Json broken = effect;
  broken["correction"] = "a*current"; // not recorded
  CHECK_THROWS_AS(bench.session.defineEffect(broken), InputError);
  CHECK(bench.told["set"]["own"][0]["correction"] == "a*sin(q)");
  CHECK(bench.told["ladder"]["rungs"].size() == 3);
  bench.session.goTo(1);
  CHECK(bench.told["set"]["own"][0]["correction"] == "a*tau");
  CHECK(bench.told["fit"]["rms"] == before);

  effect["name"] = "anywhere";
  effect["at"] = "*";
  bench.session.search();
  bench.session.defineEffect(effect);
  bench.session.search();
  const Json& candidates = bench.told["diagnosis"]["candidates"];
  CHECK(std::any_of(candidates.begin(), candidates.end(),
                    [](const Json& one) { return one["label"].get<std::string>().starts_with("anywhere@"); }));
}

TEST_CASE("what is set on a robot is what its own calibration would set", "[slow]") {
  // Proves that poorly determined offsets are excluded, that the others are those of the fit, and that every
  // camera's mount is complete.
  Bench bench;
  bench.session.fit();
  const Json compensation = bench.told["fit"]["compensation"];
  std::map<std::string, Json> rows;
  for (const Json& group : bench.told["fit"]["groups"]) {
    for (const Json& row : group["rows"]) {
      rows[group["title"].get<std::string>() + " " + row["name"].get<std::string>()] = row;
    }
  }
  CHECK(compensation["offsets"].size() > 5);
  for (const Json& offset : compensation["offsets"]) {
    const Json& row = rows.at("joint offset " + offset["joint"].get<std::string>());
    CHECK(row["learned"] >= 0.5);
    CHECK(offset["value"].get<double>() == Approx(row["fitted"].get<double>()));
  }
  for (const Json& joint : compensation["untold"]) {
    CHECK(rows.at("joint offset " + joint.get<std::string>())["learned"] < 0.5);
  }
  REQUIRE(compensation["mounts"].size() == 2);
  CHECK(compensation["mounts"][0]["rotation"].size() == 3);
}

TEST_CASE("of a broken expression the place is told") {
  // Proves the reported position for syntax errors and unknown names, and that an effect that cannot be added is
  // refused when checked.
  const Bench bench;
  const auto checked = [&](const std::string& correction, const std::string& name = "mine") {
    return bench.session.checkEffect({{"name", name},
                                      {"at", "LKneePitch"},
                                      {"correction", correction},
                                      {"unknowns", {{"a", {{"unit", "rad"}, {"sigma", 0.01}}}}}});
  };
  CHECK(checked("a*sin(3*q)") == Json{{"ok", true}});
  CHECK(checked("a*sin(3*q) + a*tua")["letter"] == 15);
  CHECK(checked("a*aa + a*a")["letter"] == 2);
  CHECK(checked("a*sin(3*q")["letter"] == 9);
  CHECK_FALSE(checked("1 + a").contains("letter"));
  CHECK_THAT(checked("1 + a")["sentence"].get<std::string>(), Catch::Contains("is 0 where its unknowns are 0"));
  CHECK(checked("a*q", "elasticity")["ok"] == false); // name in use
  CHECK(checked("a*current")["ok"] == false);         // no currents recorded
}

TEST_CASE("a suspected set-up is mended like an effect is added, and taken back", "[slow]") {
  // Proves that the model and the result name the mended joint, that the error falls, that other captures are mended
  // before they are compared, that a session and a result that have it open with it, and that dropping it brings the
  // error back.
  FlawedSet flawed;
  const std::string folder = (flawed.folder.path() / "flawed").string(), mirrored = "reversedJoint@LHipRoll";
  Dataset opened = withoutCurrents(openDataset({folder}));
  const std::vector<std::string>& names = opened.sets.front().jointNames;
  const auto column = static_cast<std::size_t>(std::find(names.begin(), names.end(), "LHipRoll") - names.begin());
  for (Capture& capture : opened.sets.front().captures) {
    capture.joints.measured[column] *= -1;
  }
  std::map<std::string, Json> told;
  AnalysisSession session{opened, [&](const std::string& kind, const Json& content) { told[kind] = content; }};
  session.fit();
  const double before = told["fit"]["rms"];
  session.search();
  CHECK(told["diagnosis"]["candidates"][0]["label"] == mirrored);
  session.add({mirrored});
  const double after = told["fit"]["rms"];
  CHECK(after < 0.5 * before);
  const Json labels = told["fit"]["labels"];
  CHECK(std::count(labels.begin(), labels.end(), mirrored) == 1);
  CHECK_THROWS_AS(session.add({mirrored}), InputError);
  const Json result = Json::parse(session.generateFile("result.json"));
  CHECK(result["inputs"]["setUps"] == Json{mirrored});
  session.compareWith(opened);
  CHECK(told["compared"]["rmsPx"].get<double>() == Approx(after).epsilon(0.1));
  session.drop(mirrored);
  CHECK(told["fit"]["rms"].get<double>() == Approx(before).epsilon(0.01));

  const std::filesystem::path saved = flawed.folder.path() / "result.json";
  writeAtomically(saved, result.dump());
  Dataset again = openDataset({saved.string()});
  AnalysisSession{again, [&](const std::string& kind, const Json& content) { told[kind] = content; }}.fit();
  CHECK(told["fit"]["with"] == Json{mirrored});
}

TEST_CASE("what cannot be done is refused with a sentence and changes nothing", "[slow]") {
  // Proves the refusals of add, drop and goTo.
  Bench bench;
  bench.session.fit();
  CHECK_THROWS_AS(bench.session.add({"elasticity@LKneePitsch"}), InputError);
  CHECK_THROWS_AS(bench.session.drop("elasticity@LKneePitch"), InputError);
  CHECK_THROWS_AS(bench.session.goTo(1), InputError);
  CHECK(bench.told["ladder"]["rungs"].size() == 1);
  bench.session.drop("jointOffset@HeadYaw");
  CHECK(bench.told["fit"]["without"] == Json::array({"jointOffset@HeadYaw"}));
  bench.session.add({"jointOffset@HeadYaw"});
  CHECK(bench.told["fit"]["without"].empty());
}

TEST_CASE("another model that is tried from an earlier one leaves those between in the history", "[slow]") {
  // Proves the history's branches: all revisions are kept, and each names its origin.
  Bench bench;
  bench.session.fit();
  bench.session.add({"elasticity@LKneePitch"});
  bench.session.goTo(0);
  bench.session.add({"backlash@LKneePitch"});
  const Json& rungs = bench.told["ladder"]["rungs"];
  REQUIRE(rungs.size() == 3);
  CHECK(bench.told["ladder"]["at"] == 2);
  CHECK(rungs[0]["from"] == nullptr);
  CHECK(rungs[1]["with"] == Json::array({"elasticity@LKneePitch"}));
  CHECK(rungs[2]["with"] == Json::array({"backlash@LKneePitch"}));
  CHECK(rungs[2]["from"] == 0);
  CHECK_THROWS_AS(bench.session.add({"backlash@LKneePitch"}), InputError);
  CHECK_THROWS_AS(bench.session.add({"jointOffset@HeadYaw"}), InputError); // part of the base model
}

TEST_CASE("a search that is cancelled says nothing, and the next one finds what is missing", "[slow]") {
  // Proves that nothing is told of a search that did not end, and that a complete one names the effect, shows it first,
  // and leaves the model as it was.
  Bench bench;
  bench.session.fit();
  CHECK_THROWS_AS(bench.session.search([](std::size_t found) { return found == 0; }), SearchEnded);
  CHECK(bench.told.count("diagnosis") == 0);
  bench.session.search();
  const Json& diagnosis = bench.told["diagnosis"];
  CHECK(diagnosis["suggested"] == Json::array({bench.set.flaw}));
  REQUIRE_FALSE(diagnosis["causes"].empty());
  CHECK(diagnosis["causes"][0]["label"] == bench.set.flaw);
  CHECK(bench.told["ladder"]["rungs"].size() == 1);
}

TEST_CASE("what the panel saves is what the terminal reads", "[slow]") {
  // Proves that a result is opened with its model and a diagnosis with its captures, that a model file contains the
  // custom effect, and that reports are HTML pages; their content is tested with the report. The diagnosis' suggestions
  // are tested in DatasetTests.
  Bench bench;
  bench.session.fit();
  bench.session.defineEffect({{"name", "softness"},
                              {"at", "LKneePitch"},
                              {"correction", "a*tau"},
                              {"unknowns", {{"a", {{"unit", "rad/Nm"}, {"sigma", 0.01}}}}}});
  const std::filesystem::path folder = bench.set.folder.path();
  writeAtomically(folder / "result.json", bench.session.generateFile("result.json"));
  const Dataset again = openDataset({(folder / "result.json").string()});
  CHECK(std::count(again.terms.begin(), again.terms.end(), "softness@LKneePitch") == 1);
  CHECK(Json::parse(bench.session.generateFile("model.json"))["define"][0]["name"] == "softness");
  bench.session.goTo(0);
  bench.session.search();
  writeAtomically(folder / "diagnosis.json", bench.session.generateFile("diagnosis.json"));
  CHECK(openDataset({(folder / "diagnosis.json").string()}).sets.size() == 1);
  for (const char* const name : {"report.html", "diagnosis.html"}) {
    CHECK_THAT(bench.session.generateFile(name), Catch::StartsWith("<!doctype html>"));
  }
  CHECK_THROWS_WITH(bench.session.generateFile("poses.json"), Catch::Contains("ask for them first"));
  CHECK_THROWS_AS(bench.session.generateFile("passwords.txt"), InputError);
}

TEST_CASE("other captures are compared with the fit", "[slow]") {
  // Proves that comparing with the same captures gives the fit's error to within 20 %, and that the drawing alone is
  // worse.
  Bench bench;
  bench.session.fit();
  bench.session.compareWith(openDataset({(bench.set.folder.path() / "flawed").string()}));
  const Json compared = bench.told["compared"];
  CHECK(compared["rmsPx"].get<double>() == Approx(bench.told["fit"]["rms"].get<double>()).epsilon(0.2));
  CHECK(compared["nominal"]["rmsPx"].get<double>() > 3 * compared["rmsPx"].get<double>());
}

TEST_CASE("poses are proposed for what the model leaves open", "[slow]") {
  // Proves the number of poses, and that they have joint angles. Their usefulness is tested with the poses.
  Bench bench;
  bench.session.fit();
  bench.session.proposePoses(2);
  const Json next = bench.told["next"];
  REQUIRE(next["poses"].size() == 2);
  CHECK(next["poses"][0]["joints"].contains("LKneePitch"));
  CHECK(Json::parse(bench.session.generateFile("poses.json"))["poses"].size() == 2);
}
