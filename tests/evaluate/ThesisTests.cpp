#include "RobotV6.hpp"
#include "TemporaryFolder.hpp"
#include "captures/Files.hpp"
#include "captures/InputError.hpp"
#include "evaluate/ThesisEvaluation.hpp"
#include "geometry/Index.hpp"
#include "synthetic/SimulationPlan.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

ThesisStage stageOf(const ThesisSetting& setting) {
  static std::map<ThesisFeature, std::vector<Eigen::VectorXd>> nested;
  std::vector<Eigen::VectorXd>& all = nested[setting.feature];
  if (all.empty()) {
    all = thesisPoses(v6(), setting.feature, 8);
  }
  return {
      v6(), setting.feature, {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(setting.poses)}, setting.samples};
}

/// Every parts-th set of the first `sets`.
ThesisEvaluation evaluated(const ThesisSetting& setting, std::size_t sets, std::size_t part, std::size_t parts) {
  ThesisEvaluation result{.seed = 3, .sets = sets, .parts = parts, .done = {part}};
  const ThesisStage stage = stageOf(setting);
  ThesisTrial trial{stage, setting, result.pixel};
  for (const ThesisSolver solver : {ThesisSolver::plain, ThesisSolver::ours}) {
    ThesisTally tally;
    for (std::size_t set = part; set < sets; set += parts) {
      trial.draw(result.seed, set);
      const std::vector<double> limit = trial.limit(10);
      tally.add(trial.answer(solver), limit);
    }
    result.outcomes.push_back({setting, solver, tally});
  }
  return result;
}

/// How the corners that a picture shows move with the stage's joints, by central differences through the synthetic
/// robot's own kinematics and lens: u0, v0, u1, ... per joint [px/rad].
Eigen::MatrixXd cornerSlopes(const ThesisTrial& trial, const ThesisStage& stage, const Picture& picture) {
  const Robot& robot = v6();
  static const SyntheticRobot drawn{
      robot,
      {Eigen::VectorXd::Zero(at(robot.joints.size())), std::vector<RobotErrors::Mount>(robot.cameras.size())},
      {}};
  const CameraIntrinsics lens = drawnCameras(640, 480).at(robot.cameras[picture.camera].name);
  Eigen::VectorXd angles = picture.drawn.values.head(at(robot.joints.size()));
  for (std::size_t i = 0; i < stage.joints().size(); ++i) {
    angles[at(stage.joints()[i])] -= trial.offsets()[at(i)];
  }
  const auto corners = [&](const Eigen::VectorXd& joints) {
    std::vector<double> seen;
    const Eigen::Isometry3d cameraFromSole =
        (drawn.soleFromTorso(joints, SupportFoot::left) * drawn.torsoFromCamera(picture.camera, joints)).inverse();
    for (const Sighting& sighting : picture.sightings) {
      const Board& board = stage.everything().targets[sighting.view.board()].board;
      for (const int id : sighting.ids) {
        const Eigen::Vector3d point = board.points[static_cast<std::size_t>(id)];
        const auto uv = pixel(lens, cameraFromSole * (isometry(*board.placement) * point));
        seen.push_back(uv.value().x());
        seen.push_back(uv.value().y());
      }
    }
    return Eigen::VectorXd{Eigen::Map<Eigen::VectorXd>(seen.data(), at(seen.size()))};
  };
  constexpr double step = 1e-6;
  Eigen::MatrixXd slopes(corners(angles).size(), at(stage.joints().size()));
  for (std::size_t i = 0; i < stage.joints().size(); ++i) {
    Eigen::VectorXd above = angles, below = angles;
    above[at(stage.joints()[i])] += step;
    below[at(stage.joints()[i])] -= step;
    slopes.col(at(i)) = (corners(above) - corners(below)) / (2 * step);
  }
  return slopes;
}

/// J^T Sigma^-1 J over all readings, dense, with the offsets' prior.
Eigen::MatrixXd denseInformation(const ThesisTrial& trial, const ThesisStage& stage) {
  const auto joints = at(stage.joints().size());
  const double prior = radians(6.5) / std::sqrt(3.0);
  Eigen::MatrixXd information = Eigen::MatrixXd::Identity(joints, joints) / (prior * prior);
  for (const PoseGroup& pose : trial.taken().poses) {
    for (const Reading& reading : pose.readings) {
      Eigen::MatrixXd slopes(0, joints);
      for (const std::size_t picture : reading.pictures) {
        const Eigen::MatrixXd more = cornerSlopes(trial, stage, trial.taken().pictures[picture]);
        slopes.conservativeResize(slopes.rows() + more.rows(), joints);
        slopes.bottomRows(more.rows()) = more;
      }
      Eigen::MatrixXd covariance = std::pow(trial.noise().encoder, 2) * slopes * slopes.transpose();
      covariance.diagonal().array() += std::pow(trial.noise().pixel, 2);
      information += slopes.transpose() * covariance.ldlt().solve(slopes);
    }
  }
  return information;
}

} // namespace

TEST_CASE("without noise our solver finds all offsets of every error set, from three poses on") {
  // Proves it for some sets of every noiseless setting of the tables; `naocal evaluate thesis` counts thousands.
  for (const auto& [setting, solvers] : thesisSettings()) {
    if (setting.noise == ThesisNoise::none) {
      INFO(setting.name());
      const ThesisStage stage = stageOf(setting);
      ThesisTrial trial{stage, setting, 0.3};
      for (std::size_t set = 0; set < 30; ++set) {
        trial.draw(1, set);
        CHECK(trial.answer(ThesisSolver::ours).status(radians(0.001)) == ThesisStatus::success);
      }
    }
  }
}

TEST_CASE("the tables' limit is that of the whole measurement's covariance") {
  // Proves information and draws against dense matrices of slopes that are differences through the synthetic robot's
  // kinematics, which share no code with the solver's. Not proved: that errors are normal.
  const ThesisSetting setting{.poses = 3, .noise = ThesisNoise::both, .jointNoise = AngleNoise::encoder, .samples = 3};
  const ThesisStage stage = stageOf(setting);
  ThesisTrial trial{stage, setting, 0.3};
  trial.draw(1, 5);
  constexpr std::size_t draws = 20'000;
  const std::vector<double> limit = trial.limit(draws);

  const Eigen::MatrixXd covariance = denseInformation(trial, stage).inverse();
  const Eigen::MatrixXd root = covariance.llt().matrixL();
  Randomness chance{1, "the tables' limit"};
  std::vector<double> expected;
  for (std::size_t i = 0; i < draws; ++i) {
    Eigen::VectorXd normal{root.cols()};
    std::generate(normal.begin(), normal.end(), [&] { return chance.normal(1); });
    expected.push_back((root * normal).cwiseAbs().maxCoeff());
  }
  for (const double tolerance : {0.1, 0.15, 0.2, 0.3}) {
    const auto share = [&](const std::vector<double>& errors) {
      const auto within = [&](double error) { return error <= radians(tolerance); };
      return static_cast<double>(std::count_if(errors.begin(), errors.end(), within)) / draws;
    };
    CHECK(share(limit) == Approx(share(expected)).margin(0.02)); // four sigmas of the difference
  }
}

TEST_CASE("statuses are told apart in the thesis's order") {
  // Proves the order of the questions on made-up answers, not that searches end so.
  ThesisAnswer answer{.solved = true, .rms = 0.5, .rmsTolerance = 1, .largestError = radians(0.15)};
  CHECK(answer.status(radians(0.2)) == ThesisStatus::success);
  CHECK(answer.status(radians(0.1)) == ThesisStatus::localMinimum);
  answer.rms = 2;
  CHECK(answer.status(radians(0.1)) == ThesisStatus::noConvergence);
  answer.solved = false;
  CHECK(answer.status(radians(0.1)) == ThesisStatus::solverFailure);
  ThesisTally tally;
  tally.add(answer, {});
  answer = {.solved = true, .rms = 0.5, .rmsTolerance = 1, .largestError = radians(0.25)};
  tally.add(answer, {radians(0.15), radians(0.5)});
  CHECK(tally.status[static_cast<std::size_t>(ThesisStatus::solverFailure)] == 1);
  CHECK(tally.status[static_cast<std::size_t>(ThesisStatus::localMinimum)] == 1);
  CHECK(tally.successAt(1) == 0);
  CHECK(tally.successAt(2) == 0.5);
  CHECK(tally.limitAt(1) == 0.5);
}

TEST_CASE("readings are as noisy as our solver is told") {
  // Proves the standard deviation of each reading of the joint noise, rounding included, and whole encoder steps.
  for (const AngleNoise noise : {AngleNoise::radians, AngleNoise::degrees, AngleNoise::encoder}) {
    const ThesisSetting setting{.noise = ThesisNoise::joint, .jointNoise = noise};
    INFO(setting.name());
    Randomness chance{1, "noisy readings"};
    double squares = 0;
    constexpr int count = 20'000;
    for (int i = 0; i < count; ++i) {
      const AngleReading reading = angleReading(0.4, setting, chance);
      squares += std::pow(reading.reported - reading.raw, 2);
      REQUIRE(std::abs(std::remainder(reading.reported, encoderStep)) < 1e-9);
    }
    CHECK(std::sqrt(squares / count) == Approx(thesisNoise(setting, 0.3).encoder).epsilon(0.02));
  }
}

TEST_CASE("error sets repeat by their number and keep to the range of errors") {
  // Proves that draws do not depend on what was drawn before, and that large errors are large.
  const ThesisSetting setting{.noise = ThesisNoise::both, .largeErrors = true};
  const ThesisStage stage = stageOf(setting);
  ThesisTrial one{stage, setting, 0.3}, other{stage, setting, 0.3};
  for (std::size_t set = 0; set < 20; ++set) {
    one.draw(7, set);
    CHECK(one.offsets().cwiseAbs().minCoeff() >= radians(1));
    CHECK(one.offsets().cwiseAbs().maxCoeff() <= radians(6.5));
  }
  other.draw(7, 19);
  CHECK(one.offsets() == other.offsets());
  for (const ThesisSolver solver : {ThesisSolver::ours, ThesisSolver::randomStarts}) {
    CHECK(one.answer(solver).largestError == other.answer(solver).largestError);
  }
}

TEST_CASE("parts of an evaluation, written, read and put together, are the whole") {
  // Proves it for one setting and for every count; times differ. Also that a part cannot be counted twice.
  const ThesisSetting setting{.noise = ThesisNoise::both, .jointNoise = AngleNoise::encoder};
  const TemporaryFolder folder;
  std::vector<ThesisEvaluation> parts;
  for (const std::size_t part : {0, 1, 2}) {
    const auto file = folder.path() / "part.json";
    writeAtomically(file, evaluationJson(evaluated(setting, 20, part, 3)).dump());
    parts.push_back(readEvaluation(file));
  }
  const ThesisEvaluation whole = evaluated(setting, 20, 0, 1), together = merged(parts);
  CHECK(evaluationJson(whole)["cells"] == evaluationJson(together)["cells"]);
  CHECK(together.done == std::vector<std::size_t>{0, 1, 2});
  CHECK(together.tally(setting, ThesisSolver::ours)->sets == 20);
  CHECK_THROWS_AS(merged({parts[0], parts[0]}), InputError);
  CHECK_THROWS_AS(merged({parts[0], whole}), InputError);
}

} // namespace naocal
