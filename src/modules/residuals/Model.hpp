#pragma once

#include "effects/Catalogue.hpp"
#include "residuals/Measurements.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace naocal {

/// An effect at a place, with its share of the vector of unknowns.
struct Term {
  Effect effect;
  std::size_t at = 0;       // the motor's joint, joint, camera, target, sole, length or standing; 0 for Place::all
  std::string place;        // its name
  std::size_t first = 0;    // its first unknown
  bool isPlacement = false; // where a board or a stance lies: not physics, but unknown as well
  bool asked = true;        // false: an offset that is along only because torques depend on it

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

/// The base model: `jointOffset` of every joint in use, `cameraRotation` of every camera in use, unknown placements;
/// `with` adds and `without` removes effects at places, "E@P" with '*' for any run of letters. Where an effect looks at
/// torques or the centre of mass, the offsets of the other recorded joints that move mass come along. Throws InputError
/// for names that match nothing, and lists the near ones, and for effects that these captures cannot drive.
Model makeModel(const Measurements& measurements, const std::vector<std::string>& with = {},
                const std::vector<std::string>& without = {}, const std::vector<Effect>& effects = allEffects());

/// The label of a motor's effect that may be given by other names: the effect's alias, and the right hip yaw-pitch,
/// which has no motor of its own and stands for the left one.
std::string labelFor(const std::string& given, const Robot& robot);

/// A model with the offsets that come along with `further` terms where those look at torques or the centre of mass.
Model withWeighingOffsets(const Measurements& measurements, Model model, const std::vector<Term>& further);

/// What drives effects at a picture's instant, given the unknowns: q = measured - o; torque and centre of mass of the
/// drawn robot at those angles, the support foot's sole held still and level (both: each leg joint's two values
/// weighted by the feet's loads, all else with the left sole held; none: the torso held, upright).
Instant instantOf(const Measurements& measurements, const Model& model, const Picture& picture,
                  const Eigen::VectorXd& unknowns);

/// Whether a joint lies between the torso and a sole.
bool carriesSole(const Robot& robot, std::size_t joint);

/// Whether a foot's stance frame is this sole: on both feet it is the left one.
bool standsOn(const Sole& sole, SupportFoot foot);

/// Where a term corrects on a picture: each joint that its motor drives, each board if it sits everywhere, or just its
/// place; nowhere if the picture has nothing to do with it.
std::vector<std::size_t> placesOn(const Term& term, const Measurements& measurements, const Picture& picture);

/// What is believed at a picture's instant given the unknowns. Every correction is evaluated at the instant; none sees
/// another's.
Belief believed(const Measurements& measurements, const Model& model, const Picture& picture,
                const Eigen::VectorXd& unknowns);

} // namespace naocal
