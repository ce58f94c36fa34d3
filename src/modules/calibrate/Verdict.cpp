#include "calibrate/Verdict.hpp"

#include "geometry/Angles.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace naocal {

namespace {

Eigen::Index at(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

/// Directions in the space of the physical unknowns (each in units of its prior) whose posterior is still wide.
std::vector<WeakDirection> weakDirections(const Model& model, const CalibrationResult& result) {
  constexpr double wide = 0.3;    // of the prior's sigma
  constexpr double shared = 0.25; // smallest share worth naming
  std::vector<std::size_t> physical;
  for (const Term& term : model.terms()) {
    for (std::size_t i = 0; i < term.effect.unknowns.size() && !term.isPlacement; ++i) {
      physical.push_back(term.first + i);
    }
  }
  const Eigen::VectorXd sigmas = model.sigmas();
  Eigen::MatrixXd relative(at(physical.size()), at(physical.size()));
  for (std::size_t i = 0; i < physical.size(); ++i) {
    for (std::size_t j = 0; j < physical.size(); ++j) {
      relative(at(i), at(j)) =
          result.covariance(at(physical[i]), at(physical[j])) / (sigmas[at(physical[i])] * sigmas[at(physical[j])]);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen{relative};
  const std::vector<std::string> names = model.names();
  std::vector<WeakDirection> weak;
  for (Eigen::Index k = relative.rows() - 1; k >= 0; --k) {
    WeakDirection direction;
    direction.sigma = std::sqrt(std::max(0.0, eigen.eigenvalues()[k]));
    if (direction.sigma < wide) {
      break;
    }
    std::vector<std::string> words;
    Eigen::VectorXd turn = Eigen::VectorXd::Zero(sigmas.size()); // the direction in radians
    direction.unit = "rad";
    for (std::size_t i = 0; i < physical.size(); ++i) {
      const double share = eigen.eigenvectors()(at(i), k);
      if (std::abs(share) > shared) {
        const std::size_t unknown = physical[i];
        direction.parts.emplace_back(names[unknown], share);
        words.push_back(inWords(names[unknown]));
        turn[at(unknown)] = share * sigmas[at(unknown)];
        if (model.units()[unknown] != "rad") {
          direction.unit = "prior sigmas";
        }
      }
    }
    if (direction.unit == "rad") {
      turn.normalize();
      direction.sigma = std::sqrt(turn.dot(result.covariance * turn));
      for (auto& [name, share] : direction.parts) {
        share = turn[std::find(names.begin(), names.end(), name) - names.begin()];
      }
    }
    direction.sentence = words.size() == 1
                             ? fmt::format("these captures hardly tell {}", words.front())
                             : fmt::format("{} can be traded against each other: these captures hardly tell them apart",
                                           fmt::join(words, " and "));
    weak.push_back(std::move(direction));
  }
  return weak;
}

/// How far off a floor point 2 m ahead of the support foot is perceived (1 sigma, both directions together) because of
/// the physical unknowns, with the legs as in a capture and the head straight; the median over captures.
double floorError(const Measurements& measurements, const Model& model, const CalibrationResult& result) {
  std::vector<double> errors;
  for (const Picture& picture : measurements.pictures) {
    const auto sighting = std::find_if(picture.sightings.begin(), picture.sightings.end(),
                                       [&](const Sighting& s) { return measurements.targets[s.view.board()].onFloor; });
    if (sighting == picture.sightings.end()) {
      continue;
    }
    Belief belief = believed(measurements, model, picture, result.unknowns);
    const std::size_t board = sighting->view.board();
    belief.ground().setZero();
    belief.boardPlacement(board) << 2, 0, 0, 0, 0, 0;
    for (std::size_t joint : sighting->view.joints()) {
      const std::size_t link = measurements.robot.joints[joint].link;
      const std::size_t head = measurements.robot.cameras[picture.camera].link;
      const auto towardsHead = linksTowards(measurements.robot, {head});
      if (std::find(towardsHead.begin(), towardsHead.end(), link) != towardsHead.end()) {
        belief.angle(joint) = 0;
      }
    }
    Posture torsoFromLink;
    posture(measurements.robot, belief, sighting->view.links(), torsoFromLink);
    const Attitude attitude = sighting->view.attitude(measurements.robot, belief, torsoFromLink);
    const Eigen::Vector3d point = attitude.opticalFromBoard.translation;
    if (point.z() < 0.1) {
      continue;
    }
    const std::vector<Slope> all = slopes(measurements, model, picture, result.unknowns);
    std::vector<std::size_t> quantities;
    std::vector<Slope> physical;
    for (const Slope& slope : all) {
      if (slope.quantity < measurements.quantities.lens()) {
        physical.push_back(slope);
        quantities.push_back(slope.quantity);
      }
    }
    Eigen::MatrixXd columns(6, at(quantities.size()));
    sighting->view.motion(measurements.robot, attitude, belief, torsoFromLink, quantities, {}, columns);
    const Eigen::Vector3d normal = attitude.opticalFromWorld.rotation.col(2);
    Eigen::MatrixXd slip = Eigen::MatrixXd::Zero(2, result.unknowns.size());
    for (std::size_t i = 0; i < physical.size(); ++i) {
      const Eigen::Vector3d omega = columns.col(at(i)).head<3>();
      const Eigen::Vector3d motion = omega.cross(point) + columns.col(at(i)).tail<3>();
      // the ray stays, the floor moved: where it meets the floor now, in the floor's own axes
      const Eigen::Vector3d shift = point * (motion.dot(normal) / point.dot(normal)) - motion;
      slip.col(at(physical[i].unknown)) +=
          physical[i].value * (attitude.opticalFromWorld.rotation.transpose() * shift).head<2>();
    }
    errors.push_back(std::sqrt((slip * result.covariance * slip.transpose()).trace()));
  }
  if (errors.empty()) {
    return 0;
  }
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2), errors.end());
  const double inflation = std::sqrt(result.chi2 / std::max(1.0, result.dof)) / result.sigmaScale;
  return errors[errors.size() / 2] * std::max(1.0, inflation);
}

} // namespace

std::string inWords(const std::string& unknownName) {
  const std::size_t atSign = unknownName.find('@'), dot = unknownName.rfind('.');
  const std::string effect = unknownName.substr(0, atSign);
  const std::string place = unknownName.substr(atSign + 1, dot - atSign - 1);
  const std::string unknown = unknownName.substr(dot + 1);
  if (effect != "jointOffset") {
    return fmt::format("the {} camera's {} ({})", place, effect, unknown);
  }
  std::string words = place.size() > 1 && place[0] == 'L' && std::isupper(place[1])   ? "the left"
                      : place.size() > 1 && place[0] == 'R' && std::isupper(place[1]) ? "the right"
                                                                                      : "the";
  for (std::size_t i = words == "the" ? 0 : 1; i < place.size(); ++i) {
    if (std::isupper(place[i])) {
      words += ' ';
    }
    words += static_cast<char>(std::tolower(place[i]));
  }
  return words;
}

void judge(const Measurements& measurements, const Model& model, CalibrationResult& result) {
  constexpr double largestFloorError = 0.05;       // [m]
  constexpr double largestScatter = radians(0.03); // [rad]: what a NAO's stiction does at most
  result.weak = weakDirections(model, result);
  result.floorErrorAt2m = floorError(measurements, model, result);
  result.usable = result.converged;
  if (!result.converged) {
    result.warnings.push_back(
        "the search did not converge: try --restarts 20, and check the robot's model and the boards");
  }
  const std::vector<std::string> names = model.names();
  for (const Term& term : model.terms()) {
    const Estimate& estimate = result.estimates[term.first];
    if (term.effect.name == "jointOffset" && estimate.learned < 0.5) {
      result.usable = false;
      result.warnings.push_back(fmt::format("{} cannot be learned from these captures ({:.0f} % learned, ±{:.1f}°): "
                                            "add poses that move it, or leave it out "
                                            "with --without {}",
                                            inWords(names[term.first]), 100 * std::max(0.0, estimate.learned),
                                            degrees(estimate.sigma), term.label()));
    }
  }
  if (result.floorErrorAt2m > largestFloorError) {
    result.usable = false;
    result.warnings.push_back(
        fmt::format("a floor point 2 m ahead would be seen {:.0f} mm off (1 sigma); at most {:.0f} mm "
                    "is good enough to play: take more poses or more boards",
                    1e3 * result.floorErrorAt2m, 1e3 * largestFloorError));
  }
  if (result.pValue < 0.001) {
    result.warnings.push_back(
        fmt::format("the model does not explain these captures (chi2/dof {:.2f}, p {}); error bars "
                    "are widened by {:.2f}; 'naocal diagnose' looks for what is missing",
                    result.chi2 / result.dof,
                    result.pValue < 1e-9 ? "below 1e-9" : fmt::format("{:.1g}", result.pValue), result.sigmaScale));
  }
  if (result.noise.pose > largestScatter) {
    result.warnings.push_back(
        fmt::format("joints scatter by {:.3f}° from pose to pose beyond their encoders' noise: stiction, "
                    "or an effect that the model misses; 'naocal diagnose' tells which",
                    degrees(result.noise.pose)));
  }
  std::size_t corners = 0;
  for (const Doubt& doubt : result.doubts) {
    corners += doubt.corners.size();
  }
  if (corners > 0) {
    result.warnings.push_back(
        fmt::format("{} not fit the rest and got little or no weight: listed under doubtful",
                    corners == 1 ? std::string{"1 corner does"} : fmt::format("{} corners do", corners)));
  }
}

} // namespace naocal
