#include "start/DroppedTable.hpp"

#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"
#include "io/GreyImage.hpp"
#include "io/InputError.hpp"
#include "recordings/TestArm.hpp"
#include "start/StartPage.hpp"

#include <boost/asio/executor_work_guard.hpp>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace naocal;
using namespace naocal::testing;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

using NamedFiles = std::vector<std::pair<std::string, std::string>>; // name and content

const std::string trackedLog =
    "t,q1,q2,q3,hand_x_mm,hand_y_mm,hand_z_mm\n0,90,0,0.1,1000,0,500\n9,45,30,0.2,900,20,500\n";
const std::string picturesLog = "q1,q2,q3,file\n10,20,0.1,1.png\n20,10,0.2,2.png\n";
const std::string lensFile =
    "image_width: 4\nimage_height: 2\ncamera_matrix: {rows: 3, cols: 3, data: [5, 0, 2, 0, 5, 1, "
    "0, 0, 1]}\ndistortion_model: plumb_bob\ndistortion_coefficients: {rows: 1, cols: 5, data: "
    "[0, 0, 0, 0, 0]}\n";
const std::string boardsFile =
    R"({"format": "naocal-boards", "version": 1, "boards": [{"id": "A", "link": "world", "points": [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0]]}]})";

Json announcedFiles(const NamedFiles& files) {
  Json announced = Json::array();
  for (const auto& [name, content] : files) {
    announced.push_back({{"name", name}, {"bytes", content.size()}});
  }
  return announced;
}

std::string contentOf(const NamedFiles& files) {
  std::string bytes;
  for (const auto& [name, content] : files) {
    bytes += content;
  }
  return bytes;
}

void drop(DroppedTable& table, const NamedFiles& files) {
  auto dropped = std::make_shared<DroppedFiles>(announcedFiles(files));
  dropped->append(contentOf(files));
  table.add(dropped);
}

/// The meaning of a column in the state that the page shows.
Json meaningIn(const Json& state, const std::string& column) {
  for (const Json& meaning : state["columns"]["meanings"]) {
    if (meaning["column"] == column) {
      return meaning;
    }
  }
  return nullptr;
}

std::string refusalOfWrite(const DroppedTable& table) {
  try {
    table.write();
    return "";
  } catch (const InputError& error) {
    return withoutFolder(error.what(), table.folder());
  }
}

std::string smallPng() {
  const TemporaryDirectory folder;
  writeImage({4, 2, {1, 2, 3, 4, 5, 6, 7, 8}}, folder.path() / "a.png");
  return readFile(folder.path() / "a.png");
}

/// A panel whose page drops files, and what the start page does with them.
struct ImportingDesk {
  std::vector<Json> told; // messages for panel 5
  std::vector<std::string> opened;
  std::string refusesToOpen; // with this sentence; empty: it opens
  boost::asio::io_context context;
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> guard{context.get_executor()};
  StartPage page{context,
                 {},
                 {[](const std::string&) {},
                  [this](std::size_t panel, const std::string& json) {
                    CHECK(panel == 5);
                    told.push_back(Json::parse(json));
                  },
                  [this](const std::vector<std::string>& paths, const auto& refused, const auto& done) {
                    opened.push_back(paths.at(0));
                    refusesToOpen.empty() ? done() : refused(refusesToOpen);
                  },
                  [](const std::string&) {}, [](const std::string&) {}}};

  void drop(const NamedFiles& files) {
    page.beginUpload(5, announcedFiles(files));
    page.addUpload(5, contentOf(files));
  }
  /// Waits for the next message.
  Json next() {
    const std::size_t before = told.size();
    while (told.size() == before) {
      context.run_one();
    }
    return told.back();
  }
};

} // namespace

TEST_CASE("a dropped table and its URDF are shown with the guessed columns, and become a set") {
  // Proves the guess as the library words it, either order of the files, corrections, and the set that is written.
  for (const bool isUrdfFirst : {true, false}) {
    DroppedTable table;
    drop(table, {isUrdfFirst ? std::pair{"arm.urdf", armUrdf} : std::pair{"log.csv", trackedLog}});
    CHECK(table.state()["isReady"] == false);
    CHECK_THAT(table.state()["sentence"],
               Contains(isUrdfFirst ? "arm.urdf describes a robot with 3 joints (shoulder_pan, shoulder_lift, slide)"
                                    : "log.csv has 2 rows of 7 columns. Drop the robot's URDF"));
    CHECK_THAT(refusalOfWrite(table), Contains("expected a table and the robot's URDF"));
    drop(table, {isUrdfFirst ? std::pair{"log.csv", trackedLog} : std::pair{"arm.urdf", armUrdf}});
    const Json state = table.state();
    CHECK(state["isReady"] == true);
    CHECK(state["problem"] == "");
    CHECK(state["columns"]["list"][1] == Json{{"name", "q1"}, {"examples", {"90", "45"}}});
    CHECK(meaningIn(state, "q1")["words"] == "angle of joint shoulder_pan");
    CHECK(meaningIn(state, "q1")["unit"] == "deg");
    CHECK(meaningIn(state, "hand_x_mm")["words"] == "x of marker hand, measured by tracker");
    table.assign("t", "", "");
    table.assign("q3", "joint:slide", "mm");
    CHECK(meaningIn(table.state(), "t") == nullptr);
    const DroppedTable::Written written = table.write();
    REQUIRE(written.temporary);
    CHECK(written.set.filename() == "log");
    CHECK(written.sentences ==
          std::vector<std::string>{"2 rows, 2 captures",
                                   "marker hand was taken to be on link eye, the last that the joints move",
                                   "no column gives the time: each row counts as one second, and rates are per row"});
    const CaptureSet set = readCaptureSet(written.set.string()).set;
    CHECK(set.captures.at(1).joints.measured.at(2) == Approx(0.0002));
    CHECK(set.captures.at(1).time == Seconds{1}); // the number of the row
    CHECK(readFile(written.set / "robot.urdf") == armUrdf);
    CHECK_THAT(readFile(written.set / "columns.json"), Contains("\"unit\": \"mm\""));
  }
}

TEST_CASE("pictures, boards, a lens and a column map are found among the dropped files") {
  // Proves which folder the pictures are looked for in, that a dropped column map takes the guess's place, that what is
  // missing is refused in the library's words, and that other files are said not to be needed.
  DroppedTable table;
  const std::string png = smallPng();
  drop(table,
       {{"run/log.csv", picturesLog}, {"run/photos/1.png", png}, {"run/photos/2.png", png}, {"arm.urdf", armUrdf}});
  CHECK(table.state()["hasPictures"] == true);
  CHECK(table.state()["files"]["pictures"]["chosen"] == "run/photos");
  CHECK_THAT(table.state()["sentence"],
             Contains("Pictures also need the lens calibration, the link of the camera, the printed boards."));
  CHECK_THAT(refusalOfWrite(table), Contains("--boards: expected a file with the boards"));
  drop(table, {{"boards.json", boardsFile}, {"notes.json", "[]"}});
  CHECK(table.state()["files"]["boards"]["chosen"] == "boards.json");
  CHECK(table.state()["ignored"] == Json{"notes.json"});
  CHECK_THAT(refusalOfWrite(table), Contains("expected a lens of the camera, found none"));
  drop(table, {{"lens.yaml", lensFile}});
  CHECK_THAT(refusalOfWrite(table), Contains("expected the link of the URDF that carries the camera"));
  table.choose({{"cameraLink", "eye"}, {"boardLink", "floor"}});
  CHECK_THAT(table.state()["sentence"], !Contains("also need"));
  const CaptureSet set = readCaptureSet(table.write().set.string()).set;
  CHECK(set.captures.size() == 2);
  CHECK(set.mountings.at("camera").link == "eye");
  CHECK(set.boards.at(0).link == "floor");
  table.choose({{"pictures", "run"}});
  CHECK_THAT(refusalOfWrite(table), Contains("expected a picture in run (--pictures), found no file \"1.png\""));
  drop(table, {{"columns.json", R"({"joints": {"slide": {"column": "q3", "unit": "cm"}}})"}});
  CHECK(meaningIn(table.state(), "q3")["unit"] == "cm");
  CHECK(meaningIn(table.state(), "q1") == nullptr);
  CHECK(table.state()["hasPictures"] == false);
}

TEST_CASE("what is wrong with a dropped table is said in the library's words until it is mended") {
  // Proves it for tables, URDFs, guesses, column maps and choices; typed paths are read, too.
  DroppedTable table;
  drop(table, {{"arm.urdf", R"(<robot name="a"><link name="${name}"/></robot>)"}, {"log.csv", "a,\n1,2\n"}});
  CHECK_THAT(table.state()["problem"], Contains("log.csv, row 1: expected a name for column 2, found none"));
  drop(table, {{"log.csv", "a,b,c,x,y,z\n1,2,3,4,5,6\n"}});
  CHECK_THAT(table.state()["problem"], Contains("arm.urdf, link") && Contains("a xacro file, not a URDF"));
  const TemporaryDirectory folder;
  writeAtomically(folder.path() / "other.urdf", armUrdf);
  table.choose({{"robot", (folder.path() / "other.urdf").string()}});
  CHECK_THAT(table.state()["problem"], Contains("expected columns named as the URDF's joints"));
  CHECK_THAT(table.state()["sentence"], Contains("Say which columns are the angles"));
  CHECK_THAT(refusalOfWrite(table), Contains("expected columns of joints, found none"));
  table.assign("a", "joint:slide", "mm");
  CHECK(table.state()["problem"] == "");
  CHECK_THAT(refusalOfWrite(table), Contains("expected rows with a picture, a measured point or a measured frame"));
  CHECK_THROWS_WITH(table.setColumns(R"({"joints": {"slid": "a"}})"), Contains("a joint of the URDF: slide"));
  CHECK_THROWS_WITH(table.setColumns("{"), Contains("columns"));
  CHECK(meaningIn(table.state(), "a")["unit"] == "mm");
  table.setColumns(R"({"joints": {"slide": "a"}, "points": [{"marker": "m", "columns": ["x", "y", "z"]}]})");
  CHECK(meaningIn(table.state(), "y")["words"] == "y of marker m, measured by tracker");
  CHECK(refusalOfWrite(table).empty());
  CHECK_THROWS_WITH(table.choose({{"colour", "red"}}), Contains("found \"colour\""));
  CHECK_THROWS_WITH(table.assign("q", "time", ""), Contains("expected a column \"q\""));
}

TEST_CASE("a refused import writes nothing, and takes nothing of a folder that was there") {
  // Proves it for the chosen folder: new, empty and with files; and that what was written can be removed again.
  DroppedTable table;
  drop(table, {{"log.csv", trackedLog}, {"arm.urdf", armUrdf}});
  const TemporaryDirectory folder;
  const std::filesystem::path chosen = folder.path() / "a set";
  table.choose({{"output", chosen.string()}});
  table.assign("q1", "joint:shoulder_pan", "rad");
  CHECK_THAT(refusalOfWrite(table), Contains("are these degrees?"));
  CHECK_FALSE(std::filesystem::exists(chosen));
  table.assign("q1", "joint:shoulder_pan", "deg");
  const DroppedTable::Written written = table.write();
  CHECK_FALSE(written.temporary);
  CHECK(readCaptureSet(chosen.string()).set.captures.size() == 2);
  CHECK_THAT(refusalOfWrite(table), Contains("expected a new or an empty folder"));
  CHECK(std::filesystem::exists(chosen / "captures.json"));
  written.remove();
  CHECK_FALSE(std::filesystem::exists(chosen));
  std::filesystem::create_directory(chosen);
  table.write().remove();
  CHECK(std::filesystem::is_empty(chosen));
}

TEST_CASE("a page that drops a table is told of it, and the imported set is opened") {
  // Proves the messages from the drop to the end, files that are added, and a set that cannot be opened: its import
  // stays with the reason, and the set goes, also from a chosen folder.
  const TemporaryDirectory folder;
  const std::string chosen = (folder.path() / "set").string();
  ImportingDesk desk;
  desk.drop({{"log.csv", trackedLog}});
  CHECK_THAT(desk.next()["table"]["sentence"], Contains("Drop the robot's URDF"));
  desk.drop({{"arm.urdf", armUrdf}, {"notes.json", "{}"}});
  CHECK(desk.next()["table"]["isReady"] == true);
  CHECK(desk.opened.empty());
  desk.page.imports().assign(5, "t", "", "");
  CHECK(meaningIn(desk.next()["table"], "t") == nullptr);
  desk.page.imports().choose(5, {{"output", chosen}});
  CHECK(desk.next()["table"]["output"] == chosen);
  desk.refusesToOpen = "no such robot";
  desk.page.imports().write(5);
  desk.page.imports().write(5); // once is enough
  CHECK(desk.next()["table"]["busy"] == true);
  const Json refused = desk.next()["table"];
  CHECK(refused["busy"] == false);
  CHECK(refused["problem"] == "no such robot");
  CHECK(desk.opened == std::vector<std::string>{chosen});
  CHECK_FALSE(std::filesystem::exists(chosen));
  desk.page.imports().choose(5, {{"output", ""}});
  desk.next();
  desk.refusesToOpen.clear();
  desk.page.imports().write(5);
  desk.next();
  CHECK(desk.next() == Json{{"kind", "import"},
                            {"table", nullptr},
                            {"sentence", "2 rows, 2 captures; marker hand was taken to be on link eye, the "
                                         "last that the joints move; no column gives the time: each row counts as one "
                                         "second, and rates are per row"}});
  REQUIRE(desk.opened.size() == 2);
  CHECK(std::filesystem::exists(desk.opened[1] + "/captures.json"));
  CHECK(Json::parse(desk.page.message())["recent"].empty());
  CHECK_THROWS_WITH(desk.page.imports().write(5), Contains("expected a dropped table or URDF, found none"));
}

TEST_CASE("an import ends with its page, and when captures are dropped") {
  // Proves that nothing more is told of it; that its files count for the limits of the next upload only until then.
  ImportingDesk desk;
  desk.drop({{"arm.urdf", armUrdf}});
  CHECK(desk.page.imports().amount(5).files == 1);
  desk.drop({{"set/captures.json", "{}"}});
  REQUIRE(desk.opened.size() == 1);
  CHECK(desk.opened[0].ends_with("/set"));
  CHECK_FALSE(desk.page.imports().has(5));
  desk.drop({{"arm.urdf", armUrdf}});
  desk.page.removePanel(5);
  CHECK(desk.page.imports().amount(5).files == 0);
  desk.drop({{"log.csv", trackedLog}});
  CHECK_THAT(desk.next()["table"]["sentence"], Contains("log.csv has 2 rows")); // not of those that have ended
  CHECK(desk.told.size() == 1);
}
