#include "robot/Robots.hpp"

#include "FakeRobot.hpp"
#include "robot/LiveDetection.hpp"
#include "robot/RobotClient.hpp"

#include "framework/ShownRobot.hpp"
#include "io/InputError.hpp"

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace naocal {
namespace {

using Json = nlohmann::json;

/// A panel that stores its messages, and the io_context that runs it.
struct Listening {
  /// Runs until a message of this kind satisfies the predicate; returns the first such message. Null after five
  /// minutes.
  template <class Test> Json heard(const std::string& kind, const Test& test) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes{5};
    for (std::size_t i = 0; std::chrono::steady_clock::now() < end;
         context.run_one_for(std::chrono::milliseconds{50})) {
      for (; i < told.size(); ++i) {
        if (told[i]["kind"] == kind && test(told[i])) {
          return told[i];
        }
      }
    }
    return nullptr;
  }
  Json heard(const std::string& kind) {
    return heard(kind, [](const Json&) { return true; });
  }
  /// Runs until the predicate holds, at most five minutes.
  template <class Test> void runUntil(const Test& holds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes{5};
    while (!holds() && std::chrono::steady_clock::now() < end) {
      context.run_one_for(std::chrono::milliseconds{50});
    }
  }
  Json connected(const std::string& robot) {
    robots.connect(robot);
    return heard("robot", [](const Json& state) { return state["connected"].get<bool>(); });
  }
  void keep(const std::string& json) { told.push_back(Json::parse(json)); }

  boost::asio::io_context context;
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> goesOn{context.get_executor()};
  std::vector<Json> told;
  std::vector<std::string> pictures;
  Robots robots{context,
                {[this](const std::string& json) { keep(json); },
                 [this](std::size_t, const std::string& json) { keep(json); },
                 [this](std::size_t, const std::string& json) { keep(json); },
                 [this](std::size_t, const std::string& bytes) {
                   pictures.push_back(bytes.substr(bytes.find('\n') + 1));
                   keep(bytes.substr(0, bytes.find('\n')));
                 },
                 {}},
                std::chrono::milliseconds{200}};
};

bool hasFactor(const Json& told, double wanted) {
  const Json& list = told["body"]["keys"];
  return std::any_of(list.begin(), list.end(),
                     [&](const Json& entry) { return entry["key"] == "factor" && entry["value"] == wanted; });
}

} // namespace

TEST_CASE("a robot's keys, values, pictures and parameters reach the panel that asked") {
  // Proves it with the robot's own servers over UNIX sockets; keys without a subscription are not sent.
  ShownRobot robot;
  Listening panel;
  const std::string here = robot.settings.unixFolder.string();
  REQUIRE(panel.connected(here)["sentence"] == "connected");
  CHECK(panel.heard("list")["body"]["keys"].size() == 6);
  CHECK_FALSE(panel.heard("mounts")["body"]["keys"].empty());

  for (const char* const key : {"Brain.count", "Brain.picture"}) {
    panel.robots.at(here, "subscribe").subscribe(key, 1);
  }
  panel.robots.at(here, "keys").requestKeys("Brain.Counter");
  const Json keys = panel.heard("keys")["body"];
  CHECK(keys["mountPoint"] == "Brain.Counter");
  for (int cycle = 0; cycle < 10000 && panel.pictures.empty(); ++cycle) {
    robot.brain.cycle();
    panel.context.run_for(std::chrono::milliseconds{20});
  }
  const Json update = panel.heard("update");
  CHECK(update["values"].size() == 1);
  CHECK(update["values"][0]["key"] == "Brain.count");
  REQUIRE_FALSE(panel.pictures.empty());
  CHECK(panel.heard("picture")["width"] == 640);
  CHECK(panel.pictures.front().size() == 100);
}

TEST_CASE("a parameter that is set is set on the robot") {
  // Proves SET by reading the value back; saving is tested with the robot.
  ShownRobot robot;
  Listening panel;
  const std::string here = robot.settings.unixFolder.string();
  REQUIRE(panel.connected(here)["sentence"] == "connected");
  panel.robots.at(here, "set").set(Json::array({{{"mp", "Brain.Counter"}, {"key", "factor"}, {"value", 2.5}}}));
  panel.robots.at(here, "keys").requestKeys("Brain.Counter");
  CHECK_FALSE(panel.heard("keys", [](const Json& told) { return hasFactor(told, 2.5); }).is_null());
}

TEST_CASE("a robot ends what it does for panels that have gone, and is connected again to one that comes", "[slow]") {
  // Proves that the last will is executed after the last panel has left, that a later panel sees its effect, and that
  // it is not executed while a panel remains or during a reload.
  ShownRobot robot;
  Listening panel;
  const std::string here = robot.settings.unixFolder.string();
  panel.robots.addPanel(1);
  panel.robots.addPanel(2);
  REQUIRE(panel.connected(here)["sentence"] == "connected");
  const Json last{{{"mp", "Brain.Counter"}, {"key", "factor"}, {"value", 7.5}}};
  panel.robots.at(here, "set")
      .set(Json::array({{{"mp", "naocal.configuration"}, {"key", "lastWill"}, {"value", last}}}));
  const auto isLeft = [](const Json& state) { return !state["connected"].get<bool>(); };
  panel.told.clear();
  panel.robots.removePanel(1);
  panel.context.run_for(std::chrono::milliseconds{500});
  panel.robots.removePanel(2);
  panel.robots.addPanel(3);
  panel.context.run_for(std::chrono::milliseconds{500});
  CHECK(std::none_of(panel.told.begin(), panel.told.end(),
                     [&](const Json& told) { return told["kind"] == "robot" && isLeft(told); }));

  panel.robots.removePanel(3);
  REQUIRE_FALSE(panel.heard("robot", isLeft).is_null());
  panel.context.run_for(std::chrono::milliseconds{50});
  panel.told.clear();
  panel.robots.addPanel(4);
  REQUIRE_FALSE(panel.heard("robot", [](const Json& state) { return state["connected"].get<bool>(); }).is_null());
  panel.robots.at(here, "keys").requestKeys("Brain.Counter");
  CHECK_FALSE(panel.heard("keys", [](const Json& told) { return hasFactor(told, 7.5); }).is_null());
}

TEST_CASE("a robot is asked for the keys of mounts that it listed only") {
  // Proves it for watching the cameras and for a panel's requests, before and after the robot's list has arrived: a
  // HULKs robot's service terminates on an unknown name.
  const TemporaryFolder folder;
  Listening panel;
  const std::string here = folder.path().string();
  const FakeRobot robot{panel.context, folder.path(), R"({"keys": [{"key": "Brain.Counter", "filename": ""}]})"};
  REQUIRE(panel.connected(here)["sentence"] == "connected");
  const auto ask = [&] {
    panel.robots.at(here, "watch").watch(1);
    for (const char* const mount : {"Brain.Counter", "Motion.JointCalibrationProvider"}) {
      panel.robots.at(here, "keys").requestKeys(mount);
    }
  };
  ask();
  REQUIRE_FALSE(panel.heard("mounts").is_null());
  ask();
  panel.runUntil([&] { return robot.keysAskedFor.size() >= 2; });
  panel.context.run_for(std::chrono::milliseconds{200}); // for messages that must not come
  CHECK(robot.keysAskedFor == std::vector<std::string>{"Brain.Counter", "Brain.Counter"});
}

TEST_CASE("a robot that is looked at is asked for its boards once it has listed that it has some") {
  // Proves that the request for boards is deferred until the robot has listed its mounts.
  const TemporaryFolder folder;
  Listening panel;
  const std::string here = folder.path().string();
  const FakeRobot robot{panel.context, folder.path(), R"({"keys": [{"key": "Brain.CalibrationRunner"}]})"};
  REQUIRE(panel.connected(here)["sentence"] == "connected");
  panel.robots.at(here, "watch").watch(1);
  REQUIRE_FALSE(panel.heard("mounts").is_null());
  panel.runUntil([&] { return !robot.keysAskedFor.empty(); });
  panel.context.run_for(std::chrono::milliseconds{200}); // for messages that must not come
  CHECK(robot.keysAskedFor == std::vector<std::string>{std::string{LiveDetection::boardsMount}});
}

TEST_CASE("a robot that comes back is connected and subscribed to again", "[slow]") {
  // Proves it for a robot process that is restarted; saving meanwhile is refused.
  TemporaryFolder folder;
  const std::filesystem::path here = folder.path() / "robot";
  Listening panel;
  {
    ShownRobot robot;
    std::filesystem::create_directory_symlink(robot.settings.unixFolder, here);
    REQUIRE(panel.connected(here.string())["sentence"] == "connected");
    panel.robots.at(here.string(), "subscribe").subscribe("Brain.count", 1);
  }
  CHECK_FALSE(
      panel.heard("robot", [](const Json& state) { return state["sentence"] == "closed the connection"; }).is_null());
  CHECK_THROWS_AS(panel.robots.at(here.string(), "save").save(), InputError);

  std::filesystem::remove(here);
  panel.told.clear();
  ShownRobot robot;
  std::filesystem::create_directory_symlink(robot.settings.unixFolder, here);
  CHECK_FALSE(panel.heard("robot", [](const Json& state) { return state["connected"].get<bool>(); }).is_null());
  Json update;
  for (int cycle = 0; cycle < 10000 && update.is_null(); ++cycle) {
    robot.brain.cycle();
    panel.context.run_for(std::chrono::milliseconds{20});
    const auto found =
        std::find_if(panel.told.begin(), panel.told.end(), [](const Json& told) { return told["kind"] == "update"; });
    update = found == panel.told.end() ? Json() : *found;
  }
  CHECK(update["values"][0]["key"] == "Brain.count");
}

TEST_CASE("a secret is sent after every reconnect, until the robot closes the connection because of it", "[slow]") {
  // Proves that a network that fails again before the robot has answered does not lose the secret.
  const TemporaryFolder folder;
  Listening panel;
  const std::string here = folder.path().string();
  FakeRobot robot{panel.context, folder.path(), R"({"keys": [{"key": "Brain.Counter", "filename": ""}]})"};
  REQUIRE(panel.connected(here)["sentence"] == "connected");
  REQUIRE_FALSE(panel.heard("mounts").is_null());
  panel.robots.at(here, "set").set(Json::array({{{"mp", "naocal.access"}, {"key", "secret"}, {"value", "sesame"}}}));
  for (std::size_t sent = 1; sent < 4; ++sent) {
    CAPTURE(sent);
    panel.runUntil([&] { return robot.settings.size() >= sent; });
    REQUIRE(robot.settings.size() == sent);
    CHECK(robot.settings.back().find("sesame") != std::string::npos);
    robot.isSilent = true;
    robot.closeDebug();
  }
  const auto isConnected = [](const Json& state) { return state["connected"].get<bool>(); };
  panel.runUntil([&] { return robot.settings.size() >= 4; });
  panel.told.clear();
  robot.closeConfig();
  REQUIRE_FALSE(panel.heard("robot", isConnected).is_null());
  panel.context.run_for(std::chrono::milliseconds{200}); // for a message that must not come
  CHECK(robot.settings.size() == 4);
}

TEST_CASE("whoever is no robot is told so, and the panel lives on") {
  // Proves it over TCP for servers with another protocol, another version, or an oversized frame.
  using namespace std::string_literals;
  const auto [answer, sentence] = GENERATE(table<std::string, std::string>(
      {{"HTTP/1.1 400 Bad Request\r\n\r\n", "does not speak HULKs' protocol (expected a frame that begins with DMSG)"},
       {"DMSG\x02\x04\0\0\0\0\0\0\0\0\0\0"s, "speaks another version of HULKs' protocol (expected 1, found 2)"},
       {"DMSG\x01\x04\0\0\x01\0\0\x02\0\0\0\0"s, "announced a frame of 33554433 bytes; at most 33554432 are taken"}}));
  Listening panel;
  using Tcp = boost::asio::ip::tcp;
  const auto loopback = boost::asio::ip::address_v4::loopback();
  std::optional<Tcp::acceptor> debug, config;
  std::uint16_t base = 23440;
  for (; !config && base < 33440; base = static_cast<std::uint16_t>(base + 10)) {
    try {
      debug.emplace(panel.context, Tcp::endpoint{loopback, static_cast<std::uint16_t>(base + 1)});
      config.emplace(panel.context, Tcp::endpoint{loopback, static_cast<std::uint16_t>(base + 2)});
      break;
    } catch (const boost::system::system_error&) { // port in use: tries the next ones
      debug.reset();
    }
  }
  REQUIRE(config);
  debug->async_accept([&bytes = answer](boost::system::error_code, Tcp::socket socket) {
    boost::system::error_code ignored;
    boost::asio::write(socket, boost::asio::buffer(bytes), ignored);
  });
  panel.robots.connect(fmt::format("127.0.0.1:{}", base));
  CHECK_FALSE(
      panel.heard("robot", [&wanted = sentence](const Json& state) { return state["sentence"] == wanted; }).is_null());
}

TEST_CASE("a robot's address is a host, a host with its base port, or a folder") {
  // Proves the accepted forms, and the refusal of others.
  CHECK(parseRobotAddress("nao21").basePort == 12440);
  CHECK(parseRobotAddress("10.1.24.31:13000").basePort == 13000);
  CHECK(parseRobotAddress("/tmp/sockets/Ada").folder == "/tmp/sockets/Ada");
  for (const char* const wrong :
       {"", ":12440", "nao21:", "nao21:0", "nao21:70000", "nao21:12a", "nao 21", "me@nao21"}) {
    CHECK_THROWS_AS(parseRobotAddress(wrong), InputError);
  }
}

} // namespace naocal
