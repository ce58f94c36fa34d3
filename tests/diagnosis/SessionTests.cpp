#include "diagnosis/Session.hpp"

#include "TemporaryFolder.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace naocal;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

/// Two models: the first with test results, the second without.
Session twoModels() {
  SelectionStep step{.rmsPx = 0.52, .noiseFloorPx = 0.31};
  step.heldOutPx = 0.55;
  step.alarm = 0.005;
  Session session;
  session.ladder.push_back({.without = {"jointOffset@HeadYaw"}, .rmsPx = 0.52, .questioned = step});
  session.ladder.push_back({.with = {"spring@LKneePitch"},
                            .definitions = R"([{"name":"spring"}])",
                            .step = "+ spring@LKneePitch",
                            .from = 0,
                            .rmsPx = 0.33});
  session.at = 1;
  session.inputs = {{"captures"}, {"abc"}};
  return session;
}

} // namespace

TEST_CASE("a session is read as it was written") {
  // Proves the round trip of all members, for a rung with and one without test results.
  const TemporaryFolder folder;
  const auto file = folder.path() / "session.json";
  const Session written = twoModels();
  writeAtomically(file, sessionJson(written).dump());
  const Session read = readSession(file);
  CHECK(sessionJson(read) == sessionJson(written));
  REQUIRE(read.ladder.size() == 2);
  CHECK(read.ladder[0].without == written.ladder[0].without);
  CHECK(read.ladder[0].questioned->heldOutPx == 0.55);
  CHECK(read.ladder[0].questioned->noiseFloorPx == 0.31);
  CHECK(read.ladder[0].questioned->alarm == 0.005);
  CHECK_FALSE(read.ladder[0].from);
  CHECK(read.ladder[1].with == written.ladder[1].with);
  CHECK(read.ladder[1].definitions == written.ladder[1].definitions);
  CHECK(read.ladder[1].step == "+ spring@LKneePitch");
  CHECK(read.ladder[1].from == 0U);
  CHECK(read.ladder[1].rmsPx == 0.33);
  CHECK_FALSE(read.ladder[1].questioned);
  CHECK(read.at == 1);
}

TEST_CASE("a session that cannot be gone on from is refused with its place") {
  // Proves the refusal of a rung derived from itself or a later one, of a present rung that does not exist, of wrong
  // types, of an empty ladder, and of other captures.
  const TemporaryFolder folder;
  const auto file = folder.path() / "session.json";
  const auto refused = [&](const char* pointer, const Json& value, const char* sentence) {
    Json json = sessionJson(twoModels());
    json[Json::json_pointer{pointer}] = value;
    writeAtomically(file, json.dump());
    CHECK_THROWS_WITH(readSession(file), Contains("session.json") && Contains(sentence));
  };
  refused("/ladder/1/from", 1, "ladder[1].from");
  refused("/ladder/0/from", 0, "ladder[0].from");
  refused("/ladder/1/with", 3, "ladder[1].with");
  refused("/ladder/1/define", "spring", "ladder[1].define");
  refused("/ladder/0/alarm", 3, "ladder[0].alarm");
  refused("/ladder", Json::array(), "at least the model to begin with");
  refused("/at", 2, "at");
  refused("/format", "naocal-result", "format");
  CHECK_NOTHROW(requireSameCaptures(twoModels(), {{"elsewhere/captures"}, {"abc"}}, file));
  CHECK_THROWS_WITH(requireSameCaptures(twoModels(), {{"captures"}, {"abd"}}, file),
                    Contains("expected a session of these captures"));
}

TEST_CASE("a changed model comes last and names its origin, and every model that was tried stays") {
  // Proves add, drop, undo, redo and goTo on the history alone: undone models are kept, and a further change starts a
  // branch.
  Session session;
  session.ladder.push_back({.rmsPx = 0.5, .questioned = SelectionStep{}});
  const auto base = [] { return std::vector<std::string>{"jointOffset@HeadYaw"}; };
  session.add({"elasticity@LKneePitch"}, base);
  CHECK(session.current().with == std::vector<std::string>{"elasticity@LKneePitch"});
  CHECK(session.current().step == "+ elasticity@LKneePitch");
  CHECK_FALSE(session.current().questioned); // results belong to the previous model
  session.undo();
  CHECK(session.at == 0);
  session.add({"backlash@LKneePitch"}, base);
  CHECK(session.at == 2);
  CHECK(session.ladder[2].from == 0U);
  CHECK(session.ladder[1].with == std::vector<std::string>{"elasticity@LKneePitch"});
  session.drop("backlash@LKneePitch", base);
  CHECK(session.ladder[3].from == 2U);
  CHECK(session.current().with.empty());
  session.goTo(1);
  CHECK(session.at == 1);
  CHECK(session.ladder.size() == 4);
  CHECK_THROWS_WITH(session.redo(), Contains("nothing to redo"));
  session.goTo(0);
  session.redo(); // the newest of the two that were made from it
  CHECK(session.at == 2);
}

TEST_CASE("an effect of the base model can be dropped and added again, and nothing is in a model twice") {
  // Proves the refusals, which leave the session unchanged, and that restoring a base effect is not recorded as an
  // addition.
  Session session;
  session.ladder.emplace_back();
  const auto base = [] { return std::vector<std::string>{"jointOffset@HeadYaw"}; };
  CHECK_THROWS_WITH(session.add({"jointOffset@HeadYaw"}, base), Contains("is in the model already"));
  CHECK_THROWS_WITH(session.drop("elasticity@LKneePitch", base), Contains("it has no more than the base"));
  CHECK_THROWS_WITH(session.undo(), Contains("nothing to undo"));
  CHECK_THROWS_AS(session.goTo(1), InputError);
  CHECK(session.ladder.size() == 1);
  session.drop("jointOffset@HeadYaw", base);
  CHECK(session.current().without == base());
  session.add({"jointOffset@HeadYaw"}, [] { return std::vector<std::string>{}; });
  CHECK(session.current().without.empty());
  CHECK(session.current().with.empty());
  session.add({"elasticity@*"}, base);
  CHECK_THROWS_AS(session.add({"elasticity@*"}, base), InputError); // a pattern; no term has this label
  session.add({"backlash@LKneePitch", "focalLength@top"}, base);    // one revision
  CHECK(session.current().step == "+ backlash@LKneePitch, focalLength@top");
  CHECK(session.current().with == std::vector<std::string>{"elasticity@*", "backlash@LKneePitch", "focalLength@top"});
  session.undo();

  const auto broken = []() -> std::vector<std::string> { throw InputError{"there is no such model"}; };
  session.drop("elasticity@*", broken); // dropping works although the model cannot be built
  CHECK(session.current().with.empty());
  CHECK_THROWS_WITH(session.add({"elasticity@LKneePitch"}, broken), Contains("no such model"));
}
