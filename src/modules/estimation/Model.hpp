#pragma once

#include "effects/Catalogue.hpp"
#include "measurements/Measurements.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace naocal {

/// An effect at a place, with its share of the vector of unknowns.
struct Term {
  Effect effect;
  std::size_t site = 0;     // the motor's joint, joint, camera, target, sole, length or standing; 0 for Place::all
  std::string place;        // its name
  std::size_t first = 0;    // its first unknown
  bool isPlacement = false; // where a board or a stance lies: not physics, but unknown as well
  bool requested = true;    // false: an offset that is along only because torques depend on it

  std::string label() const { return effect.name + "@" + place; }
  std::span<const double> values(const Eigen::VectorXd& unknowns) const {
    return {unknowns.data() + first, effect.unknowns.size()};
  }
  /// How large its unknowns plausibly are.
  Eigen::VectorXd sigmas() const;
};

/// What is to be estimated: effects at places, then the unknown placements.
class Model {
public:
  void add(Term term);

  const std::vector<Term>& terms() const { return terms_; }
  /// The term with this label; null where there is none.
  const Term* find(const std::string& label) const;
  /// Which terms are joint offsets: on them depend angles, torques and the centre of mass that drive other effects.
  const std::vector<std::size_t>& offsets() const { return offsets_; }
  std::size_t unknownCount() const { return unknownCount_; }

  /// sigma of each unknown: its prior about zero.
  Eigen::VectorXd sigmas() const;
  /// "jointOffset@LKneePitch.o" of each unknown.
  std::vector<std::string> names() const;
  /// "rad", "m", ... of each unknown.
  std::vector<std::string> units() const;

private:
  std::vector<Term> terms_;
  std::vector<std::size_t> offsets_;
  std::size_t unknownCount_ = 0;
};

/// The label of a motor's effect that may be given by other names: the effect's alias, and the right hip yaw-pitch,
/// which has no motor of its own and stands for the left one.
std::string labelFor(const std::string& given, const Robot& robot);

/// Whether a joint lies between the torso and a sole.
bool isOnLeg(const Robot& robot, std::size_t joint);

/// Whether a foot's stance frame is this sole: on both feet it is the left one.
bool isStanceSole(const Sole& sole, SupportFoot foot);

/// Where a term corrects on a picture: each joint that its motor drives, each board if it sits everywhere, or just its
/// place; nowhere if the picture has nothing to do with it.
std::vector<std::size_t> sitesOn(const Term& term, const Measurements& measurements, const ImageObservation& picture);

/// Unknowns of one model in the order of another, by their names; new ones at zero.
Eigen::VectorXd mapParameters(const Model& from, const Eigen::VectorXd& unknowns, const Model& to);

} // namespace naocal
