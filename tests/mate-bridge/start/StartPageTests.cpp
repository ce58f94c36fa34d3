#include "start/StartPage.hpp"

#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "print/PdfDocument.hpp"
#include "start/DroppedKinds.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

using namespace naocal;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

/// A start page that stores what it wants opened.
struct OpeningDesk {
  std::vector<std::vector<std::string>> opened;
  bool isRefused = false; // opens nothing
  boost::asio::io_context context;
  StartPage page{context,
                 {},
                 {[](const std::string&) {}, [](std::size_t, const std::string&) {},
                  [this](const std::vector<std::string>& paths, const auto&, const auto& done) {
                    opened.push_back(paths);
                    if (!isRefused) {
                      done();
                    }
                  },
                  [](const std::string&) {}, [](const std::string&) {}}};
};

} // namespace

TEST_CASE("an upload is opened after its last byte, and is no recent file") {
  // Proves the replies of every part; the opened folder stays there.
  OpeningDesk desk;
  desk.page.beginUpload(3, Json::array({{{"name", "set/captures.json"}, {"bytes", 4U}}}));
  CHECK(desk.page.addUpload(3, "ab") == Json{{"bytes", 2}, {"complete", false}});
  CHECK(desk.opened.empty());
  CHECK(desk.page.addUpload(3, "cd") == Json{{"bytes", 4}, {"complete", true}});
  REQUIRE(desk.opened.size() == 1);
  CHECK(readFile(desk.opened[0].at(0) + "/captures.json") == "abcd");
  CHECK(Json::parse(desk.page.message())["recent"].empty());
}

TEST_CASE("the page is told what may be dropped") {
  // Proves that the message has it; what it says is DroppedKinds'.
  OpeningDesk desk;
  CHECK(Json::parse(desk.page.message())["drop"] == droppedFilesState());
}

TEST_CASE("files that cannot be opened leave those of the open set where they are") {
  // Proves that only opened uploads count among the two that are kept, and that a refused one is removed.
  OpeningDesk desk;
  const auto drop = [&](bool isRefused) {
    desk.isRefused = isRefused;
    desk.page.beginUpload(1, Json::array({{{"name", "set/captures.json"}, {"bytes", 1U}}}));
    desk.page.addUpload(1, "a");
    return desk.opened.back().at(0) + "/captures.json";
  };
  const std::string open = drop(false);
  for (int i = 0; i < 3; ++i) {
    CHECK_FALSE(std::filesystem::exists(drop(true)));
  }
  CHECK(std::filesystem::exists(open));
  drop(false);
  CHECK(std::filesystem::exists(open)); // may still be read
  drop(false);
  CHECK_FALSE(std::filesystem::exists(open));
}

TEST_CASE("an upload is given up by a mistake, and belongs to the page that began it") {
  // Proves that a refused part ends the upload, and that other pages and closed ones have none.
  OpeningDesk desk;
  const Json files = Json::array({{{"name", "a.json"}, {"bytes", 1U}}});
  desk.page.beginUpload(1, files);
  CHECK_THROWS_WITH(desk.page.addUpload(2, "a"), Contains("expected files to be announced"));
  CHECK_THROWS_WITH(desk.page.addUpload(1, "ab"), Contains("no more bytes"));
  CHECK_THROWS_WITH(desk.page.addUpload(1, "a"), Contains("expected files to be announced"));
  desk.page.beginUpload(1, files);
  desk.page.removePanel(1);
  CHECK_THROWS_WITH(desk.page.addUpload(1, "a"), Contains("expected files to be announced"));
  CHECK(desk.opened.empty());
}

TEST_CASE("boards are printed on every paper, and on no other") {
  // Proves that they are PDFs that `naocal board` may replace; their size is tested with the boards.
  for (const char* const paper : {"a4", "a3", "a2", "a1", "a0"}) {
    const auto pdf = StartPage::boards(std::string{"boards-"} + paper + ".pdf");
    REQUIRE(pdf);
    CHECK(isPdfOf(*pdf, "naocal board"));
  }
  for (const char* const name : {"boards-a5.pdf", "boards-.pdf", "boards-a4", "index.html", ""}) {
    CHECK_FALSE(StartPage::boards(name));
  }
}

TEST_CASE("more robots than are kept are not looked for") {
  // Proves the boundary; the addresses are not asked.
  OpeningDesk desk;
  CHECK_THROWS_WITH(desk.page.findRobots(std::vector<std::string>(RecentFiles::mostRobots + 1, "127.0.0.1:1")),
                    Contains("at most 16"));
  CHECK_THROWS_WITH(desk.page.sampleTruth(), Contains("open it first"));
}
