#include "poses/NextPoses.hpp"

#include "captures/InputError.hpp"
#include "poses/Discrimination.hpp"
#include "residuals/Candidates.hpp"
#include "residuals/Carried.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <random>

namespace naocal {

namespace {

/// Attitudes of the drawn robot around the boards, approached at random from above or below; where that matters, each
/// once more the other way.
std::vector<ProposedPose> candidates(const Robot& robot, const CaptureSet& set, const std::vector<Surroundings>& around,
                                     bool bothWays, const NextOptions& options) {
  std::mt19937_64 random{options.seed};
  std::vector<ProposedPose> result;
  for (const Surroundings& here : around) {
    PoseOptions wanted;
    wanted.supportFoot = here.supportFoot;
    wanted.seed = options.seed;
    wanted.stability.draws = 0; // the offsets are known by now: the fitted robot is tried, not any that might be
    const Scene scene{robot, supportSole(robot, here.supportFoot), here.boards, set.cameras, wanted.sight};
    for (const Belief& belief : stableAttitudes(robot, scene, wanted, options.candidates / around.size())) {
      ProposedPose pose{{here.supportFoot, belief.values.head(static_cast<Eigen::Index>(robot.joints.size())), {}}, {}};
      pose.approach.resize(pose.pose.angles.size());
      for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
        const double drawn = random() % 2 == 0 ? 1 : -1;
        const std::size_t motor = robot.joints[joint].motor;
        pose.approach[static_cast<Eigen::Index>(joint)] =
            motor < joint ? pose.approach[static_cast<Eigen::Index>(motor)] : drawn;
      }
      result.push_back(pose);
      if (bothWays) {
        pose.approach = -pose.approach;
        result.push_back(std::move(pose));
      }
    }
  }
  return result;
}

/// The model with the suspects behind its own unknowns.
Model withSuspects(const Measurements& measurements, const Model& model, const OpenQuestion& question) {
  Model result = model;
  const std::vector<Term> terms = candidateTerms(measurements, question.effects);
  for (const Suspect& suspect : question.suspects) {
    const auto term =
        std::find_if(terms.begin(), terms.end(), [&](const Term& each) { return each.label() == suspect.label; });
    if (term == terms.end()) {
      throw InputError{fmt::format("{} has no place in these captures", suspect.label)};
    }
    result.add(*term);
  }
  return result;
}

bool looksAtApproach(const Model& model) {
  return std::any_of(model.terms().begin(), model.terms().end(), [](const Term& term) {
    const auto& needs = term.effect.needs;
    return std::find(needs.begin(), needs.end(), Driver::approach) != needs.end();
  });
}

/// The fit's unknowns in the order of a model of the same captures and planned ones; the robot stands anew where it
/// stood last.
Eigen::VectorXd unknownsOf(const Measurements& extended, const Model& model, const FittedModel& fit,
                           const std::vector<Surroundings>& around) {
  Eigen::VectorXd result = carried(fit.model, fit.unknowns, model);
  for (const Term& term : model.terms()) {
    const auto& fitted = fit.model.terms();
    if (term.effect.place != Place::stance ||
        std::any_of(fitted.begin(), fitted.end(), [&](const Term& each) { return each.label() == term.label(); })) {
      continue;
    }
    for (const Surroundings& here : around) {
      if (here.supportFoot == extended.standings[term.at].supportFoot) {
        result.segment<3>(static_cast<Eigen::Index>(term.first)) << here.sole.x, here.sole.y, here.sole.yaw;
      }
    }
  }
  return result;
}

/// What captures and candidates tell about the unknowns.
struct Informations {
  Eigen::MatrixXd known;                 // priors and captures
  std::vector<PoseInformation> promised; // per candidate
};

Informations informations(const Measurements& extended, const Model& model, const Eigen::VectorXd& unknowns,
                          const Noise& noise, std::size_t poses, double samples) {
  const Residuals residuals{extended, model, noise};
  const auto linear = residuals.linearised(residuals.start(unknowns));
  if (!linear) {
    throw InputError{"the fit puts a corner that was seen behind the camera: these captures do not belong together"};
  }
  std::map<std::string, std::size_t> planned;
  for (std::size_t i = 0; i < poses; ++i) {
    planned[plannedName(i)] = i;
  }
  Informations result{model.sigmas().cwiseAbs2().cwiseInverse().asDiagonal(), {}};
  result.promised.resize(poses);
  for (std::size_t pose = 0; pose < linear->poses.size(); ++pose) {
    if (const auto found = planned.find(extended.poses[pose].name); found != planned.end()) {
      result.promised[found->second] = informationOf(linear->poses[pose], noise, samples);
    } else {
      informationOf(linear->poses[pose], noise).addTo(result.known);
    }
  }
  return result;
}

std::vector<std::size_t> greedily(const Discrimination& discrimination, const Informations& informations,
                                  std::size_t count, Eigen::MatrixXd& known) {
  const Eigen::VectorXd before = discrimination.misfits(known);
  std::vector<std::size_t> chosen;
  while (chosen.size() < std::min(count, informations.promised.size())) {
    double best = -1;
    std::size_t next = 0;
    for (std::size_t i = 0; i < informations.promised.size(); ++i) {
      if (std::find(chosen.begin(), chosen.end(), i) != chosen.end()) {
        continue;
      }
      Eigen::MatrixXd with = known;
      informations.promised[i].addTo(with);
      if (const double gain = discrimination.gain(before, discrimination.misfits(with)); gain > best) {
        best = gain;
        next = i;
      }
    }
    informations.promised[next].addTo(known);
    chosen.push_back(next);
  }
  return chosen;
}

std::map<std::string, double> offsetSigmas(const Model& model, const Eigen::MatrixXd& information) {
  const auto own = static_cast<Eigen::Index>(model.unknownCount());
  const Eigen::MatrixXd covariance =
      information.topLeftCorner(own, own).llt().solve(Eigen::MatrixXd::Identity(own, own));
  std::map<std::string, double> result;
  for (const std::size_t offset : model.offsets()) {
    const Term& term = model.terms()[offset];
    const auto at = static_cast<Eigen::Index>(term.first);
    result[term.place] = std::sqrt(covariance(at, at));
  }
  return result;
}

} // namespace

NextPoses nextPoses(const std::vector<CaptureSet>& sets, const Measurements& measurements, const FittedModel& fit,
                    const OpenQuestion& question, const NextOptions& options) {
  NextPoses result;
  result.why = question.why;
  if (question.suspects.empty() || options.count == 0) {
    return result;
  }
  const Robot& robot = measurements.robot;
  result.around = surroundings(sets, measurements, fit.model, fit.unknowns);
  if (result.around.empty()) {
    return result;
  }
  const bool bothWays = looksAtApproach(withSuspects(measurements, fit.model, question));
  const std::vector<ProposedPose> poses =
      feasibleByFit(sets, measurements, fit.model, fit.unknowns, result.around,
                    candidates(robot, sets.back(), result.around, bothWays, options));
  result.seeing = poses.size();
  result.noise = fit.noise;
  result.firstStance = plannedStance(sets, SupportFoot::left);
  result.samples = std::max(1.0, std::round(static_cast<double>(measurements.pictures.size()) /
                                            static_cast<double>(measurements.poses.size() * robot.cameras.size())));

  const Measurements extended = measurementsOf(withPlanned(sets, robot, poses), robot, options.samePlace);
  const Model own = makeModel(extended, question.with, question.without, question.effects);
  const Model model = withSuspects(extended, own, question);
  const Informations told = informations(extended, model, unknownsOf(extended, model, fit, result.around), fit.noise,
                                         poses.size(), result.samples);
  const Discrimination discrimination{question, static_cast<Eigen::Index>(own.unknownCount())};
  Eigen::MatrixXd known = told.known;
  for (const std::size_t chosen : greedily(discrimination, told, options.count, known)) {
    result.poses.push_back(poses[chosen]);
  }
  result.growth = discrimination.growth(discrimination.misfits(told.known), discrimination.misfits(known));
  result.predictedSigma = offsetSigmas(own, known);
  std::mt19937_64 random{options.seed};
  std::shuffle(result.poses.begin(), result.poses.end(), random);
  return result;
}

NextPoses nextPoses(const std::vector<CaptureSet>& sets, const Measurements& measurements, const Diagnosis& diagnosis,
                    const DiagnosisOptions& asked, const NextOptions& options) {
  const OpenQuestion question = openQuestion(diagnosis, measurements.robot, asked);
  if (question.suspects.empty()) {
    return {};
  }
  const Model model = makeModel(measurements, diagnosis.with, asked.without, asked.effects);
  Noise noise = diagnosis.lastFit.noise;
  noise.pose = diagnosis.scatter;
  return nextPoses(sets, measurements, {model, diagnosis.lastFit.unknowns, noise}, question, options);
}

} // namespace naocal
