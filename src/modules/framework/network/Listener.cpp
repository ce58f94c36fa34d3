#include "framework/network/Listener.hpp"

#include "framework/configuration/ConfigurationLayers.hpp"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <fmt/format.h>
#include <map>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <tuple>

namespace naocal {

using boost::asio::ip::tcp;
using boost::system::error_code;
using Generic = boost::asio::generic::stream_protocol;

namespace {

/// A client's address without port; empty for a UNIX socket.
std::string addressOf(const Generic::endpoint& endpoint) {
  if (endpoint.protocol().family() == AF_UNIX) {
    return "";
  }
  tcp::endpoint address;
  std::memcpy(address.data(), endpoint.data(), std::min(endpoint.size(), address.capacity()));
  return address.address().to_string();
}

[[noreturn]] void refuseToListen(const std::string& where, const std::string& reason) {
  throw ConfigurationError{fmt::format("cannot listen on {}: {}; stop what listens there, or choose another place in "
                                       "sdk.json or access.json",
                                       where, reason)};
}

/// Enables TCP keep-alive (2 s idle, 1 s interval, 4 probes): a lost client is detected within about 6 s, so that its
/// last will is applied.
void watchNetwork(Socket& socket, std::chrono::milliseconds unconfirmed) {
  const int file = socket.native_handle();
  const auto set = [&](int level, int option, int value) { ::setsockopt(file, level, option, &value, sizeof value); };
  set(SOL_SOCKET, SO_KEEPALIVE, 1);
  set(IPPROTO_TCP, TCP_KEEPIDLE, 2);  // s
  set(IPPROTO_TCP, TCP_KEEPINTVL, 1); // s
  set(IPPROTO_TCP, TCP_KEEPCNT, 4);   // unanswered
  if (unconfirmed.count() > 0) {
    set(IPPROTO_TCP, TCP_USER_TIMEOUT, int(unconfirmed.count()));
  }
}

/// Limits the unsent data in the kernel's send buffer. Otherwise megabytes queue up there before a slow client counts
/// as busy, and new data is delayed by many seconds.
void keepQueueShort(Socket& socket) {
  const int most = 32 << 10; // [bytes] not sent yet
  ::setsockopt(socket.native_handle(), IPPROTO_TCP, TCP_NOTSENT_LOWAT, &most, sizeof most);
}

} // namespace

Listener::Listener(boost::asio::io_context& context, Protocol& protocol, Places places, ClientLimits limits, Log log)
    : context_{context}, protocol_{protocol}, places_{places}, limits_{limits}, log_{std::move(log)}, sweep_{context} {
  watchSilence();
}

Listener::~Listener() {
  while (!connections_.empty()) {
    (*connections_.begin())->end();
  }
  for (const auto& path : paths_) {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
}

Listener::Acceptor& Listener::open(const Generic& protocol) {
  return doors_.emplace_back(
      Acceptor{boost::asio::basic_socket_acceptor<Generic>{context_, protocol}, boost::asio::steady_timer{context_}});
}

std::uint16_t Listener::listenTcp(const std::string& address, std::uint16_t port) {
  try {
    const tcp::endpoint endpoint{boost::asio::ip::make_address(address), port};
    Acceptor& door = open(Generic{endpoint.protocol()});
    auto& acceptor = door.acceptor;
    acceptor.set_option(boost::asio::socket_base::reuse_address{true});
    acceptor.bind(Generic::endpoint{endpoint});
    acceptor.listen();
    const Generic::endpoint bound = acceptor.local_endpoint();
    tcp::endpoint local;
    std::memcpy(local.data(), bound.data(), std::min(bound.size(), local.capacity()));
    accept(door);
    return local.port();
  } catch (const boost::system::system_error& error) {
    refuseToListen(fmt::format("{} port {}", address, port), error.code().message());
  }
}

void Listener::listenUnix(const std::filesystem::path& path) {
  try {
    const boost::asio::local::stream_protocol::endpoint endpoint{path.string()};
    boost::asio::local::stream_protocol::socket probe{context_};
    error_code nobody;
    if (!probe.connect(endpoint, nobody)) {
      refuseToListen(path.string(), "another process listens there");
    }
    if (std::filesystem::is_socket(path)) {
      std::filesystem::remove(path);
    }
    std::filesystem::create_directories(path.parent_path());
    Acceptor& door = open(Generic{endpoint.protocol()});
    auto& acceptor = door.acceptor;
    acceptor.bind(Generic::endpoint{endpoint});
    ::chmod(path.c_str(), S_IRUSR | S_IWUSR); // before listen()
    paths_.push_back(path);
    acceptor.listen();
    accept(door);
  } catch (const std::system_error& error) {
    refuseToListen(path.string(), error.code().message());
  }
}

void Listener::accept(Acceptor& door) {
  door.acceptor.async_accept([this, &door](const error_code& error, Socket socket) {
    if (error == boost::asio::error::operation_aborted) {
      return;
    }
    if (!error) {
      welcome(std::move(socket));
      return accept(door);
    }
    log_(fmt::format("A client could not be accepted: {}.", error.message()));
    door.pause.expires_after(
        std::chrono::milliseconds{100}); // limits the retry rate, such as when no descriptors are left
    door.pause.async_wait([this, &door](const error_code& stopped) {
      if (!stopped) {
        accept(door);
      }
    });
  });
}

std::shared_ptr<Connection> Listener::leastNeeded(const std::string& address) const {
  std::map<std::string, std::size_t> crowds; // clients by address
  for (const auto& client : connections_) {
    ++crowds[client->address()];
  }
  const std::size_t newCrowd = crowds[address];
  const auto rankOf = [&](const Connection& client) {
    const bool isKnown = client.hasSpoken() && protocol_.isTrusted(client);
    return isKnown ? (protocol_.isInUse(client) ? 3 : 2) : (client.hasDataWaiting() ? 1 : 0);
  };
  std::shared_ptr<Connection> least;
  std::tuple<int, std::size_t, TimePoint> leastOrder;
  for (const auto& client : connections_) {
    const int rank = rankOf(*client);
    const std::size_t crowd = crowds[client->address()];
    const std::tuple order{rank, connections_.size() - crowd, client->lastMessage()};
    if (!(least && leastOrder <= order) && (rank < 2 || !protocol_.needsSecret(address)) &&
        (rank < 3 || crowd >= newCrowd + 2)) {
      least = client;
      leastOrder = order;
    }
  }
  if (!least && places_.kept > 0) {
    least = *std::min_element(
        connections_.end() - std::ptrdiff_t(std::min(places_.kept, connections_.size())), connections_.end(),
        [](const auto& one, const auto& other) { return one->lastMessage() < other->lastMessage(); });
  }
  return least;
}

void Listener::makeRoom(const std::string& address) {
  if (connections_.size() >= places_.clients + places_.kept) {
    if (const auto least = leastNeeded(address)) {
      least->end();
    }
  }
}

void Listener::watchSilence() {
  sweep_.expires_after(std::clamp<Duration>(std::min(limits_.firstMessage, limits_.rest) / 10,
                                            std::chrono::milliseconds{1}, std::chrono::milliseconds{500}));
  sweep_.async_wait([this](const error_code& stopped) {
    if (!stopped) {
      for (const auto& client : std::vector{connections_}) { // copy: a client that ends removes itself
        client->closeIfSilent(Clock::now());
      }
      watchSilence();
    }
  });
}

void Listener::welcome(Socket socket) {
  error_code gone;
  const Generic::endpoint endpoint = socket.remote_endpoint(gone);
  if (gone) {
    return;
  }
  const std::string address = addressOf(endpoint);
  makeRoom(address);
  if (const std::size_t most = places_.clients + places_.kept; connections_.size() >= most) {
    log_(fmt::format("Client {}: {} clients are connected already, which is the limit; the connection was closed.",
                     address.empty() ? "on this computer" : address, most));
    return;
  }
  if (!address.empty()) {
    socket.set_option(tcp::no_delay{true}, gone);
    watchNetwork(socket, limits_.unacknowledgedTimeout);
    keepQueueShort(socket);
  }
  const auto connection =
      std::make_shared<Connection>(std::move(socket), address, protocol_, limits_, log_,
                                   [this](Connection& ended) { std::erase(connections_, ended.self()); });
  connections_.push_back(connection);
  connection->start();
}

} // namespace naocal
