#include "estimation/Model.hpp"

#include "effects/Catalogue.hpp"
#include "estimation/DriverState.hpp"

#include <algorithm>
#include <map>

namespace naocal {

Eigen::VectorXd mapParameters(const Model& from, const Eigen::VectorXd& unknowns, const Model& to) {
  std::map<std::string, double> values;
  const std::vector<std::string> names = from.names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    values[names[i]] = unknowns[static_cast<Eigen::Index>(i)];
  }
  Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(to.unknownCount()));
  const std::vector<std::string> wanted = to.names();
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (const auto found = values.find(wanted[i]); found != values.end()) {
      result[static_cast<Eigen::Index>(i)] = found->second;
    }
  }
  return result;
}

void Model::add(Term term) {
  term.first = unknownCount_;
  unknownCount_ += term.effect.unknowns.size();
  if (term.effect.name == effectName::jointOffset) {
    offsets_.push_back(terms_.size());
  }
  terms_.push_back(std::move(term));
}

Eigen::VectorXd Term::sigmas() const {
  Eigen::VectorXd result(static_cast<Eigen::Index>(effect.unknowns.size()));
  for (std::size_t i = 0; i < effect.unknowns.size(); ++i) {
    result[static_cast<Eigen::Index>(i)] = effect.unknowns[i].sigma;
  }
  return result;
}

const Term* Model::find(const std::string& label) const {
  const auto found =
      std::find_if(terms_.begin(), terms_.end(), [&](const Term& term) { return term.label() == label; });
  return found == terms_.end() ? nullptr : &*found;
}

Eigen::VectorXd Model::sigmas() const {
  Eigen::VectorXd result(static_cast<Eigen::Index>(unknownCount_));
  for (const Term& term : terms_) {
    result.segment(static_cast<Eigen::Index>(term.first), static_cast<Eigen::Index>(term.effect.unknowns.size())) =
        term.sigmas();
  }
  return result;
}

std::vector<std::string> Model::names() const {
  std::vector<std::string> result;
  for (const Term& term : terms_) {
    for (const Unknown& unknown : term.effect.unknowns) {
      result.push_back(term.label() + "." + unknown.name);
    }
  }
  return result;
}

std::vector<std::string> Model::units() const {
  std::vector<std::string> result;
  for (const Term& term : terms_) {
    for (const Unknown& unknown : term.effect.unknowns) {
      result.push_back(unknown.unit);
    }
  }
  return result;
}

bool isStanceSole(const Sole& sole, const RobotSample& instant) {
  if (instant.supportLink) {
    return sole.link == *instant.supportLink;
  }
  return instant.supportFoot == SupportFoot::right ? sole.name == "right"
                                                   : instant.supportFoot != SupportFoot::none && sole.name == "left";
}

void CorrectedPlace::correct(ModelState& modelState, const Effect& effect, const RobotSample& instant,
                             std::span<const double> values) const {
  if (source == place) {
    return effect.correct(modelState, instant, place, values);
  }
  double& angle = modelState.angle(source);
  const double before = angle;
  angle = 0; // so that no digit of the change is lost
  effect.correct(modelState, instant, source, values);
  modelState.angle(place) += ratio * angle;
  angle = before;
}

std::vector<CorrectedPlace> placesOn(const Term& term, const Measurements& measurements,
                                     const ImageObservation& picture) {
  const Robot& robot = measurements.robot;
  const auto only = [&](bool concerned) {
    return concerned ? std::vector<CorrectedPlace>{{term.placeIndex}} : std::vector<CorrectedPlace>{};
  };
  std::vector<CorrectedPlace> result;
  switch (term.effect.placeKind) {
  case PlaceKind::motor:
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      if (robot.joints[joint].motor == term.placeIndex) {
        result.push_back({joint, term.placeIndex, robot.joints[joint].ratio});
      }
    }
    return result;
  case PlaceKind::board:
    if (term.placeIndex != allPlaces) {
      return only(true);
    }
    for (std::size_t board = 0; board < measurements.targets.size(); ++board) {
      if (measurements.targets[board].board.pattern) {
        result.push_back({board});
      }
    }
    return result;
  case PlaceKind::camera:
    return only(term.placeIndex == picture.camera);
  case PlaceKind::stance:
    return only(term.placeIndex == picture.stance);
  case PlaceKind::sole:
    return only(isStanceSole(robot.soles[term.placeIndex], picture.instant));
  case PlaceKind::tracker:
  case PlaceKind::marker:
  case PlaceKind::frame:
  case PlaceKind::place:
  case PlaceKind::joint:
  case PlaceKind::length:
  case PlaceKind::all:
    break;
  }
  return only(true);
}

ModelState predictState(const Measurements& measurements, const Model& model, const ImageObservation& picture,
                        const Eigen::VectorXd& unknowns) {
  const RobotSample instant = sampleAt(measurements, model, picture, unknowns);
  ModelState modelState = picture.nominal;
  for (const Term& term : model.terms()) {
    for (const CorrectedPlace& place : placesOn(term, measurements, picture)) {
      place.correct(modelState, term.effect, instant, term.values(unknowns));
    }
  }
  return modelState;
}

std::string labelFor(const std::string& given, const Robot& robot) {
  const std::size_t split = std::min(given.find('@'), given.size());
  std::string effect = given.substr(0, split), place = given.substr(split);
  for (const Effect& known : allEffects()) {
    effect = !known.alias.empty() && known.alias == effect ? known.name : effect;
  }
  if (const auto joint = place.empty() ? std::nullopt : robot.jointIndex(place.substr(1))) {
    place = '@' + robot.joints[robot.joints[*joint].motor].name;
  }
  return effect + place;
}

} // namespace naocal
