#include "hardware/nao/LolaStream.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <poll.h>
#include <stdexcept>
#include <sys/socket.h>
#include <sys/un.h>
#include <thread>
#include <unistd.h>

namespace naocal {
namespace {

constexpr std::chrono::milliseconds betweenAttempts{10}; // limits the connection rate

int millisecondsUntil(TimePoint deadline) { // rounded up: prevents busy waiting
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
  return int(std::clamp<std::int64_t>(left.count(), 0, 60'000));
}

} // namespace

LolaStream::LolaStream(std::filesystem::path socket) : path_{std::move(socket)} {
  if (path_.string().size() >= sizeof(sockaddr_un::sun_path)) {
    throw std::invalid_argument{fmt::format("{}: the path of a socket can have {} characters at most", path_.string(),
                                            sizeof(sockaddr_un::sun_path) - 1)};
  }
}

LolaStream::~LolaStream() {
  if (socket_ >= 0) {
    close(socket_);
  }
}

bool LolaStream::connectOnce() {
  const TimePoint now = std::chrono::steady_clock::now();
  if (now < nextAttempt_) {
    return false;
  }
  nextAttempt_ = now + betweenAttempts; // limits the reconnect rate
  socket_ = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy_n(path_.c_str(), path_.string().size(), address.sun_path);
  if (socket_ < 0 || connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    reconnect(fmt::format("{}: no connection to the robot's hardware service: {}", path_.string(), strerror(errno)));
    return false;
  }
  ++connections_;
  problem_.clear();
  return true;
}

void LolaStream::reconnect(std::string reason) {
  if (socket_ >= 0) {
    close(socket_);
  }
  socket_ = -1;
  gathered_ = 0;
  fresh_ = false;
  unsent_.clear();
  problem_ = std::move(reason);
}

/// Reads all available data; false if the connection is lost.
bool LolaStream::drain() {
  received_.overtaken = 0;
  while (true) {
    const ssize_t count = recv(socket_, next_.data() + gathered_, next_.size() - gathered_, 0);
    if (count <= 0) {
      const bool nothingMore = count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK);
      if (count < 0 && errno == EINTR) {
        continue;
      }
      if (!nothingMore) {
        reconnect(fmt::format("{}: the robot's hardware service closed the connection{}{}", path_.string(),
                              count < 0 ? ": " : "", count < 0 ? strerror(errno) : ""));
      }
      return nothingMore;
    }
    gathered_ += std::size_t(count);
    if (gathered_ == next_.size()) {
      gathered_ = 0;
      if (!hasLolaStateHeader(next_)) {
        reconnect(fmt::format("{}: the stream of states is out of step", path_.string()));
        return false;
      }
      received_.overtaken += fresh_;
      received_.message = next_;
      received_.arrived = std::chrono::steady_clock::now();
      fresh_ = true;
    }
  }
}

const LolaStream::Received* LolaStream::receive(TimePoint deadline) {
  while (true) {
    if (isConnected() || connectOnce()) {
      if (!unsent_.empty()) {
        sendRest();
      }
      pollfd wait{socket_, short(unsent_.empty() ? POLLIN : POLLIN | POLLOUT), 0};
      if (isConnected() && poll(&wait, 1, millisecondsUntil(deadline)) > 0 && (wait.revents & ~POLLOUT) && drain() &&
          fresh_) {
        fresh_ = false;
        return &received_;
      }
    } else {
      const auto left = deadline - std::chrono::steady_clock::now();
      std::this_thread::sleep_for(std::clamp<std::chrono::nanoseconds>(left, {}, betweenAttempts / 10));
    }
    if (std::chrono::steady_clock::now() >= deadline) {
      return nullptr;
    }
  }
}

void LolaStream::send(std::span<const std::uint8_t> message) {
  if (isConnected() && !unsent_.empty()) {
    sendRest();
  }
  if (isConnected() && unsent_.empty()) {
    unsent_.assign(message.begin(), message.end());
    sendRest();
  }
}

void LolaStream::sendRest() {
  const ssize_t count = ::send(socket_, unsent_.data(), unsent_.size(), MSG_NOSIGNAL);
  if (count >= 0) {
    unsent_.erase(unsent_.begin(), unsent_.begin() + count);
  } else if (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR) {
    reconnect(fmt::format("{}: the robot's hardware service takes no commands: {}", path_.string(), strerror(errno)));
  }
}

} // namespace naocal
