#include "start/RecentFiles.hpp"

#include "io/Files.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

using namespace naocal;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

/// A folder with capture sets that exist, and the file of the list.
struct RecentDesk {
  std::string set(const std::string& name) const {
    std::filesystem::create_directories(folder.path() / name);
    writeAtomically(folder.path() / name / "captures.json", "{}");
    return (folder.path() / name).string();
  }
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const RecentFile& entry : RecentFiles{file}.files()) {
      result.push_back(std::filesystem::path{entry.paths.front()}.filename().string());
    }
    return result;
  }

  TemporaryDirectory folder;
  std::filesystem::path file = folder.path() / "state" / "panel.json";
};

} // namespace

TEST_CASE("what was opened last comes first, once, and survives the program") {
  // Proves order, uniqueness, and that a later list reads it from the file, whose folder is made.
  const RecentDesk desk;
  RecentFiles recent{desk.file};
  for (const char* const name : {"a", "b", "a"}) {
    recent.add({desk.set(name)});
  }
  CHECK(desk.names() == std::vector<std::string>{"a", "b"});
  recent.forget({desk.set("a")});
  CHECK(desk.names() == std::vector<std::string>{"b"});
}

TEST_CASE("the list of recent files is bounded, and drops files that have gone") {
  // Proves it at the boundary, and that an entry with one missing path is dropped as a whole.
  const RecentDesk desk;
  RecentFiles recent{desk.file};
  for (std::size_t i = 0; i <= RecentFiles::mostFiles; ++i) {
    recent.add({desk.set(fmt::format("set{}", i))});
  }
  CHECK(recent.files().size() == RecentFiles::mostFiles);
  CHECK(desk.names().back() == "set1");
  std::filesystem::remove_all(desk.set("set5"));
  CHECK(desk.names().size() == RecentFiles::mostFiles - 1);
  recent.add({desk.set("c"), desk.set("gone")});
  std::filesystem::remove_all(desk.set("gone"));
  CHECK(desk.names().front() != "c");
}

TEST_CASE("broken entries of the list are dropped, the others kept") {
  // Proves it for entries of wrong types, without paths, and for wrong robots.
  const RecentDesk desk;
  const std::string good = desk.set("good");
  const Json document{{"format", "naocal-panel"},
                      {"version", 1},
                      {"robots", {"nao21", 7, ""}},
                      {"recent",
                       {3,
                        "x",
                        Json::object(),
                        {{"paths", "text"}},
                        {{"paths", Json::array()}},
                        {{"paths", {1}}},
                        {{"paths", {good, std::string(5000, 'x')}}},
                        {{"paths", {good}}, {"opened", "yesterday"}}}}};
  std::filesystem::create_directories(desk.file.parent_path());
  writeAtomically(desk.file, document.dump());
  const RecentFiles recent{desk.file};
  CHECK(desk.names() == std::vector<std::string>{"good"});
  CHECK(recent.robots() == std::vector<std::string>{"nao21"});
  CHECK(recent.problem().empty());
}

TEST_CASE("a file that is no list of recent files is left alone") {
  // Proves for another format and for damaged files that nothing is overwritten, and that the reason is said.
  for (const char* const content : {R"({"format": "naocal-result"})", "{", "[]", "\xff"}) {
    const RecentDesk desk;
    std::filesystem::create_directories(desk.file.parent_path());
    writeAtomically(desk.file, content);
    RecentFiles recent{desk.file};
    recent.add({desk.set("a")});
    CHECK(readFile(desk.file) == content);
    CHECK_THAT(recent.problem(), Contains("panel.json") && Contains("move it away"));
    CHECK(recent.files().size() == 1); // in this program
  }
}

TEST_CASE("without a place for it the list lasts as long as the program") {
  // Proves that no file is needed.
  const RecentDesk desk;
  RecentFiles recent{{}};
  recent.add({desk.set("a")});
  recent.setRobots({"nao21", "nao21", "nao22"});
  CHECK(recent.files().size() == 1);
  CHECK(recent.robots() == std::vector<std::string>{"nao21", "nao22"});
}

TEST_CASE("recent files are named by what they hold") {
  // Proves it for folders and for files by their format.
  const RecentDesk desk;
  const std::string set = desk.set("set");
  CHECK(kindOfDataset(set) == "capture set");
  CHECK(kindOfDataset(desk.folder.path().string()) == "capture sets");
  writeAtomically(desk.folder.path() / "set" / "offsets.json", "{}");
  CHECK(kindOfDataset(set) == "recording");
  const std::string result = (desk.folder.path() / "r.json").string();
  writeAtomically(result, R"({"chi2": 1, "format": "naocal-result"})");
  CHECK(kindOfDataset(result) == "result");
  CHECK(kindOfDataset("/no/such/file") == "file");
}
