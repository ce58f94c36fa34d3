#pragma once

#include "effects/Effect.hpp"
#include "residuals/Measurements.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

namespace naocal {

/// An effect at a place, with its share of the vector of unknowns.
struct Term {
  Effect effect;
  std::size_t at = 0;       // the motor's joint, the camera, the target or the standing
  std::string place;        // its name
  std::size_t first = 0;    // its first unknown
  bool isPlacement = false; // where a board or a stance lies: not physics, but unknown as well

  std::string label() const { return effect.name + "@" + place; }
};

/// What is to be estimated: effects at places, then the unknown placements.
class Model {
public:
  void add(Effect effect, std::size_t at, std::string place, bool isPlacement = false);

  const std::vector<Term>& terms() const { return terms_; }
  std::size_t unknownCount() const { return unknownCount_; }
  bool linear() const { return linear_; }

  /// sigma of each unknown: its prior about zero.
  Eigen::VectorXd sigmas() const;
  /// "jointOffset@LKneePitch.o" of each unknown.
  std::vector<std::string> names() const;
  /// "rad", "m", ... of each unknown.
  std::vector<std::string> units() const;

private:
  std::vector<Term> terms_;
  std::size_t unknownCount_ = 0;
  bool linear_ = true;
};

/// The base model: `jointOffset` of every joint in use, `cameraRotation` of every camera in use, unknown placements;
/// `with` adds and `without` removes effects at places, "E@P" with '*' for any run of letters. Throws InputError for
/// names that match nothing, and lists the near ones.
Model makeModel(const Measurements& measurements, const std::vector<std::string>& with = {},
                const std::vector<std::string>& without = {});

/// What is believed at a picture's instant given the unknowns.
Belief believed(const Measurements& measurements, const Model& model, const Picture& picture,
                const Eigen::VectorXd& unknowns);

/// d(quantity)/d(unknown) where it is not zero.
struct Slope {
  std::size_t quantity, unknown;
  double value;
};

/// By central differences of `believed` over 1e-3 of each unknown's sigma; of a linear model by the same step from
/// zero.
std::vector<Slope> slopes(const Measurements& measurements, const Model& model, const Picture& picture,
                          const Eigen::VectorXd& unknowns);

} // namespace naocal
