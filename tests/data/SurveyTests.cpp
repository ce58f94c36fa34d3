#include "data/Breaks.hpp"
#include "data/CaptureSetFile.hpp"
#include "data/GoodSet.hpp"
#include "data/Refusal.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace naocal {
namespace {

using nlohmann::json;

bool isHeader(const Break& how) {
  return how.place == "/format" || how.place == "/version";
}

} // namespace

TEST_CASE("a survey lists first the very sentence that refuses the set") {
  // Proves for every modification of the table: reading on after a refusal follows the same rules as refusing.
  CHECK(surveyCaptureSet(goodSet().dump(), "some/captures.json").refusals.empty());
  for (const Break& how : breaks()) {
    if (isHeader(how)) {
      continue; // another format: nothing to survey
    }
    json document = goodSet();
    applyBreak(how, document);
    INFO(how.place << " = " << how.value);
    const auto refusals = surveyCaptureSet(document.dump(), "some/captures.json").refusals;
    REQUIRE_FALSE(refusals.empty());
    CHECK(refusals.front() == refusal(document.dump()));
  }
}

TEST_CASE("what is broken at several places is listed for each of them") {
  // Proves for pairs of modifications at unrelated places: both sentences are listed. The repeated id is a capture's of
  // its own, since sentences name captures by their ids.
  const std::vector<std::pair<std::string, std::string>> changes{
      {"/robot/bodyId", "17"},
      {"/jointNames/1", "\"Neck\""},
      {"/cameras/top/fx", "0"},
      {"/boards/1/squaresX", "1"},
      {"/stances/1/supportFoot", "\"hand\""},
      {"/captures/0/time", "\"noon\""},
      {"/captures/0/joints/measured/0", "\"NaN\""},
      {"/captures/0/joints/measured/1", "57.3"},
      {"/captures/0/corners/0/uv/0", "[-300, 20]"},
      {"/captures/1/repeat", "-1"},
      {"/captures/2/id", "0"},
      {"/captures/1/camera", "\"tip\""},
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    for (std::size_t k = i + 1; k < changes.size(); ++k) {
      const auto apply = [&](json& document, std::size_t change) {
        document[json::json_pointer{changes[change].first}] = json::parse(changes[change].second);
      };
      json one = goodSet(), other = goodSet(), both = goodSet();
      apply(one, i);
      apply(other, k);
      apply(both, i);
      apply(both, k);
      const auto refusals = surveyCaptureSet(both.dump(), "some/captures.json").refusals;
      INFO(changes[i].first << " and " << changes[k].first);
      // Corners are compared with the image of a camera that is described.
      const bool hides = changes[i].first == "/cameras/top/fx" && changes[k].first == "/captures/0/corners/0/uv/0";
      CHECK(refusals.size() == (hides ? 1 : 2));
      CHECK(std::count(refusals.begin(), refusals.end(), refusal(one.dump())) == 1);
      CHECK(std::count(refusals.begin(), refusals.end(), refusal(other.dump())) == (hides ? 0 : 1));
    }
  }
}

TEST_CASE("a survey knows which keys the format asks for") {
  // Proves: an invented key is none of them, at every level; a key of the format that the set lacks is one.
  json document = goodSet();
  document["captures"][0]["joints"]["mesured"] = 1;
  const SurveyedCaptureSet survey = surveyCaptureSet(document.dump(), "some/captures.json");
  const json& joints = (*survey.set.source)["captures"][0]["joints"];
  REQUIRE(survey.asked.contains(&joints));
  CHECK_FALSE(survey.asked.at(&joints).contains("mesured"));
  CHECK(survey.asked.at(&joints).contains("current"));
}

} // namespace naocal
