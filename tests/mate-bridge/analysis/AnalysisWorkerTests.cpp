#include "analysis/AnalysisWorker.hpp"

#include "TemporaryFolder.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <deque>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

using namespace naocal;
using Json = nlohmann::json;

namespace {

/// Queue of actions for this thread, and the kinds of all messages to panels.
struct Thread {
  /// Runs actions until a message of this kind is the last one; false after ten minutes.
  bool until(const std::string& kind) {
    told.clear();
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes{10};
    while (std::chrono::steady_clock::now() < end) {
      std::unique_lock lock{mutex};
      if (waiting.empty()) {
        lock.unlock();
        std::this_thread::sleep_for(std::chrono::milliseconds{5});
        continue;
      }
      const std::function<void()> action = std::move(waiting.front());
      waiting.pop_front();
      lock.unlock();
      action();
      if (!told.empty() && told.back() == kind) {
        return true;
      }
    }
    return false;
  }
  std::vector<std::string> kept() const {
    std::vector<std::string> kinds;
    for (const auto& [kind, message] : slot.latest()) {
      if (kind != "work") {
        kinds.push_back(kind);
      }
    }
    return kinds;
  }

  std::mutex mutex;
  std::deque<std::function<void()>> waiting;
  std::vector<std::string> told;
  AnalysisSlot slot{[this](std::function<void()> action) {
                      const std::lock_guard lock{mutex};
                      waiting.push_back(std::move(action));
                    },
                    [this](const Message& message) { told.push_back(Json::parse(*message.bytes)["kind"]); }};
};

/// Writes captures of a simulated robot with eight poses.
void writeCaptures(const std::filesystem::path& folder) {
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  SimulationPlan plan;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 8, 1);
  writeCaptureSet(simulate(robot, plan, 1).set, folder);
}

} // namespace

TEST_CASE("who comes later is told what is true of the present fit, in the order in which it was told", "[slow]") {
  // Proves that open() returns immediately and its captures follow, that messages about a fit are discarded with it,
  // and that paths that cannot be opened are reported and leave the open captures unchanged.
  const TemporaryFolder folder;
  writeCaptures(folder.path() / "few");
  Thread thread;
  std::string problem;
  const auto refused = [&](const std::string& why) {
    problem = why;
    thread.told.emplace_back("refused");
  };
  thread.slot.open({(folder.path() / "few").string()}, refused);
  CHECK(thread.slot.worker() == nullptr);
  REQUIRE(thread.until("diagnosis"));
  CHECK(thread.kept() == std::vector<std::string>{"set", "fit", "ladder", "diagnosis"});
  thread.slot.worker()->drop("jointOffset@HeadYaw");
  REQUIRE(thread.until("fit"));
  CHECK(thread.kept() == std::vector<std::string>{"set", "ladder", "fit"});
  REQUIRE(thread.until("diagnosis"));

  const AnalysisWorker* const worker = thread.slot.worker();
  thread.slot.open({(folder.path() / "none").string()}, refused);
  REQUIRE(thread.until("refused"));
  CHECK_FALSE(problem.empty());
  CHECK(thread.slot.worker() == worker);
}

TEST_CASE("a change ends the search of the model before, and a refused one lets it begin again", "[slow]") {
  // Proves that the diagnosis is of the last model, whose fit came before it, and that it comes after a refusal, too.
  const TemporaryFolder folder;
  writeCaptures(folder.path() / "few");
  Thread thread;
  thread.slot.open({(folder.path() / "few").string()}, [](const std::string&) {});
  REQUIRE(thread.until("fit"));
  thread.slot.worker()->drop("jointOffset@HeadYaw"); // while the first model is searched
  REQUIRE(thread.until("fit"));
  CHECK(std::count(thread.told.begin(), thread.told.end(), "diagnosis") == 0);
  thread.slot.worker()->add({"elasticity@LKneePitsch"});
  REQUIRE(thread.until("refused"));
  REQUIRE(thread.until("diagnosis"));
  CHECK(std::count(thread.told.begin(), thread.told.end(), "fit") == 0);
}

TEST_CASE("why there is no fit at all is told to whoever comes later, until there is one") {
  // Proves it for a model with an unknown place, and that correcting the model ends the message.
  const TemporaryFolder folder;
  writeCaptures(folder.path() / "few");
  const std::string label = "elasticity@LKneePitsch";
  const Json model{{"format", "naocal-model"}, {"version", 1}, {"with", {label}}};
  writeAtomically(folder.path() / "model.json", model.dump());
  Thread thread;
  std::string problem;
  const std::vector<std::string> paths{(folder.path() / "few").string(), (folder.path() / "model.json").string()};
  thread.slot.open(paths, [&](const std::string& why) { problem = why; });
  REQUIRE(thread.until("unfitted"));
  CHECK(problem.empty());
  CHECK(thread.kept() == std::vector<std::string>{"set", "unfitted"});
  CHECK(Json::parse(*thread.slot.latest().back().second.bytes)["sentence"].get<std::string>().find(label) !=
        std::string::npos);
  thread.slot.worker()->drop(label);
  REQUIRE(thread.until("fit"));
  CHECK(thread.kept() == std::vector<std::string>{"set", "ladder", "fit"});
}
