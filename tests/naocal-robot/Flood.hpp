#pragma once

#include "protocol/Frames.hpp"

#include <arpa/inet.h>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <netinet/in.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <sched.h>
#include <spawn.h>
#include <stdexcept>
#include <string>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace naocal {

/// Ports of a robot on this computer, and the kind of flood.
struct FloodPlan {
  std::string kind; // of `floodKinds`
  std::uint16_t debugPort = 0, configPort = 0;
  int milliseconds = 1000; // at most 60 000
};

/// idle: connections that say nothing; storm: connections that are closed at once; broken: frames with errors;
/// settings: as many settings as the socket takes; oversized: messages of 10 000 settings; deaf: subscribers that do
/// not read.
inline const std::vector<std::string> floodKinds{"idle", "storm", "broken", "settings", "oversized", "deaf"};

/// Strangers on the network, which flood a robot from 127.0.0.2. They run at the lowest priority: elsewhere their
/// computers would do that work. Bounded in time and in connections.
class Flood {
public:
  explicit Flood(FloodPlan plan)
      : plan_{std::move(plan)}, end_{Clock::now() + std::chrono::milliseconds{plan_.milliseconds}} {}

  /// Floods until the time is over. Returns the number of connections.
  std::size_t run() {
    const sched_param lowest{};
    ::sched_setscheduler(0, SCHED_IDLE, &lowest);
    if (plan_.kind == "idle") {
      keepOpen(200, "", "");
    } else if (plan_.kind == "storm") {
      repeat("", "");
    } else if (plan_.kind == "broken") {
      repeat(encodeFrame(debugFormat, 77, "x") + std::string(500, '\xff'), "CONF" + std::string(500, '\0'));
    } else if (plan_.kind == "settings") {
      const std::string taken = settings(1000);
      std::string many;
      for (int i = 0; i < 20; ++i) {
        many += encodeConfigFrame(ConfigType::set, taken);
      }
      keepOpen(8, "", many);
    } else if (plan_.kind == "oversized") {
      repeat("", encodeConfigFrame(ConfigType::set, settings(10'000)));
    } else if (plan_.kind == "deaf") {
      std::string all;
      for (const char* key : {"Motion.angles", "Motion.measured", "Motion.player", "Motion.sentAngles", "Brain.cameras",
                              "Brain.CameraCalibration.top_image", "Brain.CameraCalibration.bottom_image"}) {
        all += encodeDebugFrame(DebugType::subscribe, key);
      }
      for (int i = 0; i < 50; ++i) {
        all += encodeDebugFrame(DebugType::requestList, "");
      }
      keepOpen(14, all, "");
    }
    return connections_;
  }

private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t mostConnections = 200'000;

  static std::string settings(std::size_t count) {
    nlohmann::json all = nlohmann::json::array();
    for (std::size_t i = 0; i < count; ++i) {
      all.push_back({{"mp", i % 2 == 0 ? "Motion.PosePlayer" : "Motion.Nothing"},
                     {"key", "hottest"},
                     {"value", 75 + double(i % 5)}});
    }
    return all.dump();
  }
  bool goesOn() const { return Clock::now() < end_ && connections_ < mostConnections; }

  /// A connection from another address; -1 if the robot takes none.
  int connectTo(std::uint16_t port) {
    const int file = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = ::inet_addr("127.0.0.2");
    const int one = 1;
    ::setsockopt(file, IPPROTO_IP, IP_BIND_ADDRESS_NO_PORT, &one, sizeof one);
    static_cast<void>(::bind(file, reinterpret_cast<const sockaddr*>(&address), sizeof address));
    const linger atOnce{1, 0}; // closes with a reset: leaves no port waiting
    ::setsockopt(file, SOL_SOCKET, SO_LINGER, &atOnce, sizeof atOnce);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    if (::connect(file, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
      ::close(file);
      return -1;
    }
    ::fcntl(file, F_SETFL, O_NONBLOCK);
    ++connections_;
    return file;
  }

  /// Sends what the robot takes at once; false if it has closed.
  static bool sendSome(int file, const std::string& bytes, std::size_t& sent) {
    while (sent < bytes.size()) {
      const ssize_t count = ::send(file, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (count < 0) {
        return errno == EAGAIN || errno == EINTR;
      }
      sent += std::size_t(count);
    }
    return true;
  }

  /// Keeps connections open to both ports, sends the same again and again, and opens those anew that the robot closes.
  void keepOpen(std::size_t count, const std::string& debug, const std::string& config) {
    struct Client {
      int file = -1;
      std::size_t sent = 0;
    };
    std::vector<Client> clients(2 * count);
    while (goesOn()) {
      for (std::size_t i = 0; i < clients.size() && goesOn(); ++i) {
        Client& client = clients[i];
        const bool isDebug = i % 2 == 0;
        const std::string& bytes = isDebug ? debug : config;
        pollfd state{client.file, POLLRDHUP, 0};
        const bool isClosed = client.file >= 0 && ::poll(&state, 1, 0) > 0;
        if (client.file < 0 || isClosed || !sendSome(client.file, bytes, client.sent)) {
          if (client.file >= 0) {
            ::close(client.file);
          }
          client = {connectTo(isDebug ? plan_.debugPort : plan_.configPort), 0};
        } else if (client.sent >= bytes.size() && !isDebug) {
          client.sent = 0;
        }
      }
      if (config.empty()) {
        std::this_thread::sleep_for(std::chrono::milliseconds{5});
      }
    }
    for (const Client& client : clients) {
      if (client.file >= 0) {
        ::close(client.file);
      }
    }
  }

  /// Connects, sends and closes, to both ports in turn.
  void repeat(const std::string& debug, const std::string& config) {
    for (bool isDebug = true; goesOn(); isDebug = !isDebug) {
      const int file = connectTo(isDebug ? plan_.debugPort : plan_.configPort);
      std::size_t sent = 0;
      if (file >= 0) {
        sendSome(file, isDebug ? debug : config, sent);
        ::close(file);
      }
    }
  }

  FloodPlan plan_;
  Clock::time_point end_;
  std::size_t connections_ = 0;
};

/// A flood in a process of its own, which is this program again ("floods a robot"). It ends with this object.
class FloodProcess {
public:
  explicit FloodProcess(const FloodPlan& plan) {
    const std::string text = nlohmann::json{
        {"kind", plan.kind},
        {"debug", plan.debugPort},
        {"config", plan.configPort},
        {"milliseconds",
         plan.milliseconds}}.dump();
    ::setenv("NAOCAL_FLOOD", text.c_str(), 1);
    std::string program = "/proc/self/exe", name = "floods a robot";
    char* const arguments[]{program.data(), name.data(), nullptr};
    if (::posix_spawn(&child_, program.c_str(), nullptr, nullptr, arguments, environ) != 0) {
      throw std::runtime_error{"the flood cannot be started"};
    }
  }
  ~FloodProcess() {
    if (child_ > 0) {
      ::kill(child_, SIGKILL);
      ::waitpid(child_, nullptr, 0);
    }
  }
  FloodProcess(const FloodProcess&) = delete;
  FloodProcess& operator=(const FloodProcess&) = delete;

  static FloodPlan plan() {
    const auto told = nlohmann::json::parse(std::getenv("NAOCAL_FLOOD"));
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    return {told["kind"], told["debug"], told["config"], told["milliseconds"]};
  }

private:
  pid_t child_ = 0;
};

} // namespace naocal
