#include "residuals/Residuals.hpp"

#include "residuals/ResidualsParts.hpp"

#include <algorithm>
#include <set>

namespace naocal {

namespace {

Eigen::Index at(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

std::vector<const View*> viewsOf(const Picture& picture) {
  std::vector<const View*> views;
  for (const Sighting& sighting : picture.sightings) {
    views.push_back(&sighting.view);
  }
  if (picture.otherSole) {
    views.push_back(&*picture.otherSole);
  }
  return views;
}

/// A point in general position: no derivative vanishes there by accident.
Eigen::VectorXd generic(const Eigen::VectorXd& sigmas) {
  Eigen::VectorXd result = sigmas;
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    result[i] *= 0.1 + 0.01 * static_cast<double>(i % 7);
  }
  return result;
}

} // namespace

Residuals::Residuals(const Measurements& measurements, const Model& model, const Noise& noise, const Loss& loss)
    : measurements_{measurements}, model_{model}, noise_{noise}, loss_{loss}, sigmas_{model.sigmas()},
      free_(model.unknownCount(), true) {
  for (std::size_t pose = 0; pose < measurements.poses.size(); ++pose) {
    deflection_.emplace_back(measurements.poses[pose].encoderErrors.size(), -1);
    empty_.push_back(emptySystem(pose));
    roots_.push_back(deflectionRoot(empty_.back(), noise_));
  }
  prepared_.resize(measurements.pictures.size());
  for (std::size_t pose = 0; pose < measurements.poses.size(); ++pose) {
    for (const Reading& reading : measurements.poses[pose].readings) {
      for (std::size_t picture : reading.pictures) {
        prepared_[picture] = prepared(measurements.pictures[picture], pose, generic(sigmas_));
      }
    }
  }
}

Residuals::~Residuals() = default;

/// A pose's columns: the unknowns it depends on, and a deflection per joint on its paths and encoder error.
PoseSystem Residuals::emptySystem(std::size_t poseIndex) {
  const PoseGroup& pose = measurements_.poses[poseIndex];
  std::set<std::size_t> unknowns;
  std::set<std::pair<std::size_t, std::size_t>> errors; // motor, encoder error
  for (const Reading& reading : pose.readings) {
    for (std::size_t index : reading.pictures) {
      const Picture& picture = measurements_.pictures[index];
      for (const Slope& slope : slopes(measurements_, model_, picture, generic(sigmas_))) {
        unknowns.insert(slope.unknown);
      }
      for (const View* view : viewsOf(picture)) {
        for (std::size_t joint : view->joints()) {
          errors.emplace(measurements_.robot.joints[joint].motor, reading.encoderError[joint]);
        }
      }
    }
  }
  PoseSystem system;
  system.unknowns.assign(unknowns.begin(), unknowns.end());
  if (noise_.encoder > 0 || noise_.pose > 0) {
    for (const auto& [motor, error] : errors) {
      deflection_[poseIndex][error] = static_cast<int>(system.joints.size());
      system.joints.push_back(motor);
      system.errorScales.push_back(pose.encoderErrors[error]);
    }
  }
  const Eigen::Index rows = at(system.unknowns.size()), deflections = at(system.joints.size());
  system.unknownGram.setZero(rows, rows);
  system.cross.setZero(rows, deflections);
  system.deflectionGram.setZero(deflections, deflections);
  system.unknownGradient.setZero(rows);
  system.deflectionGradient.setZero(deflections);
  return system;
}

Residuals::Prepared Residuals::prepared(const Picture& picture, std::size_t pose,
                                        const Eigen::VectorXd& unknowns) const {
  Prepared result;
  std::set<std::size_t> links, joints, others;
  for (const View* view : viewsOf(picture)) {
    links.insert(view->links().begin(), view->links().end());
    joints.insert(view->joints().begin(), view->joints().end());
  }
  result.links.assign(links.begin(), links.end());
  result.joints.assign(joints.begin(), joints.end());
  const Quantities& quantities = measurements_.quantities;
  const std::vector<Slope> all = slopes(measurements_, model_, picture, unknowns);
  for (const Slope& slope : all) {
    if (slope.quantity >= quantities.axis(0)) {
      others.insert(slope.quantity);
    }
  }
  for (std::size_t joint : joints) {
    result.quantities.push_back(quantities.angle(joint));
  }
  result.quantities.insert(result.quantities.end(), others.begin(), others.end());
  const std::vector<std::size_t>& local = empty_[pose].unknowns;
  for (const Slope& slope : all) {
    const auto slot = std::find(result.quantities.begin(), result.quantities.end(), slope.quantity);
    const auto column = std::lower_bound(local.begin(), local.end(), slope.unknown);
    result.entries.push_back({slope.quantity, slope.unknown,
                              slot == result.quantities.end() ? -1 : slot - result.quantities.begin(),
                              column - local.begin(), slope.value});
  }
  for (const Sighting& sighting : picture.sightings) {
    result.extras.emplace_back();
    for (std::size_t quantity : others) {
      if (const auto extra = sighting.view.extra(quantity)) {
        result.extras.back().push_back(*extra);
      }
    }
  }
  return result;
}

Belief Residuals::belief(const Picture& picture, const Prepared& prepared, const Reading& reading, std::size_t pose,
                         const Eigen::VectorXd& unknowns, const Eigen::VectorXd& deflections) const {
  Belief result = model_.linear() ? picture.drawn : believed(measurements_, model_, picture, unknowns);
  if (model_.linear()) {
    for (const Prepared::Entry& entry : prepared.entries) {
      result.values[at(entry.quantity)] += entry.value * unknowns[at(entry.unknown)];
    }
  }
  for (std::size_t joint : prepared.joints) {
    const int deflection = deflection_[pose][reading.encoderError[joint]];
    if (deflection >= 0) {
      result.angle(joint) += deflections[deflection];
    }
  }
  return result;
}

Residuals::State Residuals::start(const Eigen::VectorXd& unknowns) const {
  State state{unknowns, {}};
  for (const PoseSystem& pose : empty_) {
    state.deflections.push_back(Eigen::VectorXd::Zero(at(pose.joints.size())));
  }
  return state;
}

std::optional<Residuals::Linear> Residuals::linearised(const State& state) const {
  Linear result;
  Workspace work;
  const Eigen::VectorXd inPrior = state.unknowns.cwiseQuotient(sigmas_);
  result.cost = 0.5 * inPrior.squaredNorm();
  result.gradient = inPrior.cwiseQuotient(sigmas_);
  result.hessian = sigmas_.cwiseAbs2().cwiseInverse().asDiagonal();
  result.poses = empty_;
  for (std::size_t pose = 0; pose < empty_.size(); ++pose) {
    PoseSystem& system = result.poses[pose];
    const Eigen::VectorXd deflections = roots_[pose] * state.deflections[pose];
    for (const Reading& reading : measurements_.poses[pose].readings) {
      for (std::size_t index : reading.pictures) {
        const Picture& picture = measurements_.pictures[index];
        const Prepared fresh = model_.linear() ? Prepared{} : prepared(picture, pose, state.unknowns);
        const Prepared& ready = model_.linear() ? prepared_[index] : fresh;
        if (!addPicture(picture, ready, belief(picture, ready, reading, pose, state.unknowns, deflections), reading,
                        pose, work, system)) {
          return std::nullopt;
        }
      }
    }
    // expressed at zero deflection
    const Eigen::VectorXd drop = system.deflectionGram * deflections;
    system.squares += deflections.dot(drop - 2 * system.deflectionGradient);
    system.deflectionGradient -= drop;
    system.unknownGradient -= system.cross * deflections;
    result.cost += 0.5 * state.deflections[pose].squaredNorm();
    result.eliminated.push_back(eliminated(system, noise_, roots_[pose]));
    const Eliminated& part = result.eliminated.back();
    for (std::size_t i = 0; i < system.unknowns.size(); ++i) {
      result.gradient[at(system.unknowns[i])] += part.unknownGradient[at(i)];
      for (std::size_t j = 0; j < system.unknowns.size(); ++j) {
        result.hessian(at(system.unknowns[i]), at(system.unknowns[j])) += part.hessian(at(i), at(j));
      }
    }
  }
  result.cost += 0.5 * work.cost;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (!free_[i]) {
      result.gradient[at(i)] = 0;
      result.hessian.row(at(i)).setZero();
      result.hessian.col(at(i)).setZero();
      result.hessian(at(i), at(i)) = 1;
    }
  }
  return result;
}

Residuals::State Residuals::moved(const State& state, const Linear& linear, const Eigen::VectorXd& step) const {
  State result{state.unknowns + step, {}};
  for (std::size_t pose = 0; pose < empty_.size(); ++pose) {
    const Eliminated& part = linear.eliminated[pose];
    Eigen::VectorXd local(at(empty_[pose].unknowns.size()));
    for (std::size_t i = 0; i < empty_[pose].unknowns.size(); ++i) {
      local[at(i)] = step[at(empty_[pose].unknowns[i])];
    }
    result.deflections.push_back(-part.inner.solve(part.gradient + part.cross.transpose() * local));
  }
  return result;
}

} // namespace naocal
