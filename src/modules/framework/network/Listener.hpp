#pragma once

#include "framework/network/Connection.hpp"

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <filesystem>
#include <set>

/// Heavy (Boost.Asio): included by Listener.cpp and Sockets.cpp only.
namespace naocal {

/// Accepts the clients of one server, over any number of addresses, and owns their connections. When all places are
/// taken, a client that has not shown the secret where it is needed gives up its place.
class Listener {
public:
  Listener(boost::asio::io_context& context, Protocol& protocol, std::size_t maxClients, ClientLimits limits, Log log);
  ~Listener();

  /// Listens on an address and port; 0 takes any that is free. Returns the port. Throws ConfigurationError.
  std::uint16_t listenTcp(const std::string& address, std::uint16_t port);

  /// Listens on a UNIX socket that only this user can open, in place of what a dead process left there. Throws
  /// ConfigurationError.
  void listenUnix(const std::filesystem::path& path);

private:
  /// Where clients come in.
  struct Acceptor {
    boost::asio::basic_socket_acceptor<boost::asio::generic::stream_protocol> acceptor;
    boost::asio::steady_timer pause;
  };
  Acceptor& open(const boost::asio::generic::stream_protocol& protocol);
  void accept(Acceptor& door);
  void welcome(Socket socket);
  void makeRoom(); // where all places are taken, by a client without the secret

  boost::asio::io_context& context_;
  Protocol& protocol_;
  std::size_t mostClients_;
  ClientLimits limits_;
  Log log_;
  std::deque<Acceptor> doors_;
  std::deque<std::filesystem::path> paths_; // of UNIX sockets, removed at the end
  std::set<std::shared_ptr<Connection>> connections_;
};

} // namespace naocal
