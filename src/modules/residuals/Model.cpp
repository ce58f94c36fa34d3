#include "residuals/Model.hpp"

#include <algorithm>

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

/// Offsets act first: every other effect sees q = measured - o and none sees another's correction.
void correct(std::span<const Term> terms, const Measurements& measurements, const Picture& picture,
             const Eigen::VectorXd& unknowns, Belief& belief) {
  const auto isOffset = [](const Term& term) { return term.effect.name == "jointOffset"; };
  belief.values = picture.drawn.values;
  for (const Term& term : terms) {
    if (isOffset(term)) {
      apply(term, measurements, picture.instant, unknowns, belief);
    }
  }
  if (std::all_of(terms.begin(), terms.end(), isOffset)) {
    return;
  }
  Instant instant = picture.instant;
  instant.q = belief.values.head(instant.q.size());
  for (const Term& term : terms) {
    if (!isOffset(term) && concerns(term, measurements, picture)) {
      apply(term, measurements, instant, unknowns, belief);
    }
  }
}

} // namespace

Belief believed(const Measurements& measurements, const Model& model, const Picture& picture,
                const Eigen::VectorXd& unknowns) {
  Belief belief{measurements.quantities};
  correct(model.terms(), measurements, picture, unknowns, belief);
  return belief;
}

std::vector<Slope> slopes(const Measurements& measurements, const Model& model, const Picture& picture,
                          const Eigen::VectorXd& unknowns) {
  const Eigen::VectorXd sigmas = model.sigmas();
  const bool linear = model.linear(); // then every correction stands by itself and is nothing at zero
  std::vector<Slope> result;
  result.reserve(model.unknownCount());
  Eigen::VectorXd moved = linear ? Eigen::VectorXd::Zero(unknowns.size()) : unknowns;
  Belief above{measurements.quantities}, below = picture.drawn;
  for (const Term& term : model.terms()) {
    if (!concerns(term, measurements, picture)) {
      continue;
    }
    const std::span<const Term> terms = linear ? std::span{&term, 1} : std::span{model.terms()};
    for (std::size_t unknown = term.first; unknown < term.first + term.effect.unknowns.size(); ++unknown) {
      const auto i = static_cast<Eigen::Index>(unknown);
      const double here = moved[i], step = 1e-3 * sigmas[i];
      moved[i] = here + step;
      correct(terms, measurements, picture, moved, above);
      if (!linear) {
        moved[i] = here - step;
        correct(terms, measurements, picture, moved, below);
      }
      moved[i] = here;
      const Eigen::VectorXd change = (above.values - below.values) / (linear ? step : 2 * step);
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
