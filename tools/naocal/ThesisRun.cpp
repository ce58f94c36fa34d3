#include "ThesisRun.hpp"

#include "Progress.hpp"
#include "evaluation/ThesisExperiment.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <thread>

namespace naocal {

namespace {

/// What one worker finds, per solver.
using Tallies = std::map<ThesisSolver, ThesisTally>;

/// Error sets of one setting on all cores.
class SettingRun {
public:
  SettingRun(const ThesisStage& stage, const ThesisSetting& setting, const std::vector<ThesisSolver>& solvers,
             const ThesisEvaluation& evaluation)
      : stage_{stage}, setting_{setting}, solvers_{solvers}, evaluation_{evaluation} {}

  /// `told(count)` hears of sets that are done and says whether to go on. Absent: it said no.
  template <typename Told> std::optional<Tallies> tallies(unsigned jobs, Told told) {
    std::vector<std::thread> workers;
    for (unsigned job = 0; job < jobs; ++job) {
      workers.emplace_back([&] {
        const Tallies own = work(told);
        const std::lock_guard lock{adding_};
        for (const auto& [solver, tally] : own) {
          sum_[solver].add(tally);
        }
      });
    }
    for (std::thread& worker : workers) {
      worker.join();
    }
    return stopped_ ? std::nullopt : std::optional{sum_};
  }

private:
  template <typename Told> Tallies work(Told told) {
    constexpr std::size_t atOnce = 50;
    ThesisTrial trial{stage_, setting_, evaluation_.pixel};
    Tallies own;
    for (std::size_t first = next_.fetch_add(atOnce); first < evaluation_.sets && !stopped_;
         first = next_.fetch_add(atOnce)) {
      const std::size_t end = std::min(first + atOnce, evaluation_.sets);
      for (std::size_t set = first; set < end; ++set) {
        if (set % evaluation_.parts == evaluation_.done.front()) {
          addSet(trial, set, own);
        }
      }
      if (!told(end - first)) {
        stopped_ = true;
      }
    }
    return own;
  }

  void addSet(ThesisTrial& trial, std::size_t set, Tallies& own) const {
    constexpr std::size_t draws = 10;
    trial.draw(evaluation_.seed, set);
    const std::vector<double> limit = trial.limit(draws);
    for (const ThesisSolver solver : solvers_) {
      if (set >= evaluation_.setsOf(solver)) {
        continue;
      }
      const auto start = std::chrono::steady_clock::now();
      const ThesisAnswer answer = trial.answer(solver);
      own[solver].seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      own[solver].add(trial.offsets(), answer, limit);
    }
  }

  const ThesisStage& stage_;
  const ThesisSetting& setting_;
  const std::vector<ThesisSolver>& solvers_;
  const ThesisEvaluation& evaluation_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex adding_;
  Tallies sum_;
};

} // namespace

void runThesis(ThesisEvaluation& evaluation, unsigned jobs, const std::function<void()>& keep) {
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  auto settings = thesisSettings();
  for (auto& [setting, solvers] : settings) {
    for (const ThesisSolver solver : {ThesisSolver::numeric, ThesisSolver::dlib, ThesisSolver::swarm}) {
      if (ofTable55(setting) && evaluation.setsOf(solver) > 0) {
        solvers.push_back(solver);
      }
    }
  }
  std::map<std::pair<ThesisFeature, PoseChoice>, std::vector<Eigen::VectorXd>> chosen;
  const Progress progress{"error sets"};
  std::mutex telling;
  std::size_t done = 0;
  const auto told = [&](std::size_t sets) {
    const std::lock_guard lock{telling};
    return progress(done += sets, settings.size() * evaluation.sets);
  };
  for (const auto& [setting, solvers] : settings) {
    if (std::all_of(solvers.begin(), solvers.end(),
                    [&, &setting = setting](ThesisSolver solver) { return evaluation.tally(setting, solver); })) {
      told(evaluation.sets);
      continue;
    }
    std::vector<Eigen::VectorXd>& nested = chosen[{setting.feature, setting.choice}];
    if (nested.empty()) {
      nested = thesisPoses(robot, setting.feature, setting.choice, 8);
    }
    const ThesisStage stage{robot, setting, posesOf(setting, robot, nested)};
    if (const auto names = stage.jointNames(); names.size() > evaluation.joints.size()) {
      evaluation.joints = names; // those of one leg come first
    }
    const auto tallies = SettingRun{stage, setting, solvers, evaluation}.tallies(jobs, told);
    if (!tallies) {
      return;
    }
    for (const auto& [solver, tally] : *tallies) {
      evaluation.outcomes.push_back({setting, solver, tally});
    }
    keep();
  }
}

} // namespace naocal
