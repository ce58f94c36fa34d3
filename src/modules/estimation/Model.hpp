#pragma once

#include "effects/Catalogue.hpp"
#include "measurements/Measurements.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace naocal {

/// An effect at a place, with its range in the vector of unknowns.
struct Term {
  Effect effect;
  std::size_t placeIndex =
      0;                 // index of motor's joint, joint, camera, target, sole, length or stance; 0 for PlaceKind::all
  std::string placeName; // LKneePitch
  std::size_t first = 0; // index of its first unknown
  bool isPlacement = false; // placement of a board, stance, instrument, ...: an unknown, but not physical
  bool requested = true;    // false: an offset added only because torques depend on it

  std::string label() const { return effect.name + "@" + placeName; }
  std::span<const double> values(const Eigen::VectorXd& unknowns) const {
    return {unknowns.data() + first, effect.unknowns.size()};
  }
  /// Prior standard deviations of its unknowns.
  Eigen::VectorXd sigmas() const;
};

/// The unknowns to estimate: effects at places, then placements.
class Model {
public:
  void add(Term term);

  const std::vector<Term>& terms() const { return terms_; }
  /// The term with this label, or null.
  const Term* find(const std::string& label) const;
  /// Indices of the joint offset terms. Angles, torques and the centre of mass, which drive other effects, depend on
  /// them.
  const std::vector<std::size_t>& offsets() const { return offsets_; }
  std::size_t unknownCount() const { return unknownCount_; }

  /// Standard deviation of each unknown's zero-mean prior.
  Eigen::VectorXd sigmas() const;
  /// Full name of each unknown: "jointOffset@LKneePitch.o".
  std::vector<std::string> names() const;
  /// Unit of each unknown: "rad", "m", ...
  std::vector<std::string> units() const;

private:
  std::vector<Term> terms_;
  std::vector<std::size_t> offsets_;
  std::size_t unknownCount_ = 0;
};

/// Canonical label of a motor's effect, resolving aliases of the effect and the right hip yaw-pitch, which shares the
/// motor of the left one.
std::string labelFor(const std::string& given, const Robot& robot);

/// Whether a joint lies between the torso and a sole.
bool isOnLeg(const Robot& robot, std::size_t joint);

/// Whether a stance is attached to this sole; with both feet on the floor, to the left one.
bool isStanceSole(const Sole& sole, const RobotSample& instant);

/// A place that a term corrects. An effect of a motor acts on the motor's own joint, `source`; a joint that mimics it
/// turns `ratio` times as far.
struct CorrectedPlace {
  std::size_t place, source = place;
  double ratio = 1;

  void correct(ModelState& modelState, const Effect& effect, const RobotSample& instant,
               std::span<const double> values) const;
};

/// What a term corrects in a picture: each joint driven by its motor, each board for a shared effect, or its single
/// place. Empty if the picture does not involve it.
std::vector<CorrectedPlace> placesOn(const Term& term, const Measurements& measurements,
                                     const ImageObservation& picture);

/// Transfers unknowns to another model by name; new unknowns are zero.
Eigen::VectorXd mapParameters(const Model& from, const Eigen::VectorXd& unknowns, const Model& to);

} // namespace naocal
