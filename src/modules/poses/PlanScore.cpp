#include "poses/PlanScore.hpp"

#include "poses/PoseOrder.hpp"
#include "poses/TellingApart.hpp"
#include "poses/WornRobots.hpp"

#include <cmath>

namespace naocal {

PlanScore::PlanScore(const Robot& robot, const std::vector<Board>& boards,
                     const std::map<std::string, CameraIntrinsics>& cameras, const PlanOptions& options)
    : robot_{robot}, cameras_{cameras}, options_{options}, boards_{boards}, scene_{robot, options.poses.supportFoot,
                                                                                   boards, cameras,
                                                                                   options.poses.sight},
      judge_{robot, scene_, scene_.joints(), options.criterion, options.known}, worn_{wornRobots(robot, options.poses,
                                                                                                 options.wornRobots,
                                                                                                 1)},
      known_{judge_.prior().replicate(1, static_cast<Eigen::Index>(worn_.size() + 1))} {
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
  if (options_.criterion == Criterion::discriminate) {
    return TellingApart{robot_, boards_, cameras_, options_}.best(kept_, candidates, count);
  }
  const std::vector<std::size_t> indices = options_.criterion == Criterion::interaction
                                               ? thesis().chain(candidates, count)
                                               : selected(judge_, expected(known_), expectedParts(candidates), count);
  std::vector<SievedPose> result;
  for (const std::size_t index : indices) {
    result.push_back(candidates[index]);
  }
  return result;
}

std::optional<double> PlanScore::misfit(const std::vector<SievedPose>& poses) const {
  return options_.effects.empty()
             ? std::nullopt
             : std::optional{TellingApart{robot_, boards_, cameras_, options_}.misfit(kept_, poses)};
}

std::vector<Eigen::MatrixXd> PlanScore::partsOfDrawn(const std::vector<SievedPose>& poses) const {
  std::vector<Eigen::MatrixXd> result = informations(robot_, scene_, poses, options_.noise);
  for (Eigen::MatrixXd& information : result) {
    information = judge_.part(information);
  }
  return result;
}

Eigen::MatrixXd PlanScore::expected(const Eigen::MatrixXd& sum) const {
  Eigen::MatrixXd result = ofRobot(sum, 0);
  for (std::size_t robot = 1; robot <= worn_.size(); ++robot) {
    result += ofRobot(sum, robot) / static_cast<double>(worn_.size());
  }
  return result;
}

std::vector<Eigen::MatrixXd> PlanScore::expectedParts(const std::vector<SievedPose>& poses) const {
  std::vector<Eigen::MatrixXd> result = partsOfDrawn(poses);
  for (const Eigen::VectorXd& errors : worn_) {
    const std::vector<Eigen::MatrixXd> own = partsOfDrawn(takenBy(errors, poses));
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
      result[pose] += own[pose] / static_cast<double>(worn_.size());
    }
  }
  return result;
}

std::vector<Eigen::MatrixXd> PlanScore::parts(const std::vector<SievedPose>& poses) const {
  std::vector<Eigen::MatrixXd> result = partsOfDrawn(poses);
  for (std::size_t robot = 0; robot < worn_.size(); ++robot) {
    const std::vector<Eigen::MatrixXd> own = partsOfDrawn(takenBy(worn_[robot], poses));
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
      if (robot == 0) {
        result[pose].conservativeResize(Eigen::NoChange, known_.cols());
      }
      result[pose].middleCols(static_cast<Eigen::Index>(robot + 1) * known_.rows(), known_.rows()) = own[pose];
    }
  }
  return result;
}

Eigen::MatrixXd PlanScore::ofRobot(const Eigen::MatrixXd& sum, std::size_t robot) const {
  return sum.middleCols(static_cast<Eigen::Index>(robot) * sum.rows(), sum.rows());
}

Eigen::MatrixXd PlanScore::sum(const std::vector<SievedPose>& poses) const {
  Eigen::MatrixXd result = known_;
  for (const Eigen::MatrixXd& part : parts(poses)) {
    result += part;
  }
  return result;
}

double PlanScore::worstSigma(const Eigen::MatrixXd& sum) const {
  return std::sqrt(judge_.covariance(ofRobot(sum, 0)).diagonal().maxCoeff());
}

double PlanScore::value(const Eigen::MatrixXd& sum, const std::vector<SievedPose>& poses) const {
  if (options_.criterion != Criterion::time) {
    double ofWorn = 0;
    for (std::size_t robot = 1; robot <= worn_.size(); ++robot) {
      ofWorn += judge_(ofRobot(sum, robot)) / static_cast<double>(worn_.size());
    }
    return judge_(ofRobot(sum, 0)) + ofWorn;
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
  constexpr std::size_t robots = 100;
  std::vector<SievedPose> all = kept_;
  all.insert(all.end(), poses.begin(), poses.end());
  Eigen::VectorXd variances = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(judge_.joints().size()));
  for (const Eigen::VectorXd& errors : wornRobots(robot_, options_.poses, robots, 2)) {
    Eigen::MatrixXd sum = judge_.prior();
    for (const Eigen::MatrixXd& part : partsOfDrawn(takenBy(errors, all))) {
      sum += part;
    }
    variances += judge_.covariance(sum).diagonal() / robots;
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
