#pragma once

#include <array>
#include <string_view>
#include <sys/socket.h>
#include <unistd.h>

namespace naocal {

/// A client's end of a non-blocking stream socket: sends bytes, then ends sending, and drops what it gets.
class SocketInput {
public:
  SocketInput(int socket, std::string_view bytes) : socket_{socket}, left_{bytes} {}
  ~SocketInput() {
    const linger reset{1, 0}; // no TIME_WAIT: ports would run out
    ::setsockopt(socket_, SOL_SOCKET, SO_LINGER, &reset, sizeof reset);
    ::close(socket_);
  }
  SocketInput(const SocketInput&) = delete;
  SocketInput& operator=(const SocketInput&) = delete;

  /// Sends and receives what goes without waiting. False: the other side has ended.
  bool exchange() {
    const ssize_t sent = ::send(socket_, left_.data(), left_.size(), MSG_NOSIGNAL);
    left_.remove_prefix(sent > 0 ? static_cast<std::size_t>(sent) : 0);
    if (left_.empty()) {
      ::shutdown(socket_, SHUT_WR);
    }
    std::array<char, 1 << 16> dropped;
    return ::recv(socket_, dropped.data(), dropped.size(), 0) != 0;
  }

private:
  int socket_;
  std::string_view left_;
};

} // namespace naocal
