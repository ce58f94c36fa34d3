#include "framework/ConfiguredRobot.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fmt/format.h>
#include <random>
#include <sys/wait.h>
#include <unistd.h>

namespace naocal {
namespace {

using nlohmann::json;

const std::string mountName = "Motion.Offsets";

/// Offsets with equal values, to detect mixed saves.
json allEqual(int value) {
  json keys;
  for (int i = 0; i < 26; ++i) {
    keys[fmt::format("joint{}", i)] = value;
  }
  return keys;
}

/// Saves increasing values until killed; undoes every third save.
[[noreturn]] void keepSaving(const std::filesystem::path& root, int first, int pipe) {
  Configuration configuration{root, {"", "Ada", "Bob"}, writeAtomically};
  configuration.mount(mountName, "Offsets.json", RobotPart::body);
  for (int value = first;; ++value) {
    for (int i = 0; i < 26; ++i) {
      configuration.set(mountName, fmt::format("joint{}", i), value);
    }
    configuration.save();
    if (value % 3 == 0) {
      configuration.undo(mountName);
    }
    if (value == first && ::write(pipe, "r", 1) != 1) {
      ::_exit(1);
    }
  }
}

const std::string offsetsFile = "location/default/head/Ada/Offsets.json";

/// A journal of files with the content "{}".
std::string journalOf(const std::vector<std::string>& files) {
  json noted = {{"files", json::array()}};
  for (const std::string& file : files) {
    noted["files"].push_back({{"file", file}, {"content", "{}"}});
  }
  return noted.dump();
}

/// Starts a robot with an unfinished save's journal. Returns the logged sentences.
std::vector<std::string> startOn(const ConfiguredRobot& robot, const std::string& journal) {
  robot.file("unfinished-save.json", journal);
  std::vector<std::string> said;
  const Configuration configuration{robot.folder.path(), robot.names, writeAtomically,
                                    [&](std::string_view sentence) { said.emplace_back(sentence); }};
  return said;
}

} // namespace

TEST_CASE("a configuration whose writer is killed at any moment is the old or the new one", "[slow]") {
  // Proves it for 200 kills at random moments of saving and undoing: every file is complete and its values belong
  // together. Power cuts, which lose unwritten data, are not simulated.
  ConfiguredRobot robot;
  robot.file("default/body/default/Offsets.json", allEqual(0).dump());
  std::mt19937 random{1};
  int last = 1;
  int saved = 0;
  for (int kill = 0; kill < 200; ++kill) {
    std::array<int, 2> pipe{};
    REQUIRE(::pipe(pipe.data()) == 0);
    const auto begin = std::chrono::steady_clock::now();
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      keepSaving(robot.folder.path(), last, pipe[1]);
    }
    char started = 0;
    REQUIRE(::read(pipe[0], &started, 1) == 1);
    const auto oneSave = std::chrono::steady_clock::now() - begin;
    std::this_thread::sleep_for(oneSave * std::uniform_real_distribution<double>{0, 1.5}(random));
    ::kill(child, SIGKILL);
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    REQUIRE(WIFSIGNALED(status));
    ::close(pipe[0]);
    ::close(pipe[1]);

    Configuration configuration{robot.folder.path(), robot.names, writeAtomically};
    configuration.mount(mountName, "Offsets.json", RobotPart::body);
    json keys;
    configuration.readKeys(mountName, keys);
    const int value = keys["joint0"];
    REQUIRE(keys == allEqual(value));
    const bool isUndone = !std::filesystem::exists(robot.path("default/body/Bob/Offsets.json.previous"));
    const json previous = isUndone ? json::object() : robot.content("default/body/Bob/Offsets.json.previous");
    REQUIRE((previous.empty() || previous == allEqual(previous["joint0"])));
    saved += value > last ? 1 : 0;
    last = std::max(last, value) + 1;
  }
  CHECK(saved > 20); // some kills must follow a complete save
}

TEST_CASE("an unfinished save that leads out of its configuration is refused whole, and the robot starts") {
  // Proves it for absolute paths, parent folders, symbolic links to folders and files, non-files, and invalid journals.
  // Each journal lists a valid file first, which must not be written either.
  const TemporaryFolder outside;
  ConfiguredRobot robot;
  robot.file("default/access.json", "{}");
  const auto root = robot.folder.path();
  std::filesystem::create_directory_symlink(outside.path(), root / "link");
  std::filesystem::create_symlink(outside.path() / "linked.json", root / "link.json");
  writeAtomically(outside.path() / "linked.json", "kept");
  std::filesystem::create_symlink(root / "circle", root / "circle");
  const auto neighbour = root.string() + "-neighbour.json";
  for (const std::string& file :
       {(outside.path() / "new.json").string(), neighbour, std::string{"../new.json"},
        fmt::format("location/../../{}/new.json", outside.path().filename().string()), std::string{"link/new.json"},
        std::string{"location/../link/new.json"}, std::string{"link.json"}, std::string{"circle/new.json"},
        std::string{"location/default"}, std::string{}}) {
    CAPTURE(file);
    const auto said = startOn(robot, journalOf({offsetsFile, file}));
    REQUIRE(said.size() == 1);
    CHECK(said.front() == fmt::format("A save that was cut off was noted in {}, but not by this robot, and nothing of "
                                      "it was written: expected files in {}, found {}. Remove that file.",
                                      (root / "location/unfinished-save.json").string(), root.string(),
                                      file.empty() ? "\"\"" : file));
    CHECK_FALSE(std::filesystem::exists(root / offsetsFile));
  }
  for (const char* journal : {"{", "[]", R"({"files": 1})", R"({"files": [{"file": "a.json"}]})", "\xff"}) {
    CAPTURE(journal);
    CHECK(startOn(robot, journal).size() == 1);
  }
  CHECK_FALSE(std::filesystem::exists(outside.path() / "new.json"));
  CHECK_FALSE(std::filesystem::exists(root.parent_path() / "new.json"));
  CHECK_FALSE(std::filesystem::exists(neighbour));
  CHECK(readFile(outside.path() / "linked.json") == "kept");
}

TEST_CASE("an unfinished save is finished where its configuration lies now") {
  // Proves it for a configuration that was moved meanwhile; nothing is written to its former place.
  ConfiguredRobot robot;
  robot.file("default/head/default/Offsets.json", R"({"value": 0})");
  const auto before = robot.folder.path() / "before", after = robot.folder.path() / "after";
  std::filesystem::create_directory(before);
  std::filesystem::rename(robot.folder.path() / "location", before / "location");
  const auto writer = [&](const std::filesystem::path& file, std::string_view content) {
    if (file.filename() == "Offsets.json") {
      throw std::runtime_error{"the power is off"};
    }
    writeAtomically(file, content);
  };
  {
    Configuration configuration{before, robot.names, writer};
    configuration.mount("Offsets", "Offsets.json", RobotPart::head);
    configuration.set("Offsets", "value", 1);
    CHECK_THROWS_AS(configuration.save(), std::runtime_error);
  }
  std::filesystem::rename(before, after);
  Configuration moved{after, robot.names, writeAtomically};
  moved.mount("Offsets", "Offsets.json", RobotPart::head);
  json keys;
  moved.readKeys("Offsets", keys);
  CHECK(keys["value"] == 1);
  CHECK_FALSE(std::filesystem::exists(before));
  CHECK_FALSE(std::filesystem::exists(after / "location/unfinished-save.json"));
}

TEST_CASE("what an earlier version had noted by its whole path is still finished") {
  // Proves it for a file of the same configuration, in a folder that does not exist yet.
  ConfiguredRobot robot;
  const auto file = robot.folder.path() / offsetsFile;
  CHECK(startOn(robot, journalOf({file.string()})).empty());
  CHECK(readFile(file) == "{}");
  CHECK_FALSE(std::filesystem::exists(robot.path("unfinished-save.json")));
}

} // namespace naocal
