#include "residuals/Slopes.hpp"

#include <algorithm>
#include <cstring>
#include <functional>

namespace naocal {

namespace {

/// What a correction looks at and that follows the offsets.
std::vector<Elsewhere> drivers(const Effect& effect, std::size_t place) {
  std::vector<Elsewhere> looks = effect.elsewhere, result;
  for (const Driver driver : effect.needs) {
    looks.push_back({driver, place});
  }
  for (const Elsewhere& look : looks) {
    if (look.driver == Driver::com) {
      result.push_back({look.driver, 0});
      result.push_back({look.driver, 1});
    } else if (look.driver == Driver::angle || look.driver == Driver::torque || look.driver == Driver::torqueGrowth) {
      result.push_back(look);
    }
  }
  return result;
}

/// Drivers in general position, so that no correction vanishes by accident.
Instant generic(const Instant& recorded) {
  Instant result = recorded;
  result.q = Eigen::VectorXd::LinSpaced(recorded.q.size(), 0.2, 0.4);
  result.torque = Eigen::VectorXd::LinSpaced(recorded.q.size(), 0.01, 0.02);
  result.torqueGrowth = Eigen::VectorXd::LinSpaced(recorded.q.size(), 0.1, 0.2);
  result.com = {0.02, 0.03};
  return result;
}

/// The first place from `first` on where the two differ; their size where there is none.
Eigen::Index firstDifference(const Eigen::VectorXd& one, const Eigen::VectorXd& other, Eigen::Index first) {
  constexpr Eigen::Index atOnce = 16;
  while (first + atOnce <= one.size() &&
         std::memcmp(one.data() + first, other.data() + first, atOnce * sizeof(double)) == 0) {
    first += atOnce;
  }
  return std::mismatch(one.data() + first, one.data() + one.size(), other.data() + first).first - one.data();
}

/// Whether a quantity moves something that the picture shows.
class Visible {
public:
  Visible(const Measurements& measurements, const Picture& picture)
      : quantities_{measurements.quantities}, picture_{picture}, joints_(measurements.robot.joints.size(), 0) {
    for (const std::size_t joint : jointsBetween(measurements.robot, picture)) {
      joints_[joint] = 1;
    }
  }
  bool operator()(std::size_t quantity) const {
    if (quantity < quantities_.axis(0)) {
      return joints_[quantity] != 0; // an angle has its joint's number
    }
    if (quantity < quantities_.length(0)) {
      return joints_[(quantity - quantities_.axis(0)) / 3] != 0;
    }
    if (quantity < quantities_.board(0)) {
      return true;
    }
    const std::size_t board = (quantity - quantities_.board(0)) / (quantities_.board(1) - quantities_.board(0));
    return std::any_of(picture_.sightings.begin(), picture_.sightings.end(),
                       [&](const Sighting& sighting) { return sighting.view.board() == board; });
  }

private:
  const Quantities& quantities_;
  const Picture& picture_;
  std::vector<char> joints_;
};

} // namespace

std::vector<std::size_t> jointsBetween(const Robot& robot, const Picture& picture) {
  std::vector<char> between(robot.joints.size(), 0);
  const auto add = [&](const View& view) {
    for (const std::size_t joint : view.joints()) {
      between[joint] = 1;
    }
  };
  for (const Sighting& sighting : picture.sightings) {
    add(sighting.view);
  }
  if (picture.otherSole) {
    add(*picture.otherSole);
  }
  std::vector<std::size_t> joints;
  for (std::size_t joint = 0; joint < between.size(); ++joint) {
    if (between[joint] != 0) {
      joints.push_back(joint);
    }
  }
  return joints;
}

PictureSlopes::PictureSlopes(const Measurements& measurements, const Model& model, const Picture& picture) {
  const Visible visible{measurements, picture};
  std::optional<Instant> inGeneral; // made where a term varies
  Belief belief = picture.drawn;
  std::vector<Varying> varying;
  for (std::size_t term = 0; term < model.terms().size(); ++term) {
    for (const std::size_t place : placesOn(model.terms()[term], measurements, picture)) {
      Varying found = correction(model, picture, term, place, belief, inGeneral);
      if (std::any_of(found.quantities.begin(), found.quantities.end(), std::cref(visible))) {
        varying.push_back(std::move(found));
      }
    }
  }
  std::erase_if(slopes_, [&](const Slope& slope) { return !visible(slope.quantity); });
  fixedCount_ = slopes_.size();
  for (Varying& each : varying) {
    listSlopes(measurements.robot, model, std::move(each));
  }
}

/// Lists the slopes of a correction that is fixed; of one that varies, tells what it moves.
PictureSlopes::Varying PictureSlopes::correction(const Model& model, const Picture& picture, std::size_t term,
                                                 std::size_t place, Belief& belief, std::optional<Instant>& inGeneral) {
  const Effect& effect = model.terms()[term].effect;
  Varying result{term, place, {}, drivers(effect, place), {}};
  const bool fixed = effect.linear && result.drivers.empty();
  if (!effect.definition.empty()) { // a user's effect turns its joint, be it nowhere but beyond a dead band
    result.quantities.push_back(picture.drawn.quantities().angle(place));
    return result;
  }
  if (!fixed && !inGeneral) {
    inGeneral = generic(picture.instant);
  }
  const Instant& instant = fixed ? picture.instant : *inGeneral;
  const Eigen::VectorXd& drawn = picture.drawn.values;
  std::vector<double> values(effect.unknowns.size(), 0);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double step = effect.unknowns[k].sigma;
    values[k] = step;
    effect.correct(belief, instant, place, values);
    values[k] = 0;
    for (Eigen::Index i = firstDifference(belief.values, drawn, 0); i < drawn.size();
         i = firstDifference(belief.values, drawn, i + 1)) {
      const auto quantity = static_cast<std::size_t>(i);
      const double slope = (belief.values[i] - drawn[i]) / step;
      belief.values[i] = drawn[i];
      if (fixed) {
        slopes_.push_back({quantity, model.terms()[term].first + k, slope});
      } else if (std::find(result.quantities.begin(), result.quantities.end(), quantity) == result.quantities.end()) {
        result.quantities.push_back(quantity);
      }
    }
  }
  return result;
}

void PictureSlopes::listSlopes(const Robot& robot, const Model& model, Varying varying) {
  const Term& term = model.terms()[varying.term];
  for (std::size_t i = 0; i < model.offsets().size(); ++i) {
    const std::size_t motor = model.terms()[model.offsets()[i]].at;
    if (std::any_of(varying.drivers.begin(), varying.drivers.end(), [&](const Elsewhere& driver) {
          return driver.driver != Driver::angle || robot.joints[driver.joint].motor == motor;
        })) {
      varying.offsets.push_back(i);
    }
  }
  for (const std::size_t quantity : varying.quantities) {
    for (std::size_t k = 0; k < term.effect.unknowns.size(); ++k) {
      slopes_.push_back({quantity, term.first + k, 0});
    }
    for (const std::size_t offset : varying.offsets) {
      slopes_.push_back({quantity, model.terms()[model.offsets()[offset]].first, 0});
    }
  }
  varying_.push_back(std::move(varying));
}

void PictureSlopes::addFixed(const Eigen::VectorXd& unknowns, Belief& belief) const {
  for (std::size_t i = 0; i < fixedCount_; ++i) {
    belief.values[static_cast<Eigen::Index>(slopes_[i].quantity)] +=
        slopes_[i].value * unknowns[static_cast<Eigen::Index>(slopes_[i].unknown)];
  }
}

std::vector<Slope> slopes(const Measurements& measurements, const Model& model, const Picture& picture,
                          const Eigen::VectorXd& unknowns) {
  const PictureSlopes all{measurements, model, picture};
  std::vector<Slope> result = all.list();
  if (all.vary()) {
    Driven driven = drivenAt(measurements, model, picture, unknowns);
    PictureSlopes::Scratch scratch;
    Belief belief = picture.drawn;
    std::vector<double> values(result.size() - all.fixedCount());
    all.addVarying(model, picture, unknowns, driven, scratch, belief, values.data());
    for (std::size_t i = 0; i < values.size(); ++i) {
      result[all.fixedCount() + i].value = values[i];
    }
  }
  return result;
}

} // namespace naocal
