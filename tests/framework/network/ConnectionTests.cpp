#include "framework/ShownRobot.hpp"

#include <catch2/catch.hpp>
#include <netinet/in.h>
#include <netinet/tcp.h>

namespace naocal {
namespace {

/// Socket option of the server's connection on a port of this process. The connection must have replied already.
int optionOfPeer(std::uint16_t listening, int level, int option) {
  int value = -1;
  for (int file = 0; file < 1024; ++file) {
    sockaddr_in local{}, remote{};
    socklen_t size = sizeof local;
    if (::getsockname(file, reinterpret_cast<sockaddr*>(&local), &size) != 0 || local.sin_family != AF_INET ||
        ntohs(local.sin_port) != listening) {
      continue;
    }
    size = sizeof remote;
    if (::getpeername(file, reinterpret_cast<sockaddr*>(&remote), &size) == 0) {
      size = sizeof value;
      ::getsockopt(file, level, option, &value, &size);
    }
  }
  return value;
}

} // namespace

TEST_CASE("only a client of the configuration is given up when the network confirms nothing for long") {
  // Pins the socket options: a debug client that pauses reading must not time out, although the system cannot tell it
  // from a lost one; a configuration client must, because of its last will. Both are probed while idle.
  ShownRobot robot;
  auto debug = robot.debug();
  auto config = robot.config();
  debug.send(3);
  REQUIRE(debug.receive(4));
  config.send(2, "Brain.Counter");
  REQUIRE(config.receive(4));
  const auto debugPort = robot.sockets->debugPort(), configPort = robot.sockets->configPort();
  CHECK(optionOfPeer(debugPort, IPPROTO_TCP, TCP_USER_TIMEOUT) == 0);
  CHECK(optionOfPeer(configPort, IPPROTO_TCP, TCP_USER_TIMEOUT) == 6000);
  for (const auto port : {debugPort, configPort}) {
    CHECK(optionOfPeer(port, SOL_SOCKET, SO_KEEPALIVE) == 1);
    CHECK(optionOfPeer(port, IPPROTO_TCP, TCP_KEEPIDLE) == 2);
  }
}

TEST_CASE("the system takes no megabytes for a client whose network is slow") {
  // Pins the option: a client counts as busy as soon as its network is, so that new data need not wait behind old
  // images.
  ShownRobot robot;
  auto debug = robot.debug();
  debug.send(3);
  REQUIRE(debug.receive(4));
  CHECK(optionOfPeer(robot.sockets->debugPort(), IPPROTO_TCP, TCP_NOTSENT_LOWAT) == 32768);
}

TEST_CASE("a client that nothing can be written to is closed with a sentence") {
  // Proves it for a client that has closed only its receiving half, so that the server's reads never end.
  ShownRobot robot;
  const int client = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  (robot.settings.unixFolder / "debug").string().copy(address.sun_path, sizeof address.sun_path - 1);
  REQUIRE(::connect(client, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  ::shutdown(client, SHUT_RD);
  const std::string request = robot.debug().frame(3, "");
  REQUIRE(::send(client, request.data(), request.size(), MSG_NOSIGNAL) == ssize_t(request.size()));
  CHECK(robot.isLogged("Client on this computer: what is sent to it cannot be written: Broken pipe; the connection was "
                       "closed."));
  ::close(client);
}

} // namespace naocal
