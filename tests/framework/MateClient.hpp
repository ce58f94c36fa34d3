#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// A client of the robot's sockets that puts its bytes together as MATE does (Python's "<4sBBHII" and "<4sBBHI"), and
/// shares nothing with the servers' own encoder. Waits at most ten seconds for anything.
class MateClient {
public:
  struct Frame {
    int type = 0;
    std::string body;
  };

  static MateClient debug(std::uint16_t port) { return MateClient{port, 16}; }
  static MateClient config(std::uint16_t port) { return MateClient{port, 12}; }
  static MateClient debug(const std::filesystem::path& unixSocket) { return MateClient{unixSocket, 16}; }
  static MateClient config(const std::filesystem::path& unixSocket) { return MateClient{unixSocket, 12}; }
  MateClient(MateClient&& other) noexcept;
  ~MateClient();

  void send(int type, const std::string& body = "") { sendBytes(frame(type, body)); }
  std::string frame(int type, const std::string& body) const;
  void sendBytes(const std::string& bytes); // ignores that the other side has closed

  /// The next frame; absent when the other side closed or nothing came.
  std::optional<Frame> receive();
  /// The next frame of a type, frames before it dropped; absent as above.
  std::optional<Frame> receive(int type);
  nlohmann::json receiveJson(int type);

  /// Whether the other side closes within the time, whatever it sends before that.
  bool isClosed();

private:
  MateClient(std::uint16_t port, std::size_t headerSize);
  MateClient(const std::filesystem::path& unixSocket, std::size_t headerSize);
  void limitWaiting() const;
  std::optional<std::string> receiveBytes(std::size_t count);

  int socket_;
  std::size_t headerSize_;
};

} // namespace naocal
