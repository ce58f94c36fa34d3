#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <vector>

/// Independent LoLA encoder: messages byte by byte from the protocol's description, without the code under test and
/// without a MessagePack library.
namespace naocal::twin {

inline constexpr std::array<std::string_view, 25> names{
    "HeadYaw",      "HeadPitch",  "LShoulderPitch", "LShoulderRoll", "LElbowYaw",      "LElbowRoll",    "LWristYaw",
    "LHipYawPitch", "LHipRoll",   "LHipPitch",      "LKneePitch",    "LAnklePitch",    "LAnkleRoll",    "RHipRoll",
    "RHipPitch",    "RKneePitch", "RAnklePitch",    "RAnkleRoll",    "RShoulderPitch", "RShoulderRoll", "RElbowYaw",
    "RElbowRoll",   "RWristYaw",  "LHand",          "RHand"};

/// Encodes MessagePack.
struct Writer {
  std::string bytes;

  void byte(int value) { bytes.push_back(char(value)); }
  void text(std::string_view value) {
    byte(0xa0 | int(value.size())); // fixstr: under 32 bytes
    bytes += value;
  }
  void list(std::size_t count) {
    if (count < 16) {
      byte(0x90 | int(count));
    } else {
      byte(0xdc);
      byte(int(count >> 8));
      byte(int(count & 0xff));
    }
  }
  void number(float value) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, 4);
    byte(0xca);
    for (int shift = 24; shift >= 0; shift -= 8) {
      byte(int(bits >> shift & 0xff));
    }
  }
};

/// Value reported by the twin's robot: entry `i` of a list in state number `sequence`.
inline float reported(std::string_view list, std::size_t i, std::uint32_t sequence) {
  const float place = float(list.size()) + 0.01f * float(i);
  return list == "Touch" ? float((sequence >> i) & 1) : place + 1e-4f * float(sequence % 9973);
}

/// A state in which entry `i` of a list is `number(list, i)`; entries of "Status" are small whole numbers.
template <typename Number> std::string stateOf(const Number& number) {
  Writer out;
  out.byte(0x8d);
  out.text("RobotConfig");
  out.list(4);
  for (const char* text : {"P0000073A07S94700012", "6.0.0", "P0000074A05S93M00061", "6.0.1"}) {
    out.text(text);
  }
  struct List {
    const char* name;
    std::size_t count;
  };
  for (const List& list : {List{"Accelerometer", 3}, List{"Angles", 2}, List{"Battery", 4}, List{"Current", 25},
                           List{"FSR", 8}, List{"Gyroscope", 3}, List{"Position", 25}, List{"Sonar", 2},
                           List{"Stiffness", 25}, List{"Temperature", 25}, List{"Touch", 14}}) {
    out.text(list.name);
    out.list(list.count);
    for (std::size_t i = 0; i < list.count; ++i) {
      out.number(float(number(list.name, i)));
    }
  }
  out.text("Status");
  out.list(25);
  for (std::size_t i = 0; i < 25; ++i) {
    out.byte(int(number("Status", i)));
  }
  return out.bytes;
}

inline std::string state(std::uint32_t sequence) {
  return stateOf([&](std::string_view list, std::size_t i) {
    return list == "Status" ? float((sequence + i) % 8) : reported(list, i, sequence);
  });
}

/// Entry `i` of a list of numbers in a command.
inline float commanded(std::string_view command, std::string_view list, std::size_t i) {
  const std::string key = std::string{char(0xa0 | list.size())} + std::string{list} + "\xdc"; // a list of 16 entries or
                                                                                              // more
  const std::size_t at = command.find(key);
  if (at == std::string_view::npos || at + key.size() + 2 + 5 * (i + 1) > command.size()) {
    throw std::runtime_error{"the command has no such list"};
  }
  std::uint32_t bits = 0;
  for (std::size_t byte = 0; byte < 4; ++byte) {
    bits = bits << 8 | std::uint8_t(command[at + key.size() + 2 + 5 * i + 1 + byte]);
  }
  float value;
  std::memcpy(&value, &bits, 4);
  return value;
}

/// Server side of LoLA's socket; one connection at a time.
class Server {
public:
  explicit Server(std::filesystem::path path) : path_{std::move(path)} {
    listening_ = socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path_.c_str(), sizeof address.sun_path - 1);
    if (bind(listening_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        listen(listening_, 1) != 0) {
      throw std::runtime_error{"the twin cannot listen"};
    }
  }
  ~Server() {
    hangUp();
    close(listening_);
    std::filesystem::remove(path_);
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  void accept() {
    hangUp();
    connection_ = ::accept(listening_, nullptr, nullptr);
  }
  /// Ends waiting accept() calls, now and later.
  void stopListening() { shutdown(listening_, SHUT_RDWR); }
  void hangUp() {
    if (connection_ >= 0) {
      close(connection_);
      connection_ = -1;
    }
  }
  /// False if the peer has disconnected.
  bool send(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::send(connection_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (count <= 0) {
        return false;
      }
      bytes.remove_prefix(std::size_t(count));
    }
    return true;
  }
  /// Reads `count` bytes; fewer if the peer has disconnected.
  std::string receive(std::size_t count) {
    std::string bytes(count, '\0');
    const ssize_t got = recv(connection_, bytes.data(), count, MSG_WAITALL);
    bytes.resize(got > 0 ? std::size_t(got) : 0);
    return bytes;
  }
  /// Whether the peer sends data within this time.
  bool hears(int milliseconds) {
    pollfd file{connection_, POLLIN, 0};
    return poll(&file, 1, milliseconds) > 0;
  }
  /// Discards received data.
  void forget() {
    std::array<char, 8192> bytes;
    while (recv(connection_, bytes.data(), bytes.size(), MSG_DONTWAIT) > 0) {
    }
  }

private:
  std::filesystem::path path_;
  int listening_ = -1, connection_ = -1;
};

} // namespace naocal::twin
