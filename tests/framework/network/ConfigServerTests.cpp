#include "ConfigNumbers.hpp"
#include "framework/ShownRobot.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace naocal {
namespace {

using nlohmann::json;

json change(const char* mount, const char* key, const json& value) {
  return {{{"mp", mount}, {"key", key}, {"value", value}}};
}

/// Requests a mount's keys; the reply follows the processing of earlier messages.
json keysOf(MateClient& client, const std::string& mount) {
  client.send(getKeys, mount);
  const json answer = client.receiveJson(sendKeys);
  CHECK(answer["mountPoint"] == mount);
  json keys = json::object();
  for (const json& entry : answer["keys"]) {
    keys[entry["key"].get<std::string>()] = entry["value"];
  }
  return keys;
}

SocketSettings wide(const std::string& secret, bool trusted = false) {
  SocketSettings settings;
  settings.access = {"0.0.0.0", secret, trusted};
  return settings;
}

} // namespace

TEST_CASE("what MATE asks for when it connects is answered at once") {
  // Proves the list of mounts with their files, the keys of tuhhSDK.base, and an empty list for an unknown mount.
  ShownRobot robot;
  auto client = robot.config();
  client.send(getMounts);
  const json mounts = client.receiveJson(sendMounts)["keys"];
  REQUIRE(mounts.size() == 2);
  CHECK(mounts[0] ==
        json{{"key", "Brain.Counter"}, {"filename", robot.robot.path("default/head/default/Counter.json").string()}});
  CHECK(keysOf(client, "tuhhSDK.base") ==
        json{{"NaoInfo.bodyName", "Bob"}, {"NaoInfo.headName", "Ada"}, {"location", "Home"}});
  CHECK(keysOf(client, "Brain.Nothing").empty());
}

TEST_CASE("a mount's keys have the bytes of HULKs' protocol") {
  // Compares every byte with a message assembled by hand from the protocol's description.
  ShownRobot robot;
  auto client = robot.config();
  client.send(getKeys, "Brain.Counter");
  const auto received = client.receive();
  REQUIRE(received);
  const std::string body = R"({"keys":[{"key":"factor","value":0.5},{"key":"list","value":[1,2]}],)"
                           R"("mountPoint":"Brain.Counter"})"
                           "\n";
  CHECK(received->type == sendKeys);
  CHECK(received->body == body);
}

TEST_CASE("a second process does not take the first one's UNIX sockets") {
  // Proves the refusal's message, and that the first process can still be reached.
  ShownRobot robot;
  SocketSettings second = robot.settings;
  second.tcp = false;
  CHECK_THROWS_WITH((SocketServers{second, {}, robot.robot.configuration, Clock::now(), [](std::string_view) {}}),
                    Catch::Contains("sockets/debug: another process listens there; stop what listens there"));
  auto client = MateClient::config(robot.settings.unixFolder / "config");
  client.send(getMounts);
  CHECK(client.receive().has_value());
}

TEST_CASE("a value set over the network reaches the module and is saved") {
  // Proves the path from the socket to the next cycle and to the robot's own file, with two clients, and undo.
  ShownRobot robot;
  auto one = robot.config();
  auto two = MateClient::config(robot.settings.unixFolder / "config");
  auto debug = robot.debug();
  debug.send(0, "Brain.Counter.scaled");
  debug.send(3);
  debug.receive(4);
  robot.brain.cycle();
  CHECK(debug.receiveJson(2).at(0)["value"][0] == 0.5);
  one.send(set, change("Brain.Counter", "factor", 2.0).dump());
  CHECK(keysOf(one, "Brain.Counter")["factor"] == 2.0);
  robot.brain.cycle();
  CHECK(debug.receiveJson(2).at(0)["value"][0] == 4.0);
  two.send(set, change("Brain.Counter", "list[1]", 7).dump());
  two.send(save);
  CHECK(keysOf(two, "Brain.Counter")["list"] == json{1, 7});
  CHECK(robot.robot.content("default/head/Ada/Counter.json") == json{{"factor", 2.0}, {"list", {1, 7}}});
  one.send(set, change("naocal.configuration", "undo", "Brain.Counter").dump());
  CHECK(keysOf(one, "Brain.Counter") == json{{"factor", 0.5}, {"list", {1, 2}}});
  robot.brain.cycle();
  CHECK(debug.receiveJson(2).at(0)["value"][0] == 1.5);
}

TEST_CASE("a client's last will is done when its connection ends, unless another client has taken over") {
  // Proves both, that an invalid last will is logged, and that the last will is not executed earlier.
  ShownRobot robot;
  auto other = robot.config();
  const auto leave = [&](double value, const std::function<void(MateClient&)>& meanwhile) {
    auto client = robot.config();
    client.send(set, change("Brain.Counter", "factor", 2.0).dump());
    client.send(set, change("naocal.configuration", "lastWill", change("Brain.Counter", "factor", value)).dump());
    CHECK(keysOf(client, "Brain.Counter")["factor"] == 2.0);
    meanwhile(client);
  };
  const auto becomes = [&](double value) {
    for (int i = 0; i < 1000 && keysOf(other, "Brain.Counter")["factor"] != value; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds{2});
    }
    return keysOf(other, "Brain.Counter")["factor"] == value;
  };
  leave(7.0, [](MateClient&) {});
  CHECK(becomes(7));
  leave(8.0, [&](MateClient&) {
    other.send(set, change("Brain.Counter", "factor", 3.0).dump());
    CHECK(becomes(3));
  });
  std::this_thread::sleep_for(std::chrono::milliseconds{50});
  CHECK(becomes(3));
  leave(9.0, [](MateClient& client) {
    client.send(set, change("naocal.configuration", "lastWill", json::array({1})).dump());
  });
  CHECK(becomes(9));
  CHECK(robot.isLogged("setting lastWill of naocal.configuration failed"));
}

TEST_CASE("a value that cannot be set is a logged sentence and the others are set") {
  // Pins the messages. The client stays connected, as MATE also sets keys that no module has.
  ShownRobot robot;
  auto client = robot.config();
  json changes = change("Brain.Counter", "factor", "much");
  changes.push_back(change("Brain.Counter", "useEffectiveYawVelocity", true)[0]);
  changes.push_back(change("Brain.Nothing", "a", 1)[0]);
  changes.push_back(change("Brain.Counter", "list[0]", 5)[0]);
  client.send(set, changes.dump());
  CHECK(keysOf(client, "Brain.Counter") == json{{"factor", 0.5}, {"list", {5, 2}}});
  CHECK(robot.hasLogged("Client 127.0.0.1: setting factor of Brain.Counter failed: Brain.Counter: factor: expected a "
                        "number, found \"much\"."));
  CHECK(robot.hasLogged("there is no useEffectiveYawVelocity to set"));
  CHECK(robot.hasLogged("there is no mount Brain.Nothing"));
}

TEST_CASE("a robot that listens wide lets nobody change it or look without the secret") {
  // Proves that the secret unlocks both sockets for its address, only while its connection lasts, and that another
  // config connection from that address still needs it.
  ShownRobot robot{wide("open sesame")};
  auto debug = robot.debug();
  debug.send(0, "Brain.count");
  debug.send(3);
  CHECK(debug.receiveJson(4)["keys"].empty());
  robot.brain.cycle();
  auto other = robot.config();
  other.send(set, change("Brain.Counter", "factor", 3.0).dump());
  other.send(save);
  CHECK(keysOf(other, "Brain.Counter")["factor"] == 0.5);
  CHECK(robot.hasLogged("what it asks for is refused until it sends the secret of access.json: setting factor of "
                        "Brain.Counter."));
  CHECK_FALSE(robot.hasLogged("access.json: saving the configuration")); // logged once
  {
    auto owner = robot.config();
    owner.send(set, change("naocal.access", "secret", "open sesame").dump());
    owner.send(set, change("Brain.Counter", "factor", 3.0).dump());
    CHECK(keysOf(owner, "Brain.Counter")["factor"] == 3.0);
    other.send(set, change("Brain.Counter", "factor", 4.0).dump());
    CHECK(keysOf(other, "Brain.Counter")["factor"] == 3.0);
    CHECK(debug.receiveJson(4)["keys"].size() == 6); // sent without a request
    robot.brain.cycle();
    CHECK(debug.receiveJson(2).at(0)["value"] == 2);
  }
  bool closed = false;
  for (int i = 0; i < 1000 && !closed; ++i) { // until the server has noticed the disconnection
    debug.send(3);
    closed = debug.receiveJson(4)["keys"].empty();
  }
  CHECK(closed);
}

TEST_CASE("the noise of strangers is logged once per address and cause, whatever names they choose") {
  // Proves it for 30 connections that set and break as many different things: two sentences, through real sockets.
  ShownRobot robot{wide("open sesame")};
  for (int i = 0; i < 30; ++i) {
    auto stranger = robot.config();
    stranger.send(set, change(fmt::format("Noise{}", i).c_str(), fmt::format("key: {}", i).c_str(), i).dump());
    CHECK(keysOf(stranger, "Brain.Counter")["factor"] == 0.5);
    stranger.send(set, fmt::format("{{\"noise\": {}", i));
    CHECK(stranger.isClosed());
  }
  const std::lock_guard lock{robot.mutex};
  REQUIRE(robot.sentences.size() == 2);
  CHECK(robot.sentences[0] == "Client 127.0.0.1: what it asks for is refused until it sends the secret of access.json: "
                              "setting key: 0 of Noise0.");
  CHECK(robot.sentences[1].starts_with("Client 127.0.0.1: expected [{\"mp\": mount"));
}

TEST_CASE("a wrong secret closes the connection") {
  // Proves it for another text, a prefix, an empty text, a number and a repetition.
  ShownRobot robot{wide("open sesame")};
  for (const json& secret : {json("open"), json("open sesamf"), json(""), json(7), json("open sesameopen sesame")}) {
    auto client = robot.config();
    client.send(set, change("naocal.access", "secret", secret).dump());
    CHECK(client.isClosed());
  }
  CHECK(robot.isLogged("expected the secret of access.json, found another one; the connection was closed."));
}

TEST_CASE("whoever has not sent the secret keeps no place from those who have it") {
  // Proves it with two places: clients without the secret are dropped for the owner and for each other; owners keep
  // theirs.
  SocketSettings two = wide("open sesame");
  two.maxClients = 2;
  two.keptPlaces = 0;
  ShownRobot robot{two};
  const auto answers = [](MateClient& client) { return keysOf(client, "Brain.Counter").contains("factor"); };
  std::vector<MateClient> strangers;
  for (int i = 0; i < 2; ++i) {
    strangers.push_back(robot.config());
    REQUIRE(answers(strangers.back()));
  }
  auto owner = robot.config();
  owner.send(set, change("naocal.access", "secret", "open sesame").dump());
  CHECK(answers(owner));
  for (int i = 0; i < 5; ++i) {
    auto another = robot.config();
    CHECK(answers(another));
    CHECK(answers(owner));
  }
  auto second = robot.config();
  second.send(set, change("naocal.access", "secret", "open sesame").dump());
  CHECK(answers(second));
  CHECK(robot.config().isClosed());
  CHECK(robot.isLogged("2 clients are connected already, which is the limit"));
}

TEST_CASE("on a trusted network plain MATE may do everything") {
  // Proves the setting, and that UNIX sockets need no secret.
  ShownRobot trusting{wide("", true)};
  auto client = trusting.config();
  client.send(set, change("Brain.Counter", "factor", 3.0).dump());
  CHECK(keysOf(client, "Brain.Counter")["factor"] == 3.0);
  ShownRobot robot{wide("open sesame")};
  auto local = MateClient::config(robot.settings.unixFolder / "config");
  local.send(set, change("Brain.Counter", "factor", 3.0).dump());
  CHECK(keysOf(local, "Brain.Counter")["factor"] == 3.0);
}

TEST_CASE("a robot does not listen wide without a secret") {
  // Pins the refusals of access.json. That no client can read the secret is not tested here.
  const ConfiguredRobot robot;
  const auto reading = [&](const std::string& content) {
    robot.file("default/access.json", content);
    try {
      return readAccess(robot.folder.path()).address;
    } catch (const std::exception& error) {
      return std::string{error.what()}.substr(robot.path("default/access.json").string().size());
    }
  };
  CHECK(readAccess(robot.folder.path()).address == "127.0.0.1");
  CHECK(reading(R"({"address": "0.0.0.0", "secret": "s"})") == "0.0.0.0");
  CHECK(reading(R"({"address": "0.0.0.0", "trustedNetwork": true})") == "0.0.0.0");
  CHECK(reading(R"({"address": "0.0.0.0"})") ==
        ": listening on 0.0.0.0 lets others reach the robot; give a secret, or set trustedNetwork to true if everybody "
        "there may move it");
  CHECK(reading(R"({"adress": "0.0.0.0"})") ==
        ": adress: expected only address and secret (texts) and trustedNetwork (true or false)");
}

TEST_CASE("where the sockets listen is read from HULKs' keys") {
  // Proves ports, switch and folder, and the message for a port in use.
  const ConfiguredRobot robot;
  robot.file("default/sdk.json", R"({"network.basePort": 2000, "network.enableDebugTCPTransport": false,
                                     "local.unixSocketDirectory": "/run/robot/"})");
  const auto settings = readSocketSettings(robot.folder.path(), "Ada");
  CHECK(settings.debugPort == 2001);
  CHECK(settings.configPort == 2002);
  CHECK_FALSE(settings.tcp);
  CHECK(settings.unixFolder == "/run/robot/Ada");
  ShownRobot first;
  SocketSettings same;
  same.debugPort = first.sockets->debugPort();
  CHECK_THROWS_WITH(SocketServers(same, {}, first.robot.configuration, first.base, [](auto) {}),
                    Catch::Contains("cannot listen on 127.0.0.1 port") && Catch::Contains("already in use"));
}

} // namespace naocal
