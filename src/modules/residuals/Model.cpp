#include "residuals/Model.hpp"

namespace naocal {

void Model::add(Effect effect, std::size_t at, std::string place, bool isPlacement) {
  linear_ = linear_ && effect.linear;
  const std::size_t count = effect.unknowns.size();
  terms_.push_back({std::move(effect), at, std::move(place), unknownCount_, isPlacement});
  unknownCount_ += count;
}

Eigen::VectorXd Model::sigmas() const {
  Eigen::VectorXd result(static_cast<Eigen::Index>(unknownCount_));
  Eigen::Index i = 0;
  for (const Term& term : terms_) {
    for (const Unknown& unknown : term.effect.unknowns) {
      result[i++] = unknown.sigma;
    }
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

namespace {

bool concerns(const Term& term, const Measurements& measurements, const Picture& picture) {
  switch (term.effect.place) {
  case Place::camera:
    return term.at == picture.camera;
  case Place::stance:
    return term.at == picture.stance;
  case Place::motor:
    return term.at < measurements.robot.joints.size();
  case Place::board:
    return term.at < measurements.targets.size();
  }
  return false;
}

void apply(const Term& term, const Measurements& measurements, const Instant& instant, const Eigen::VectorXd& unknowns,
           Belief& belief) {
  const std::span<const double> values{unknowns.data() + term.first, term.effect.unknowns.size()};
  if (term.effect.place != Place::motor) {
    term.effect.correct(belief, instant, term.at, values);
    return;
  }
  for (std::size_t joint = 0; joint < measurements.robot.joints.size(); ++joint) {
    if (measurements.robot.joints[joint].motor == term.at) {
      term.effect.correct(belief, instant, joint, values);
    }
  }
}

} // namespace

/// Offsets act first: every other effect sees q = measured - o and none sees another's correction.
Belief believed(const Measurements& measurements, const Model& model, const Picture& picture,
                const Eigen::VectorXd& unknowns) {
  Belief belief = picture.drawn;
  Instant instant = picture.instant;
  for (const bool offsets : {true, false}) {
    for (const Term& term : model.terms()) {
      if ((term.effect.name == "jointOffset") == offsets && concerns(term, measurements, picture)) {
        apply(term, measurements, instant, unknowns, belief);
      }
    }
    instant.q = belief.values.head(instant.q.size());
  }
  return belief;
}

std::vector<Slope> slopes(const Measurements& measurements, const Model& model, const Picture& picture,
                          const Eigen::VectorXd& unknowns) {
  const Eigen::VectorXd sigmas = model.sigmas();
  std::vector<Slope> result;
  Eigen::VectorXd moved = unknowns;
  for (const Term& term : model.terms()) {
    if (!concerns(term, measurements, picture)) {
      continue;
    }
    for (std::size_t unknown = term.first; unknown < term.first + term.effect.unknowns.size(); ++unknown) {
      const auto i = static_cast<Eigen::Index>(unknown);
      const double step = 1e-3 * sigmas[i];
      moved[i] = unknowns[i] + step;
      const Eigen::VectorXd above = believed(measurements, model, picture, moved).values;
      moved[i] = unknowns[i] - step;
      const Eigen::VectorXd change = (above - believed(measurements, model, picture, moved).values) / (2 * step);
      moved[i] = unknowns[i];
      for (Eigen::Index quantity = 0; quantity < change.size(); ++quantity) {
        if (change[quantity] != 0) {
          result.push_back({static_cast<std::size_t>(quantity), unknown, change[quantity]});
        }
      }
    }
  }
  return result;
}

} // namespace naocal
