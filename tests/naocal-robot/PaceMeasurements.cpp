#include "V6Twin.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <ctime>
#include <fmt/format.h>
#include <utility>

namespace naocal {
namespace {

/// CPU time of the calling thread [s].
double processorTime() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Records the delay of states and commands, and the CPU time of the modules in between. A state overtaken by a later
/// one counts as received, and answered, together with that one.
class TimedRobot : public RobotInterface {
public:
  TimedRobot(RobotInterface& robot, const std::atomic<TimePoint>& due) : robot_{robot}, due_{due} {}

  std::optional<RobotIdentity> waitForIdentity(std::chrono::milliseconds timeout) override {
    return robot_.waitForIdentity(timeout);
  }
  std::optional<RobotState> waitForState(std::chrono::milliseconds timeout) override {
    if (answered_) {
      if (starting_ == 0) {
        work.push_back(processorTime() - began_);
      }
      answered_ = false;
    }
    auto state = robot_.waitForState(timeout);
    began_ = processorTime();
    if (state) {
      const std::uint64_t overtakenSoFar = robot_.status().lostStates;
      overtaken_ = overtakenSoFar - std::exchange(overtakenBefore_, overtakenSoFar);
      stateDue_ = due_.load();
      while (state->time < stateDue_) { // the next state was sent meanwhile
        stateDue_ -= period();
      }
      starting_ -= starting_ > 0;
      lost += starting_ > 0 ? 0 : overtaken_;
      note(taken);
    }
    return state;
  }
  void send(const RobotCommand& command) override {
    robot_.send(command);
    note(sent);
    answered_ = true;
  }
  std::chrono::nanoseconds period() const override { return robot_.period(); }
  RobotStatus status() const override { return robot_.status(); }

  /// Clears the records; then ignores cycles until the process has caught up.
  void startAnew() {
    taken.clear();
    sent.clear();
    work.clear();
    lost = 0;
    starting_ = 6; // cycles to ignore
  }

  std::vector<double> taken, sent, work; // [s]
  std::uint64_t lost = 0;                // overtaken states

private:
  void note(std::vector<double>& late) const {
    const Duration now = Clock::now() - stateDue_;
    for (std::uint64_t i = 0; starting_ == 0 && i <= overtaken_; ++i) {
      late.push_back(toSeconds(now + i * period()));
    }
  }

  RobotInterface& robot_;
  const std::atomic<TimePoint>& due_;
  TimePoint stateDue_{};
  std::uint64_t overtaken_ = 0, overtakenBefore_ = 0; // states overtaken by the present one; in total
  int starting_ = 0;
  double began_ = 0;
  bool answered_ = false;
};

/// A debug client that subscribes to all keys.
struct Client {
  explicit Client(std::uint16_t port) : mate{MateClient::debug(port)} {
    mate.send(3);
    const auto list = mate.receiveJson(4);
    for (const auto& key : list["keys"]) {
      mate.send(0, key["key"].get<std::string>());
    }
  }
  MateClient mate;
};

/// Wake-up latency of an idle thread of the same priority, every 12 ms [s].
std::vector<double> lateness(const std::atomic<bool>& over) {
  requestRealTimePriority(30);
  std::vector<double> late;
  for (TimePoint due = Clock::now(); !over;) {
    due += std::chrono::milliseconds{12};
    std::this_thread::sleep_until(due);
    late.push_back(toSeconds(Clock::now() - due));
  }
  return late;
}

std::string summary(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto quantile = [&](double share) { return 1e3 * values[std::size_t(share * double(values.size() - 1))]; };
  const auto within = std::upper_bound(values.begin(), values.end(), 1e-3) - values.begin();
  return fmt::format("{:.4f} % of {} within 1 ms; median {:.3f}, 99 % {:.3f}, 99.9 % {:.3f}, latest {:.2f} ms",
                     100. * double(within) / double(values.size()), values.size(), quantile(0.5), quantile(0.99),
                     quantile(0.999), quantile(1));
}

} // namespace

// Measurement; proves nothing. Environment: MINUTES.
TEST_CASE("how regularly the motion thread works while cameras, detection, solving and clients are busy",
          "[.measure]") {
  const char* minutes = std::getenv("MINUTES");
  SimulatedPlan plan = simulatedPlan(1);
  plan.offsetRange = radians(1);
  V6Process v6{plan, [](RobotInterface& robot, V6Twin& twin) { return std::make_unique<TimedRobot>(robot, twin.due); }};
  auto& timed = dynamic_cast<TimedRobot&>(*v6.watched);
  const auto port = v6.process->sockets().debugPort();
  std::atomic<bool> over = false;
  std::atomic<std::uint64_t> frames = 0, bytes = 0;
  std::vector<std::jthread> readers;
  for (int i = 0; i < 3; ++i) {
    readers.emplace_back([&] {
      Client client{port};
      while (!over) {
        if (const auto frame = client.mate.receive()) {
          ++frames;
          bytes += frame->body.size();
        }
      }
    });
  }
  Client neverReads{port};
  std::vector<double> idle;
  std::jthread nothing{[&] { idle = lateness(over); }};
  std::vector<double> taken, sent, work;
  const auto end = Clock::now() + std::chrono::duration<double>{60 * std::atof(minutes ? minutes : "1")};
  for (int round = 0; Clock::now() < end; ++round) {
    timed.startAnew();
    const auto state = v6.calibrated(round % 2 == 0 ? "head" : "left leg");
    fmt::print("{}: {}\n", state["phase"].get<std::string>(), state.value("sentence", ""));
    const auto add = [](auto& all, const auto& some) { all.insert(all.end(), some.begin(), some.end()); };
    add(taken, timed.taken);
    add(sent, timed.sent);
    add(work, timed.work);
    fmt::print("{} states overtaken\nstates taken after {}\ncommands sent after {}\n", timed.lost, summary(taken),
               summary(sent));
    std::fflush(stdout);
  }
  over = true;
  nothing.join();
  fmt::print("a thread that does nothing wakes after {}\n", summary(idle));
  std::sort(work.begin(), work.end());
  double sum = 0;
  for (const double seconds : work) {
    sum += seconds;
  }
  fmt::print("motion modules: {:.4f} of a core, {:.3f} ms of processor time in the longest cycle; {} frames, {:.0f} MB "
             "to three clients\n{}",
             sum / double(work.size()) / 0.012, 1e3 * work.back(), frames.load(), 1e-6 * double(bytes), v6.log);
  neverReads.mate.send(3);
  CHECK(neverReads.mate.receive(4)); // still connected
}

} // namespace naocal
