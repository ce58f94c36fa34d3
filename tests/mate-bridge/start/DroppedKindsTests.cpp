#include "start/DroppedKinds.hpp"

#include "io/InputError.hpp"
#include "start/DroppedFiles.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

using namespace naocal;
using Catch::Contains;
using Json = nlohmann::json;

TEST_CASE("the bridge takes each ending that it tells the page, and says all of them where it takes none") {
  // Proves it in small letters and capitals; that endings of a capture set's files are among them; that tables and
  // lenses are not, since a set does not need them.
  const Json told = droppedFilesState();
  const auto all = told["endings"].get<std::set<std::string>>();
  CHECK(all.size() == told["endings"].size());
  CHECK(all.contains(".json"));
  for (const std::string& ending : all) {
    CAPTURE(ending);
    std::string capitals = ending;
    std::transform(ending.begin(), ending.end(), capitals.begin(),
                   [](unsigned char letter) { return char(toupper(letter)); });
    CHECK_NOTHROW(DroppedFiles{
        Json::array({{{"name", "a" + ending}, {"bytes", 1U}}, {{"name", "b" + capitals}, {"bytes", 1U}}})});
    CHECK_THROWS_WITH(DroppedFiles{Json::array({{{"name", "a" + ending + "x"}, {"bytes", 1U}}})}, Contains(ending));
  }
  for (const Json& ending : told["endingsOfSet"]) {
    CHECK(all.contains(ending));
    CHECK(droppedKindOf("a" + ending.get<std::string>()) != DroppedKind::table);
    CHECK(droppedKindOf("a" + ending.get<std::string>()) != DroppedKind::lens);
  }
  CHECK(told["endingsOfSet"].size() < all.size());
  CHECK(isDroppedTruth("set" + told["endingOfTruth"].get<std::string>()));
  CHECK(told["mostFiles"] == DroppedFiles::mostFiles);
  CHECK(told["mostBytes"] == DroppedFiles::mostBytes);
}

TEST_CASE("a dropped file is what the last ending of its name says") {
  // Proves it for each kind, and for names without an ending.
  CHECK(droppedKindOf("a set/captures.json") == DroppedKind::document);
  CHECK(droppedKindOf("arm.urdf.XACRO") == DroppedKind::robot);
  CHECK(droppedKindOf("log.json.csv") == DroppedKind::table);
  CHECK(droppedKindOf("left.cameramodel") == DroppedKind::lens);
  CHECK(droppedKindOf("0.jpeg") == DroppedKind::picture);
  CHECK(droppedKindOf("0.tif") == DroppedKind::otherPicture);
  for (const char* const name : {"csv", ".csv", "a.csv/b", "a.csv.", "", "a.gif"}) {
    CAPTURE(name);
    CHECK_FALSE(droppedKindOf(name));
  }
}
