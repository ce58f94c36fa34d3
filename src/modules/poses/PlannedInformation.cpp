#include "poses/PlannedInformation.hpp"

#include "io/InputError.hpp"
#include "residuals/Candidates.hpp"
#include "residuals/Carried.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>

namespace naocal {

namespace {

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

} // namespace

double samplesOf(const Measurements& measurements) {
  std::size_t pictures = 0;
  std::set<std::pair<const PoseGroup*, std::size_t>> views;
  for (const PoseGroup& pose : measurements.poses) {
    for (const Reading& reading : pose.readings) {
      for (const std::size_t picture : reading.pictures) {
        ++pictures;
        views.insert({&pose, measurements.pictures[picture].camera});
      }
    }
  }
  return std::round(static_cast<double>(pictures) / static_cast<double>(views.size()));
}

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

void PoseInformation::addTo(Eigen::MatrixXd& sum) const {
  sum(unknowns, unknowns) += hessian;
}

PoseInformation informationOf(PoseSystem pose, const Noise& noise, double samples) {
  pose.unknownGram *= samples;
  pose.cross *= samples;
  pose.deflectionGram *= samples;
  return {pose.unknowns, eliminated(pose, noise, deflectionRoot(pose, noise)).hessian};
}

PlannedInformation plannedInformation(const std::vector<CaptureSet>& sets, const Measurements& measurements,
                                      const FittedModel& fit, const OpenQuestion& question,
                                      const std::vector<Surroundings>& around, const std::vector<ProposedPose>& poses,
                                      bool samePlace) {
  const Measurements extended =
      measurementsOf(withPlanned(sets, measurements.robot, poses), measurements.robot, samePlace);
  PlannedInformation result{makeModel(extended, question.with, question.without, question.effects), {}, {}};
  const Model model = withSuspects(extended, result.own, question);
  const Residuals residuals{extended, model, fit.noise};
  const auto linear = residuals.linearised(residuals.start(unknownsOf(extended, model, fit, around)));
  if (!linear) {
    throw InputError{"the fit puts a corner that was seen behind the camera: these captures do not belong together"};
  }
  std::map<std::string, std::size_t> planned;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    planned[plannedName(i)] = i;
  }
  const double samples = samplesOf(measurements);
  result.known = model.sigmas().cwiseAbs2().cwiseInverse().asDiagonal();
  result.promised.resize(poses.size());
  for (std::size_t pose = 0; pose < linear->poses.size(); ++pose) {
    if (const auto found = planned.find(extended.poses[pose].name); found != planned.end()) {
      result.promised[found->second] = informationOf(linear->poses[pose], fit.noise, samples);
    } else {
      informationOf(linear->poses[pose], fit.noise).addTo(result.known);
    }
  }
  return result;
}

} // namespace naocal
