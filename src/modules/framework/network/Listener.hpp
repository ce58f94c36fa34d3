#pragma once

#include "framework/network/Connection.hpp"

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <filesystem>
#include <vector>

/// Heavy header (Boost.Asio): include it in Listener.cpp and Sockets.cpp only.
namespace naocal {

/// Number of clients of one server: `clients`, and `kept` further places that nobody holds for good, so that a client
/// that comes to stop the robot is never shut out.
struct Places {
  std::size_t clients, kept;
};

/// Accepts the clients of one server on any number of addresses, owns their connections, and closes silent ones.
///
/// When all places are taken, a new client takes one of, in this order: clients without the secret or a first message;
/// of clients that want nothing from the robot; of an address that has at least two more clients than the new one's.
/// In each case the address with the most clients gives a place first, and of its clients the one that has been silent
/// the longest. Only the first case applies for a new client that must send a secret. Otherwise it takes the place of
/// the longest silent of the `kept` clients that came last; it is closed if there are no such places.
class Listener {
public:
  Listener(boost::asio::io_context& context, Protocol& protocol, Places places, ClientLimits limits, Log log);
  ~Listener();

  /// Listens on an address and port; port 0 takes any free one. Returns the port. Throws ConfigurationError.
  std::uint16_t listenTcp(const std::string& address, std::uint16_t port);

  /// Listens on a UNIX socket with mode 0600; replaces the stale socket of a dead process. Throws ConfigurationError.
  void listenUnix(const std::filesystem::path& path);

private:
  /// A listening socket and its retry timer.
  struct Acceptor {
    boost::asio::basic_socket_acceptor<boost::asio::generic::stream_protocol> acceptor;
    boost::asio::steady_timer pause;
  };
  Acceptor& open(const boost::asio::generic::stream_protocol& protocol);
  void accept(Acceptor& door);
  void welcome(Socket socket);
  void makeRoom(const std::string& address); // for a new client; closes another one if all places are taken
  std::shared_ptr<Connection> leastNeeded(const std::string& address) const;
  void watchSilence();

  boost::asio::io_context& context_;
  Protocol& protocol_;
  Places places_;
  ClientLimits limits_;
  Log log_;
  std::deque<Acceptor> doors_;
  std::deque<std::filesystem::path> paths_;              // UNIX sockets; removed on destruction
  std::vector<std::shared_ptr<Connection>> connections_; // in the order of their arrival
  boost::asio::steady_timer sweep_;
};

} // namespace naocal
