#pragma once

#include "framework/network/Connection.hpp"

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <filesystem>
#include <set>

/// Heavy header (Boost.Asio): include it in Listener.cpp and Sockets.cpp only.
namespace naocal {

/// Accepts the clients of one server on any number of addresses and owns their connections. When `maxClients` is
/// reached, it closes a client that has not sent a required secret to admit a new one.
class Listener {
public:
  Listener(boost::asio::io_context& context, Protocol& protocol, std::size_t maxClients, ClientLimits limits, Log log);
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
  void makeRoom(); // at the limit, closes a client without the secret

  boost::asio::io_context& context_;
  Protocol& protocol_;
  std::size_t mostClients_;
  ClientLimits limits_;
  Log log_;
  std::deque<Acceptor> doors_;
  std::deque<std::filesystem::path> paths_; // UNIX sockets; removed on destruction
  std::set<std::shared_ptr<Connection>> connections_;
};

} // namespace naocal
