#include "framework/ConfiguredRobot.hpp"
#include "framework/configuration/ConfigurationLayers.hpp"
#include "framework/network/Sockets.hpp"

#include <catch2/catch.hpp>
#include <sys/stat.h>

namespace naocal {
namespace {

using nlohmann::json;

template <class Action> std::string refusal(const Action& action) {
  try {
    action();
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "not refused";
}

} // namespace

TEST_CASE("six layers are read in their order and later ones replace whole top-level keys") {
  // Proves order and shallow merging: each layer sets the key of its own number and all later ones.
  const ConfiguredRobot robot;
  const std::vector<std::string> layers{"default/Camera.json",           "default/head/default/Camera.json",
                                        "default/head/Ada/Camera.json",  "Home/Camera.json",
                                        "Home/head/default/Camera.json", "Home/head/Ada/Camera.json"};
  for (std::size_t i = 0; i < layers.size(); ++i) {
    json content = {{"list", {i, i}}, {"inner", {{fmt::format("of{}", i), i}}}};
    for (std::size_t k = i; k < layers.size(); ++k) {
      content[fmt::format("key{}", k)] = i;
    }
    robot.file(layers[i], "// a comment\n" + content.dump());
  }
  robot.file("default/body/Bob/Camera.json", R"({"list": "the body's"})");
  robot.file("default/head/Eve/Camera.json", R"({"list": "another head's"})");
  const_cast<Configuration&>(robot.configuration).mount("Brain.Camera", "Camera.json", RobotPart::head);
  const json keys = robot.readKeys("Brain.Camera");
  CHECK(keys == json::parse(R"({"list": [5, 5], "inner": {"of5": 5}, "key0": 0, "key1": 1, "key2": 2, "key3": 3,
                                "key4": 4, "key5": 5})"));
}

TEST_CASE("a robot at the default location has three layers and files may be missing") {
  // Proves that absent files are skipped, and that `mounts` returns the most specific existing file.
  ConfiguredRobot robot{{"default", "Ada", "Bob"}};
  robot.file("default/body/default/Offsets.json", R"({"a": 1, /* and */ "b": 2})");
  robot.configuration.mount("Motion.Offsets", "Offsets.json", RobotPart::body);
  CHECK(robot.readKeys("Motion.Offsets") == json{{"a", 1}, {"b", 2}});
  CHECK(robot.configuration.mounts().at(0).file == robot.path("default/body/default/Offsets.json"));
  CHECK(robot.readKeys("Motion.Nothing") == json::object());
}

TEST_CASE("a robot is known by the ids of its head and its body") {
  // Proves exchanged heads, the V5's four-character body id, and that unlisted robots are named by their ids.
  const ConfiguredRobot robot;
  robot.file("default/id_map.json", R"({"idmap.nao": [
    {"name": "Ada", "headid": "P1A", "bodyid": "P1B0012"}, {"name": "Bob", "headid": "P2A", "bodyid": "P2B0034"}]})");
  const auto names = [&](const char* head, const char* body) {
    const RobotNames found = findRobotNames(robot.folder.path(), head, body);
    return found.head + "/" + found.body;
  };
  CHECK(names("P1A", "P1B0012") == "Ada/Ada");
  CHECK(names("P2A", "P1B0012") == "Bob/Ada");
  CHECK(names("P1A", "0034") == "Ada/Bob");
  CHECK(names("P9A", "P9B0099") == "P9A/P9B0099");
  robot.file("default/id_map.json", R"({"idmap.nao": [{"name": 7}]})");
  CHECK(refusal([&] { names("P1A", "P1B"); }).find("expected {\"idmap.nao\"") != std::string::npos);
}

TEST_CASE("only what was set is saved, into the robot's own file") {
  // Proves the layer (body or head), that no other file and no other key is changed, and that a second robot is not
  // affected.
  ConfiguredRobot robot;
  robot.file("default/body/default/Offsets.json", R"({"headYaw": 0.0, "lKneePitch": 0.0, "mode": {"fast": true}})");
  robot.file("default/head/default/Camera.json", R"({"top": [0, 0, 0], "bottom": [0, 0, 0]})");
  robot.file("default/head/Ada/Camera.json", "// measured by hand\n{\"bottom\": [1, 2, 3]}");
  robot.configuration.mount("Motion.Offsets", "Offsets.json", RobotPart::body);
  robot.configuration.mount("Brain.Camera", "Camera.json", RobotPart::head);
  robot.configuration.set("Motion.Offsets", "lKneePitch", 1.5);
  robot.configuration.set("Motion.Offsets", "mode.fast", false);
  robot.configuration.set("Brain.Camera", "top[1]", 0.25);
  CHECK_FALSE(std::filesystem::exists(robot.path("default/body/Bob")));
  robot.configuration.save();
  CHECK(robot.content("default/body/Bob/Offsets.json") == json{{"lKneePitch", 1.5}, {"mode", {{"fast", false}}}});
  CHECK(robot.content("default/head/Ada/Camera.json") == json{{"top", {0, 0.25, 0}}, {"bottom", {1, 2, 3}}});
  CHECK(robot.content("default/body/default/Offsets.json")["lKneePitch"] == 0.0);

  Configuration other{robot.folder.path(), {"Home", "Eve", "Eve"}, writeAtomically};
  other.mount("Motion.Offsets", "Offsets.json", RobotPart::body);
  json keys;
  other.readKeys("Motion.Offsets", keys);
  CHECK(keys["lKneePitch"] == 0.0);
}

TEST_CASE("what is saved is what is read back, also where the location overrides it") {
  // Proves that values are saved to a layer that no later layer overrides.
  for (const bool overridden : {false, true}) {
    ConfiguredRobot robot;
    robot.file("default/body/default/Offsets.json", R"({"headYaw": 0.0})");
    if (overridden) {
      robot.file("Home/Offsets.json", R"({"headYaw": 3.0})");
    }
    robot.configuration.mount("Motion.Offsets", "Offsets.json", RobotPart::body);
    robot.configuration.set("Motion.Offsets", "headYaw", 1.5);
    robot.configuration.save();
    CHECK(robot.content(overridden ? "Home/body/Bob/Offsets.json" : "default/body/Bob/Offsets.json")["headYaw"] == 1.5);
    Configuration again{robot.folder.path(), robot.names, writeAtomically};
    again.mount("Motion.Offsets", "Offsets.json", RobotPart::body);
    json keys;
    again.readKeys("Motion.Offsets", keys);
    CHECK(keys["headYaw"] == 1.5);
  }
}

TEST_CASE("a save is undone once, comments included") {
  // Proves that the previous file is restored byte for byte, that the keys follow, and that a second undo is refused
  // until the next save.
  ConfiguredRobot robot;
  const std::string before = "// by hand\n{\"headYaw\": 1.0}";
  robot.file("default/body/Bob/Offsets.json", before);
  robot.configuration.mount("Motion.Offsets", "Offsets.json", RobotPart::body);
  CHECK(refusal([&] { robot.configuration.undo("Motion.Offsets"); }) ==
        "Motion.Offsets: nothing was saved that could be undone");
  robot.configuration.set("Motion.Offsets", "headYaw", 2.0);
  robot.configuration.save();
  robot.configuration.undo("Motion.Offsets");
  CHECK(readFile(robot.path("default/body/Bob/Offsets.json")) == before);
  CHECK(robot.readKeys("Motion.Offsets")["headYaw"] == 1.0);
  CHECK(refusal([&] { robot.configuration.undo("Motion.Offsets"); }) ==
        "Motion.Offsets: nothing was saved that could be undone");
  CHECK(robot.readKeys("Motion.Offsets")["headYaw"] == 1.0);
  robot.configuration.set("Motion.Offsets", "headYaw", 3.0);
  robot.configuration.save();
  robot.configuration.undo("Motion.Offsets");
  CHECK(robot.readKeys("Motion.Offsets")["headYaw"] == 1.0);
}

TEST_CASE("what is kept together goes back together, whoever saved one of it in between") {
  // Proves that saving one mount, by name or with all changes, also saves its partner, so that undoing either reverts
  // exactly that save; other mounts are not affected.
  for (const bool byName : {true, false}) {
    ConfiguredRobot robot;
    for (const std::string name : {"Offsets", "Cameras", "Other"}) {
      robot.file("default/head/default/" + name + ".json", R"({"value": 0})");
      robot.configuration.mount(name, name + ".json", RobotPart::head);
    }
    robot.configuration.saveTogether({"Offsets", "Cameras", "Absent"});
    robot.configuration.set("Offsets", "value", 1);
    robot.configuration.set("Cameras", "value", 1);
    robot.configuration.save("Offsets"); // by a calibration
    robot.configuration.set("Cameras", "value", 2);
    byName ? robot.configuration.save("Cameras") : robot.configuration.save(); // by another client in between
    robot.configuration.undo("Offsets");
    CHECK(robot.readKeys("Cameras")["value"] == 1);
    CHECK(robot.readKeys("Offsets")["value"] == 1);
    CHECK_THROWS_AS(robot.configuration.undo("Cameras"), ConfigurationError);
    CHECK_THROWS_AS(robot.configuration.undo("Other"), ConfigurationError);
  }
}

TEST_CASE("orders are never saved, and all else is written elsewhere as it would be saved") {
  // Proves it for a command key; writeTo includes unsaved changes but no secrets.
  ConfiguredRobot robot;
  robot.file("default/head/default/Runner.json", R"({"run": "", "repeats": 1})");
  robot.file("default/access.json", R"({"secret": "psst"})");
  robot.configuration.mount("Brain.Runner", "Runner.json", RobotPart::head, {}, {"run"});
  robot.configuration.set("Brain.Runner", "run", "left leg");
  robot.configuration.set("Brain.Runner", "repeats", 2);
  const TemporaryFolder other;
  robot.configuration.writeTo(other.path());
  CHECK_FALSE(std::filesystem::exists(robot.path("default/head/Ada/Runner.json")));
  CHECK_FALSE(std::filesystem::exists(other.path() / "location/default/access.json"));
  Configuration copy{other.path(), robot.names, writeAtomically};
  copy.mount("Brain.Runner", "Runner.json", RobotPart::head);
  json keys;
  copy.readKeys("Brain.Runner", keys);
  CHECK(keys == json{{"run", ""}, {"repeats", 2}});
  robot.configuration.save();
  CHECK(robot.content("default/head/Ada/Runner.json") == json{{"repeats", 2}});
}

TEST_CASE("a save that changes nothing leaves what an undo goes back to", "[slow]") {
  // Proves it for values restored before saving, for saving an unchanged mount by name, and for a value that its file
  // has received meanwhile.
  for (const std::string way : {"put back", "saved already", "in the file"}) {
    ConfiguredRobot robot;
    for (const std::string name : {"Offsets", "Cameras", "Other"}) {
      robot.file("default/head/default/" + name + ".json", R"({"value": 0})");
      robot.configuration.mount(name, name + ".json", RobotPart::head);
    }
    robot.configuration.saveTogether({"Offsets", "Cameras"});
    robot.configuration.set("Offsets", "value", 1);
    robot.configuration.save("Offsets"); // by a calibration
    if (way == "put back") {
      robot.configuration.set("Offsets", "value", 2); // a calibration that is rejected
      robot.configuration.set("Offsets", "value", 1);
    } else if (way == "in the file") {
      robot.configuration.set("Offsets", "value", 2);
      robot.file("default/head/Ada/Offsets.json", R"({"value": 2})");
    } else {
      robot.configuration.save("Cameras");
    }
    robot.configuration.set("Other", "value", 3);
    robot.configuration.save();
    CHECK(robot.configuration.isSaved("Offsets"));
    robot.configuration.undo("Offsets");
    CHECK(robot.readKeys("Offsets")["value"] == 0);
    CHECK(robot.content("default/head/Ada/Other.json")["value"] == 3);
  }
}

TEST_CASE("what is put back to what the files say counts as saved") {
  // Proves it key by key, and that no file is created for the robot.
  ConfiguredRobot robot;
  robot.file("default/body/default/Offsets.json", R"({"knee": 0, "hip": [1, 2]})");
  robot.configuration.mount("Offsets", "Offsets.json", RobotPart::body);
  robot.configuration.set("Offsets", "knee", 1);
  robot.configuration.set("Offsets", "hip[1]", 3);
  robot.configuration.set("Offsets", "knee", 0);
  CHECK_FALSE(robot.configuration.isSaved("Offsets"));
  robot.configuration.set("Offsets", "hip[1]", 2);
  CHECK(robot.configuration.isSaved("Offsets"));
  robot.configuration.save("Offsets");
  CHECK_FALSE(std::filesystem::exists(robot.path("default/body/Bob/Offsets.json")));
}

TEST_CASE("what is shipped stays as it is when what a robot learns is saved beside it") {
  // Proves it for saves, an undo and an interrupted save: the shipped folder is unchanged byte for byte, the next start
  // restores the learned values, and a newer shipped file provides all other keys.
  ConfiguredRobot robot;
  const auto learned = robot.folder.path() / "learned", shipped = robot.folder.path() / "shipped";
  robot.file("default/body/default/Offsets.json", R"({"knee": 0, "hip": 1})");
  robot.file("Home/body/default/Mounts.json", R"({"pitch": 0})");
  robot.file("default/sdk.json", R"({"network.basePort": 2000, "other": 0})");
  std::filesystem::create_directory(shipped);
  std::filesystem::rename(robot.folder.path() / "location", shipped / "location");
  const auto bytes = [](const std::filesystem::path& root) {
    std::map<std::string, std::string> all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator{root}) {
      all[entry.path().string()] = entry.is_directory() ? "" : readFile(entry.path());
    }
    return all;
  };
  const auto open = [&](const FileWriter& writer) {
    auto configuration = std::make_unique<Configuration>(ConfigurationFolders{shipped, learned}, robot.names, writer);
    configuration->mount("Offsets", "Offsets.json", RobotPart::body);
    configuration->mount("Mounts", "Mounts.json", RobotPart::body);
    configuration->mount("Sdk", "sdk.json", RobotPart::none);
    configuration->saveTogether({"Offsets", "Mounts"});
    return configuration;
  };
  const auto values = [](const Configuration& configuration) {
    json offsets, mounts;
    configuration.readKeys("Offsets", offsets);
    configuration.readKeys("Mounts", mounts);
    return json{offsets["knee"], offsets["hip"], mounts["pitch"]};
  };
  const auto before = bytes(shipped);
  auto configuration = open(writeAtomically);
  CHECK_FALSE(std::filesystem::exists(learned));
  configuration->set("Offsets", "knee", 2);
  configuration->set("Mounts", "pitch", 3);
  configuration->set("Sdk", "network.basePort", 3000);
  configuration->save();
  CHECK(json::parse(readFile(learned / "location/default/body/Bob/Offsets.json")) == json{{"knee", 2}});
  CHECK(json::parse(readFile(learned / "location/Home/body/Bob/Mounts.json")) == json{{"pitch", 3}});
  CHECK(readSocketSettings({shipped, learned}, "Ada").debugPort == 3001);
  CHECK(values(*open(writeAtomically)) == json{2, 1, 3});
  configuration->set("Offsets", "knee", 4);
  configuration->save();
  const TemporaryFolder copy;
  configuration->set("Offsets", "knee", 5);
  std::filesystem::create_directories(learned / "runs");
  writeAtomically(learned / "runs/head.json", "{}"); // of the robot's history, which grows
  configuration->writeTo(copy.path());
  CHECK_FALSE(std::filesystem::exists(copy.path() / "runs"));
  CHECK(json::parse(readFile(copy.path() / "location/default/sdk.json")) ==
        json{{"network.basePort", 3000}, {"other", 0}});
  Configuration one{copy.path(), robot.names, writeAtomically};
  one.mount("Offsets", "Offsets.json", RobotPart::body);
  one.mount("Mounts", "Mounts.json", RobotPart::body);
  CHECK(values(one) == json{5, 1, 3});
  configuration->undo("Mounts");
  CHECK(values(*configuration) == json{2, 1, 3});
  int left = 1; // number of writes before the failure: the journal
  configuration = open([&](const std::filesystem::path& file, std::string_view content) {
    if (left-- <= 0) {
      throw std::runtime_error{"the power is off"};
    }
    writeAtomically(file, content);
  });
  configuration->set("Offsets", "knee", 6);
  CHECK_THROWS_AS(configuration->save(), std::runtime_error);
  CHECK(values(*open(writeAtomically)) == json{6, 1, 3});
  CHECK(bytes(shipped) == before);
  writeAtomically(shipped / "location/default/body/default/Offsets.json", R"({"knee": 0, "hip": 7})");
  CHECK(values(*open(writeAtomically)) == json{6, 7, 3});
}

TEST_CASE("a save that has failed is not finished by a copy of the configuration") {
  // Proves that the journal is not copied: applied elsewhere, it would write this robot's files.
  const ConfiguredRobot robot;
  robot.file("default/head/default/Offsets.json", R"({"value": 0})");
  const auto writer = [&](const std::filesystem::path& file, std::string_view content) {
    if (file.filename() == "Offsets.json" && file.string().rfind(robot.folder.path().string(), 0) == 0) {
      throw std::runtime_error{"the disk is full"};
    }
    writeAtomically(file, content);
  };
  Configuration configuration{robot.folder.path(), robot.names, writer};
  configuration.mount("Offsets", "Offsets.json", RobotPart::head);
  configuration.set("Offsets", "value", 1);
  CHECK_THROWS_AS(configuration.save(), std::runtime_error);
  REQUIRE(std::filesystem::exists(robot.path("unfinished-save.json")));
  const TemporaryFolder other;
  configuration.writeTo(other.path());
  Configuration copy{other.path(), robot.names, writeAtomically};
  copy.mount("Offsets", "Offsets.json", RobotPart::head);
  json keys;
  copy.readKeys("Offsets", keys);
  CHECK(keys["value"] == 1);
  CHECK_FALSE(std::filesystem::exists(robot.path("default/head/Ada/Offsets.json")));
}

TEST_CASE("what is saved together is old or new together, wherever the program ends", "[slow]") {
  // Proves it for an interruption after every write of a save and of an undo: the next start either completes the
  // journal or finds no change. An unchanged mount is not affected.
  for (const bool undone : {false, true}) {
    for (int writes = 0; writes <= (undone ? 3 : 6); ++writes) {
      ConfiguredRobot robot;
      int left = 1000;
      const auto writer = [&](const std::filesystem::path& file, std::string_view content) {
        if (left-- <= 0) {
          throw std::runtime_error{"the power is off"};
        }
        writeAtomically(file, content);
      };
      robot.file("default/body/default/Offsets.json", R"({"knee": 0})");
      robot.file("default/head/default/Cameras.json", R"({"pitch": 0})");
      robot.file("default/head/default/Other.json", R"({"kept": 0})");
      const auto open = [&] {
        auto configuration = std::make_unique<Configuration>(robot.folder.path(), robot.names, writer);
        configuration->mount("Offsets", "Offsets.json", RobotPart::body);
        configuration->mount("Cameras", "Cameras.json", RobotPart::head);
        configuration->mount("Other", "Other.json", RobotPart::head);
        configuration->saveTogether({"Offsets", "Cameras", "Other"});
        return configuration;
      };
      auto configuration = open();
      const auto change = [&](int value) {
        configuration->set("Offsets", "knee", value);
        configuration->set("Cameras", "pitch", value);
        configuration->save("Offsets");
      };
      change(1);
      left = writes;
      CHECK_THROWS_AS(undone ? configuration->undo("Cameras") : change(2), std::runtime_error);
      left = 1000;
      configuration = open();
      json offsets, cameras, other;
      configuration->readKeys("Offsets", offsets);
      configuration->readKeys("Cameras", cameras);
      configuration->readKeys("Other", other);
      CHECK(offsets["knee"] == cameras["pitch"]);
      CHECK(offsets["knee"] == (writes == 0 ? 1 : undone ? 0 : 2));
      CHECK(other["kept"] == 0);
      CHECK_FALSE(std::filesystem::exists(robot.path("unfinished-save.json")));
    }
  }
}

TEST_CASE("keys may hold dots, and places that do not exist cannot be set") {
  // Proves path parsing and the refusals' messages; a refused value changes nothing.
  ConfiguredRobot robot;
  robot.file("default/sdk.json", R"({"network.basePort": 12440, "network": {"basePort": 1, "a.b": [5, {"c": 6}]}})");
  robot.configuration.mount("tuhhSDK.base", "sdk.json", RobotPart::none, [](const std::string&, const json& value) {
    if (value == 13) {
      throw ConfigurationError{"thirteen is refused"};
    }
  });
  robot.configuration.set("tuhhSDK.base", "network.basePort", 1);
  robot.configuration.set("tuhhSDK.base", "network.a.b[1].c", 7);
  const json expected = json::parse(R"({"network.basePort": 1, "network": {"basePort": 1, "a.b": [5, {"c": 7}]}})");
  CHECK(robot.readKeys("tuhhSDK.base") == expected);
  for (const char* path : {"network.a.b[2]", "network.a.b[-1]", "network.a.b[1", "network.a.b[]", "port", "", ".",
                           "[0]", "network.", "network.basePort.x"}) {
    CHECK(refusal([&] { robot.configuration.set("tuhhSDK.base", path, 7); }) ==
          fmt::format("tuhhSDK.base: there is no {} to set; keys cannot be added and lists cannot grow", path));
  }
  CHECK(refusal([&] { robot.configuration.set("tuhhSDK.base", "network.basePort", 13); }) == "thirteen is refused");
  CHECK(refusal([&] { robot.configuration.set("Brain.Nothing", "a", 13); }) ==
        "there is no mount Brain.Nothing; ask for the list of mounts");
  CHECK(robot.readKeys("tuhhSDK.base") == expected);
}

TEST_CASE("published keys are served beside a file's and never saved") {
  // Proves it for the keys that MATE requests on connecting.
  ConfiguredRobot robot;
  robot.file("default/sdk.json", R"({"location": "Home"})");
  robot.configuration.mount("tuhhSDK.base", "sdk.json", RobotPart::none);
  robot.configuration.publish("tuhhSDK.base", "NaoInfo.headName", "Ada");
  CHECK(robot.readKeys("tuhhSDK.base") == json{{"location", "Home"}, {"NaoInfo.headName", "Ada"}});
  CHECK(refusal([&] { robot.configuration.set("tuhhSDK.base", "NaoInfo.headName", "Eve"); }) != "not refused");
  robot.configuration.set("tuhhSDK.base", "location", "default");
  robot.configuration.save();
  CHECK(robot.content("default/sdk.json") == json{{"location", "default"}});
}

TEST_CASE("a configuration file has a limited size and is a regular file") {
  // Proves the size at its boundary, with files that take no space on the disk: the largest one is read, and refused
  // for its content alone. A pipe is refused instead of waited for.
  ConfiguredRobot robot;
  robot.file("default/Large.json", "");
  const auto path = robot.path("default/Large.json");
  const auto mounting = [&] {
    return refusal([&] { robot.configuration.mount("Brain.Large", "Large.json", RobotPart::head); });
  };
  std::filesystem::resize_file(path, largestConfigurationFile + 1);
  CHECK(mounting() == path.string() + ": expected at most 67108864 bytes in a configuration file, found 67108865");
  std::filesystem::resize_file(path, largestConfigurationFile);
  CHECK(mounting().rfind(path.string() + ": expected valid JSON", 0) == 0);
  std::filesystem::remove(path);
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  CHECK(mounting() == path.string() + ": expected a file, found a folder, pipe or device");
}

TEST_CASE("broken files are refused with a sentence that names them") {
  // Pins the messages: file, line, what was expected.
  ConfiguredRobot robot;
  const auto mounting = [&](const std::string& content) {
    robot.file("default/Broken.json", content);
    return refusal([&] { robot.configuration.mount("Brain.Broken", "Broken.json", RobotPart::head); });
  };
  const std::string name = robot.path("default/Broken.json").string();
  CHECK(mounting("{\"a\": }").rfind(name + ": expected valid JSON, found a parse error at line 1, column 7", 0) == 0);
  CHECK(mounting("[1]") == name + ": expected an object with keys at its top level");
  CHECK(mounting("{} // gr\xfc\xdf dich") == name + ": expected text in UTF-8, found other bytes; save it as UTF-8");
  CHECK(mounting("").rfind(name + ": expected valid JSON", 0) == 0);
  CHECK(refusal([] {
          layerFiles(std::filesystem::path{"/c"}, "a.json", RobotPart::head, {"default", "../x", "Bob"});
        }) == "the robot's head is called \"../x\"; expected a name that can be a folder's");
}

} // namespace naocal
