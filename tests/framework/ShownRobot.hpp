#pragma once

#include "MateClient.hpp"
#include "framework/ConfiguredRobot.hpp"
#include "framework/core/Database.hpp"
#include "framework/core/Module.hpp"
#include "framework/core/ModuleConfiguration.hpp"
#include "framework/core/Parameter.hpp"
#include "framework/core/Thread.hpp"
#include "framework/network/Sockets.hpp"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace naocal {

/// Test image; its bytes stand in for a JPEG.
struct TestPicture {
  std::string bytes;
};
inline EncodedImage toImage(const TestPicture& picture) {
  return {640, 480, picture.bytes};
}

/// Counts cycles and publishes the count as value, list and history; every third one also as an image.
class Counter : public Module {
public:
  explicit Counter(TimePoint base) : Module{"Counter"}, base_{base} {}
  void cycle() override {
    const int count = *count_ + 1;
    const TimePoint time = base_ + std::chrono::milliseconds{count * 12};
    setCycleTime(time);
    count_ = count;
    scaled_ = {count * *factor_, std::nan("")};
    history_.edit().push(time, -count);
    if (count % 3 == 0) {
      picture_ = TestPicture{std::string(pictureSize, static_cast<char>(count))};
    }
  }
  std::size_t pictureSize = 100; // [bytes]

private:
  TimePoint base_;
  Parameter<double> factor_{*this, "factor"};
  Production<int> count_{*this, "count"};
  Production<std::vector<double>> scaled_{*this, "Counter.scaled"};
  Production<History<double>> history_{*this, "history"};
  Production<TestPicture> picture_{*this, "picture"};
};

/// A robot with one thread, sockets and a log. The test triggers the thread's cycles. Clients may be silent for an
/// hour, as a test on a slow machine may make them, unless the test asks for other limits.
struct ShownRobot {
  explicit ShownRobot(SocketSettings wanted = {}) : settings{std::move(wanted)} {
    const ClientLimits shipped;
    for (auto [limit, usual] :
         {std::pair{&settings.firstMessage, shipped.firstMessage}, {&settings.rest, shipped.rest}}) {
      *limit = *limit == usual ? std::chrono::hours{1} : *limit;
    }
    settings.debugPort = settings.configPort = 0;
    settings.unixFolder = robot.folder.path() / "sockets";
    robot.file("default/head/default/Counter.json", R"({"factor": 0.5, "list": [1, 2]})");
    robot.file("default/sdk.json", R"({"location": "Home"})");
    configureModules(brain, robot.configuration);
    robot.configuration.mount("tuhhSDK.base", "sdk.json", RobotPart::none);
    robot.configuration.publish("tuhhSDK.base", "NaoInfo.headName", "Ada");
    robot.configuration.publish("tuhhSDK.base", "NaoInfo.bodyName", "Bob");
    sockets.emplace(settings, std::vector<Thread*>{&brain}, robot.configuration, base,
                    [this](std::string_view sentence) { log(sentence); });
  }
  ~ShownRobot() { sockets.reset(); }

  MateClient debug() const { return MateClient::debug(sockets->debugPort()); }
  MateClient config() const { return MateClient::config(sockets->configPort()); }

  void log(std::string_view sentence) {
    const std::lock_guard lock{mutex};
    sentences.emplace_back(sentence);
    logged.notify_all();
  }
  bool hasLogged(const std::string& text) { return isLogged(text, std::chrono::seconds{0}); }
  /// Waits until a sentence containing the text is logged; false on a timeout.
  bool isLogged(const std::string& text, std::chrono::seconds within = std::chrono::minutes{5}) {
    std::unique_lock lock{mutex};
    return logged.wait_for(lock, within, [&] {
      return std::any_of(sentences.begin(), sentences.end(),
                         [&](const auto& sentence) { return sentence.find(text) != std::string::npos; });
    });
  }

  const TimePoint base = TimePoint{} + std::chrono::hours{5};
  SocketSettings settings;
  ConfiguredRobot robot;
  Thread brain{"Brain", RobotPart::head};
  Counter& counter = brain.add<Counter>(base);
  Database database{{&brain}};
  std::mutex mutex;
  std::condition_variable logged;
  std::vector<std::string> sentences;
  std::optional<SocketServers> sockets;
};

} // namespace naocal
