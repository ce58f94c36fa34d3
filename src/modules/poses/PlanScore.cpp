#include "poses/PlanScore.hpp"

#include "poses/PoseOrder.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace naocal {

PlanScore::PlanScore(const Robot& robot, const std::vector<Board>& boards,
                     const std::map<std::string, CameraIntrinsics>& cameras, const PlanOptions& options)
    : robot_{robot}, cameras_{cameras}, options_{options}, scene_{robot, supportSole(robot, options.poses.supportFoot),
                                                                  boards, cameras, options.poses.sight},
      judge_{robot, scene_, scene_.joints(), options.criterion, options.known}, known_{judge_.prior()} {
  for (const Eigen::VectorXd& angles : options.kept) {
    kept_.push_back({scene_.drawn(), {}, 0});
    kept_.back().belief.values.head(angles.size()) = angles;
  }
  for (const Eigen::MatrixXd& part : parts(kept_)) {
    known_ += part;
  }
}

ThesisSelection PlanScore::thesis() const {
  return {robot_, supportSole(robot_, options_.poses.supportFoot), cameras_, judge_.joints(), options_.weights};
}

Interaction PlanScore::interaction(const std::vector<SievedPose>& poses) const {
  return thesis().interaction(poses);
}

std::vector<SievedPose> PlanScore::best(const std::vector<SievedPose>& candidates, std::size_t count) const {
  const std::vector<std::size_t> indices = options_.criterion == Criterion::interaction
                                               ? thesis().chain(candidates, count)
                                               : selected(judge_, known_, parts(candidates), count);
  std::vector<SievedPose> result;
  for (const std::size_t index : indices) {
    result.push_back(candidates[index]);
  }
  return result;
}

std::vector<Eigen::MatrixXd> PlanScore::parts(const std::vector<SievedPose>& poses) const {
  std::vector<Eigen::MatrixXd> result = informations(robot_, scene_, poses, options_.noise);
  for (Eigen::MatrixXd& information : result) {
    information = judge_.part(information);
  }
  return result;
}

Eigen::MatrixXd PlanScore::sum(const std::vector<SievedPose>& poses) const {
  Eigen::MatrixXd result = known_;
  for (const Eigen::MatrixXd& part : parts(poses)) {
    result += part;
  }
  return result;
}

double PlanScore::worstSigma(const Eigen::MatrixXd& sum) const {
  return std::sqrt(judge_.covariance(sum).diagonal().maxCoeff());
}

double PlanScore::value(const Eigen::MatrixXd& sum, const std::vector<SievedPose>& poses) const {
  if (options_.criterion != Criterion::time) {
    return judge_(sum);
  }
  constexpr double farMore = 1e6;
  const double missing = worstSigma(sum) / options_.sigma;
  return missing > 1 ? farMore * missing : secondsToPlay(robot_, poses, options_.secondsPerPose);
}

std::map<std::string, double> PlanScore::sigmas(const std::vector<SievedPose>& poses, bool known) const {
  const PoseJudge judge{robot_, scene_, judge_.joints(), options_.criterion, known};
  Eigen::MatrixXd sum = judge.prior();
  for (const std::vector<SievedPose>* each : {&kept_, &poses}) {
    for (const Eigen::MatrixXd& information : informations(robot_, scene_, *each, options_.noise)) {
      sum += judge.part(information);
    }
  }
  return named(judge.covariance(sum).diagonal());
}

std::map<std::string, double> PlanScore::sigmasOfRobots(const std::vector<SievedPose>& poses) const {
  constexpr int robots = 100;
  const double width = options_.poses.stability.jointError;
  std::mt19937_64 random{options_.poses.seed};
  std::uniform_real_distribution<double> error{-width, width};
  Eigen::VectorXd variances = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(judge_.joints().size()));
  for (int i = 0; i < robots; ++i) {
    std::vector<double> errors(robot_.joints.size());
    std::generate(errors.begin(), errors.end(), [&] { return error(random); });
    std::vector<SievedPose> worn = poses;
    for (SievedPose& pose : worn) {
      for (std::size_t joint = 0; joint < errors.size(); ++joint) {
        pose.belief.angle(joint) += errors[robot_.joints[joint].motor];
      }
    }
    variances += judge_.covariance(sum(worn)).diagonal() / robots;
  }
  return named(variances);
}

std::map<std::string, double> PlanScore::named(const Eigen::VectorXd& variances) const {
  std::map<std::string, double> result;
  for (std::size_t i = 0; i < judge_.joints().size(); ++i) {
    result[robot_.joints[judge_.joints()[i]].name] = std::sqrt(variances[static_cast<Eigen::Index>(i)]);
  }
  return result;
}

} // namespace naocal
