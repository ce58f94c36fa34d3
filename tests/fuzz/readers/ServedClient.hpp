#pragma once

#include "framework/network/Connection.hpp"
#include "fuzz/readers/SocketInput.hpp"

#include <boost/asio/io_context.hpp>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace naocal {

/// Serves a client that sends these bytes through a pair of UNIX sockets and then ends; what it gets is dropped.
/// Returns when the connection has ended.
inline void serveClient(Protocol& protocol, std::string_view bytes) {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends) != 0) {
    throw std::runtime_error{"the system gives no sockets"};
  }
  SocketInput client{ends[1], bytes};
  boost::asio::io_context context;
  bool ended = false;
  const auto connection = std::make_shared<Connection>(
      Socket{context, boost::asio::generic::stream_protocol{AF_UNIX, SOCK_STREAM}, ends[0]}, "", protocol,
      ClientLimits{}, [](std::string_view) {}, [&](Connection&) { ended = true; });
  connection->start();
  while (!ended) {
    client.exchange();
    context.restart();
    context.poll();
  }
}

} // namespace naocal
