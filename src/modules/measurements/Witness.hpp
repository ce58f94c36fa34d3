#pragma once

#include "camera/ObservationChain.hpp"
#include "math/RigidTransform.hpp"
#include "robot/ModelState.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace naocal {

/// Name of the noise level of contacts.
inline constexpr char contactLevel[] = "contacts";

/// Noise that readings of one instrument share, 1 sigma per axis.
struct ReadingLevel {
  enum class Unit { metres, radians };
  std::string name; // of the tracker, `contactLevel`, or the places of a distance
  Unit unit = Unit::metres;
  double sigma = 0;    // [m] or [rad]; a start value unless it is given
  bool isGiven = true; // by the set's file; else estimated from the captures
};

/// What a witness says at a state: predicted - measured, and its derivatives, before any noise level is applied.
struct WitnessRows {
  static constexpr int most = 6, mostOwn = 13;
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;
  using ByMotion = Eigen::Matrix<double, Eigen::Dynamic, 6, 0, most, 6>;
  using ByOwn = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, mostOwn>;

  Column residual;   // [m] or [rad]
  ByMotion byMotion; // by the motion (omega, v) of the world seen from the link, in the link's frame
  ByOwn byOwn;       // by `Witness::own`, in that order
};

/// A measurement other than board corners: where a link, or something on it, is in the world. One class per kind, in a
/// file of its own.
///
/// Enters the normal equations as whitened rows: `WitnessRows` / sigma, times the motion of the world in the link by
/// each of the robot's quantities (camera/ObservationChain.hpp).
class Witness {
public:
  virtual ~Witness() = default;
  virtual WitnessRows compare(const RigidTransform& linkFromWorld, const ModelState& modelState) const = 0;

  /// Rows of one level and unit: a vector whose length is the reading's error.
  struct Part {
    Eigen::Index first = 0, count = 0;
    std::size_t level = 0; // index into `Measurements::levels`
  };
  const std::vector<Part>& parts() const { return parts_; }
  /// The quantities of its own that it depends on (`StateLayout`): placements of instruments.
  const std::vector<std::size_t>& own() const { return own_; }
  /// The marker or frame that was measured; empty if none was.
  const std::string& target() const { return target_; }

protected:
  Witness(std::vector<Part> parts, std::vector<std::size_t> own, std::string target)
      : parts_{std::move(parts)}, own_{std::move(own)}, target_{std::move(target)} {}

private:
  std::vector<Part> parts_;
  std::vector<std::size_t> own_;
  std::string target_;
};

/// A witness and the chain from its link to the world; without a chain the robot takes no part in it.
struct WitnessObservation {
  std::optional<ObservationChain> view;
  std::shared_ptr<const Witness> witness;
  double weight = 1; // below 1: doubtful, as `CornerBlock::present` of a corner
};

} // namespace naocal
