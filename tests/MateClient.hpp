#pragma once

#include <arpa/inet.h>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <utility>

namespace naocal {

/// Client of the robot's sockets. Encodes frames as MATE does (Python's "<4sBBHII" and "<4sBBHI"), independently of the
/// servers' encoder. Each read and write times out after five minutes.
class MateClient {
public:
  struct Frame {
    int type = 0;
    std::string body;
  };

  static MateClient debug(std::uint16_t port) { return MateClient{port, 16}; }
  static MateClient config(std::uint16_t port) { return MateClient{port, 12}; }
  /// From another address of this computer, such as 127.0.0.2.
  static MateClient config(std::uint16_t port, const char* from) { return MateClient{port, 12, from}; }
  static MateClient debug(const std::filesystem::path& unixSocket) { return MateClient{unixSocket, 16}; }
  static MateClient config(const std::filesystem::path& unixSocket) { return MateClient{unixSocket, 12}; }
  MateClient(MateClient&& other) noexcept;
  ~MateClient();

  void send(int type, const std::string& body = "") { sendBytes(frame(type, body)); }
  std::string frame(int type, const std::string& body) const;
  void sendBytes(const std::string& bytes); // ignores that the peer has closed

  /// The next frame; absent after the peer has closed, or on a timeout.
  std::optional<Frame> receive();
  /// The next frame of a type, skipping others; absent as above.
  std::optional<Frame> receive(int type);
  nlohmann::json receiveJson(int type);

  /// Waits until the peer closes, discarding what it sends. False on a timeout.
  bool isClosed();

private:
  MateClient(std::uint16_t port, std::size_t headerSize, const char* from = nullptr);
  MateClient(const std::filesystem::path& unixSocket, std::size_t headerSize);
  void limitWaiting() const;
  std::optional<std::string> receiveBytes(std::size_t count);

  int socket_;
  std::size_t headerSize_;
};

inline MateClient::MateClient(std::uint16_t port, std::size_t headerSize, const char* from)
    : socket_{::socket(AF_INET, SOCK_STREAM, 0)}, headerSize_{headerSize} {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = ::inet_addr(from != nullptr ? from : "127.0.0.1");
  if (from != nullptr && ::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw std::runtime_error{"the client has no such address"};
  }
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw std::runtime_error{"the client cannot connect"};
  }
  limitWaiting();
}

inline MateClient::MateClient(const std::filesystem::path& unixSocket, std::size_t headerSize)
    : socket_{::socket(AF_UNIX, SOCK_STREAM, 0)}, headerSize_{headerSize} {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  unixSocket.string().copy(address.sun_path, sizeof address.sun_path - 1);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw std::runtime_error{"the client cannot connect"};
  }
  limitWaiting();
}

inline MateClient::MateClient(MateClient&& other) noexcept
    : socket_{std::exchange(other.socket_, -1)}, headerSize_{other.headerSize_} {}

inline MateClient::~MateClient() {
  if (socket_ >= 0) {
    ::close(socket_);
  }
}

inline void MateClient::limitWaiting() const {
  const timeval longest{300, 0};
  ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &longest, sizeof longest);
  ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &longest, sizeof longest);
}

inline std::string MateClient::frame(int type, const std::string& body) const {
  const bool isDebug = headerSize_ == 16;
  std::string bytes = isDebug ? "DMSG" : "CONF";
  const auto size = body.size();
  for (const std::size_t byte : {std::size_t{isDebug ? 1u : 2u}, std::size_t(type), std::size_t{0}, std::size_t{0},
                                 size & 255, size >> 8 & 255, size >> 16 & 255, size >> 24 & 255}) {
    bytes += static_cast<char>(byte);
  }
  return bytes + (isDebug ? std::string(4, '\0') : "") + body;
}

inline void MateClient::sendBytes(const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count <= 0) {
      return;
    }
    sent += std::size_t(count);
  }
}

inline std::optional<std::string> MateClient::receiveBytes(std::size_t count) {
  std::string bytes(count, '\0');
  for (std::size_t received = 0; received < count;) {
    const ssize_t more = ::recv(socket_, bytes.data() + received, count - received, 0);
    if (more <= 0) {
      return std::nullopt;
    }
    received += std::size_t(more);
  }
  return bytes;
}

inline std::optional<MateClient::Frame> MateClient::receive() {
  const auto header = receiveBytes(headerSize_);
  if (!header) {
    return std::nullopt;
  }
  const auto byte = [&](std::size_t i) { return std::size_t{static_cast<unsigned char>((*header)[i])}; };
  const std::string expected = frame(int(byte(5)), std::string{}).substr(0, 8);
  if (header->substr(0, 8) != expected || (headerSize_ == 16 && header->substr(12) != std::string(4, '\0'))) {
    throw std::runtime_error{"the robot sent a header that the protocol does not know"};
  }
  auto body = receiveBytes(byte(8) | byte(9) << 8 | byte(10) << 16 | byte(11) << 24);
  if (!body) {
    return std::nullopt;
  }
  return Frame{int(byte(5)), std::move(*body)};
}

inline std::optional<MateClient::Frame> MateClient::receive(int type) {
  for (auto next = receive(); next; next = receive()) {
    if (next->type == type) {
      return next;
    }
  }
  return std::nullopt;
}

inline nlohmann::json MateClient::receiveJson(int type) {
  const auto received = receive(type);
  return received ? nlohmann::json::parse(received->body) : nlohmann::json{"nothing came"};
}

inline bool MateClient::isClosed() {
  std::string bytes(65536, '\0');
  for (;;) {
    const ssize_t count = ::recv(socket_, bytes.data(), bytes.size(), 0);
    if (count <= 0) {
      return count == 0 || errno == ECONNRESET;
    }
  }
}

} // namespace naocal
