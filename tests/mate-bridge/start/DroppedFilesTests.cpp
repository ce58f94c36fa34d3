#include "start/DroppedFiles.hpp"

#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

using namespace naocal;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

Json announced(const std::string& name, std::size_t bytes = 1) {
  return {{"name", name}, {"bytes", bytes}};
}

} // namespace

TEST_CASE("dropped files arrive in parts of any size, and what they hold is opened") {
  // Proves contents, empty files, and which paths are opened: the folder, and documents beside it but no truth.
  for (const std::size_t part : {1, 2, 5, 100}) {
    DroppedFiles dropped{
        Json::array({announced("a set/captures.json", 3), announced("a set/images/0.PNG", 4), announced("m.json", 0),
                     announced("a set.truth.json", 1), announced("result.json", 2)})};
    const std::string bytes = "abcdefghij";
    for (std::size_t i = 0; i < bytes.size(); i += part) {
      CHECK_FALSE(dropped.isComplete());
      dropped.append(bytes.substr(i, part));
    }
    CHECK(dropped.isComplete());
    CHECK(dropped.received() == 10);
    const std::vector<std::string> paths = dropped.paths();
    REQUIRE(paths.size() == 3);
    CHECK(readFile(paths[0] + "/captures.json") == "abc");
    CHECK(readFile(paths[0] + "/images/0.PNG") == "defg");
    CHECK(paths[0].ends_with("/a set"));
    CHECK(paths[1].ends_with("/m.json"));
    CHECK(readFile(paths[2]) == "ij");
  }
}

TEST_CASE("a dropped result is opened alone: it names its captures, which lie beside it") {
  // Proves it for a result with a capture set; a model is opened together with the set.
  for (const auto& [format, count] : {std::pair{"naocal-result", 1}, std::pair{"naocal-model", 2}}) {
    const std::string content = fmt::format(R"({{"format": "{}"}})", format);
    DroppedFiles dropped{Json::array({announced("set/captures.json", 0), announced("r.json", content.size())})};
    dropped.append(content);
    CHECK(dropped.paths().size() == std::size_t(count));
    CHECK(dropped.paths().back().ends_with("/r.json"));
  }
}

TEST_CASE("the folder of dropped files goes with them") {
  // Proves it for a finished and an unfinished upload.
  std::string path;
  {
    DroppedFiles dropped{Json::array({announced("captures.json")})};
    path = dropped.paths().front();
    CHECK(std::filesystem::exists(path + "/captures.json"));
  }
  CHECK_FALSE(std::filesystem::exists(path));
}

TEST_CASE("dropped files cannot leave their folder, nor be more or larger than is allowed") {
  // Proves the refusals of names, kinds, counts and sizes, each at its boundary.
  const auto refusal = [](const Json& files) {
    try {
      DroppedFiles dropped{files};
      return std::string{};
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
  };
  for (const char* const name : {"../a.json", "a/../../b.json", "/etc/a.json", "a//b.json", "./a.json", "a/b.json/", "",
                                 "a\nb.json", "a/b/c/d/e/f/g/h/i/j.json"}) {
    CHECK_THAT(refusal(Json::array({announced(name)})), Contains("expected names within at most 8 folders"));
  }
  CHECK(refusal(Json::array({announced("a/b/c/d/e/f/g/h/i.json")})).empty());
  CHECK(refusal(Json::array({announced("set/robot.urdf")})).empty());
  CHECK_THAT(refusal(Json::array({announced(std::string(256, 'x') + ".json")})), Contains("expected names"));
  for (const char* const name : {"a.sh", "a", "a.json.exe", ".json"}) {
    CHECK_THAT(refusal(Json::array({announced(name)})), Contains("expected names that end in .json, .urdf"));
  }
  CHECK_THAT(refusal(Json::array({announced("a.json"), announced("a.json")})), Contains("twice"));
  CHECK_THAT(refusal(Json::array({announced("a.json", 0), announced("a.json/b.json")})),
             Contains("called like a file"));
  CHECK_THAT(refusal(Json::array()), Contains("1 to 10000 files"));
  CHECK_THAT(refusal(Json::array({announced("a.json", DroppedFiles::mostBytes), announced("b.json")})),
             Contains("1024 MB"));
  CHECK_THAT(refusal(Json::array({{{"name", "a.json"}, {"bytes", -1}}})), Contains("1024 MB"));
  CHECK(refusal(Json::array({announced("a.json", DroppedFiles::mostBytes)})).empty());
  CHECK_THROWS_AS((DroppedFiles{Json::array({3})}), Json::exception);
  Json many = Json::array();
  for (std::size_t i = 0; i <= DroppedFiles::mostFiles; ++i) {
    many.push_back(announced(fmt::format("{}.png", i)));
  }
  CHECK_THAT(refusal(many), Contains("1 to 10000 files, found 10001"));
}

TEST_CASE("more bytes than announced are refused, and files that say nothing") {
  // Proves it after the last announced byte, and for pictures without a set.
  DroppedFiles dropped{Json::array({announced("a.png", 2)})};
  CHECK_THROWS_WITH(dropped.append("abc"), Contains("no more bytes than announced"));
  CHECK_THROWS_WITH(dropped.paths(), Contains("expected a folder with captures.json"));
}

TEST_CASE("a table or a URDF without a capture set is to be imported") {
  // Proves it for folders and endings in capitals, and that captures, results and lenses alone are not.
  const auto isImport = [](const std::vector<std::string>& names) {
    Json files = Json::array();
    for (const std::string& name : names) {
      files.push_back(announced(name));
    }
    return DroppedFiles{files}.holdsImport();
  };
  CHECK(isImport({"log.csv"}));
  CHECK(isImport({"a run/LOG.CSV", "a run/pictures/1.png"}));
  CHECK(isImport({"arm.urdf"}));
  CHECK(isImport({"arm.urdf.xacro"}));
  CHECK_FALSE(isImport({"set/captures.json", "set/robot.urdf", "set/log.csv"}));
  CHECK_FALSE(isImport({"lens.yaml", "a.png", "boards.json"}));
}

TEST_CASE("files that are added count with those before, and replace those of the same name") {
  // Proves contents, amounts, the limits of both together at the boundary, and a folder that is called like a file.
  DroppedFiles first{Json::array({announced("log.csv", 2), announced("p/1.png", 1)})};
  first.append("abc");
  DroppedFiles second{Json::array({announced("log.csv", 3), announced("p/2.png", 1)}), first.amount()};
  second.append("defg");
  first.add(second);
  CHECK(readFile(first.folder() / "log.csv") == "def");
  CHECK(readFile(first.folder() / "p/1.png") == "c");
  CHECK(readFile(first.folder() / "p/2.png") == "g");
  CHECK(first.amount().files == 3);
  CHECK(first.amount().bytes == 5);
  CHECK(first.isComplete());
  const DroppedFiles::Amount full{DroppedFiles::mostFiles - 1, DroppedFiles::mostBytes - 1};
  CHECK_NOTHROW(DroppedFiles{Json::array({announced("a.csv", 1)}), full});
  CHECK_THROWS_WITH((DroppedFiles{Json::array({announced("a.csv", 2)}), full}), Contains("1024 MB"));
  CHECK_THROWS_WITH((DroppedFiles{Json::array({announced("a.csv", 0), announced("b.csv", 0)}), full}),
                    Contains("found 10001"));
  DroppedFiles clash{Json::array({announced("log.csv/1.png", 0)})};
  CHECK_THROWS_WITH(first.add(clash), Contains("called like a file"));
}
