#pragma once

#include "effects/Effect.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"

#include <vector>

namespace naocal {

/// An invalid correction or unknown name. `letter`: 0-based position in its text.
class CorrectionError : public InputError {
public:
  CorrectionError(const std::string& sentence, std::size_t place) : InputError{sentence}, letter{place} {}
  std::size_t letter;
};

/// A user-defined effect on a joint, without compilation:
///
///   {"name": "kneeCable", "at": "LKneePitch", "correction": "a*sin(3*q) + b*abs(tau)",
///    "unknowns": {"a": {"unit": "rad", "sigma": 0.01}, "b": {"unit": "rad/Nm", "sigma": 0.005}}}
///
/// `at`: a joint, or "*" for any. The correction [rad] may use q, qd, tau, approach, T, t, current of that joint, any
/// joint by its name (its q), tau_<joint>, imu_x, imu_y, com_x, com_y, the unknowns, and muParser's functions. It must
/// be zero where the unknowns are zero. Throws InputError with location, expected and similar names; for the text of
/// the correction a CorrectionError.
Effect parseUserEffect(const JsonCursor& definition, const Robot& robot);

/// Parses a list of effects. Names must differ from each other and from those of the built-in effects.
std::vector<Effect> parseUserEffects(const JsonCursor& definitions, const Robot& robot);

} // namespace naocal
