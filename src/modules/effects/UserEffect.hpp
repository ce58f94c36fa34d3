#pragma once

#include "effects/Effect.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"

#include <vector>

namespace naocal {

/// A correction that is no expression, or names what is not known; `letter`: where in its text, counted from 0.
class CorrectionError : public InputError {
public:
  CorrectionError(const std::string& sentence, std::size_t place) : InputError{sentence}, letter{place} {}
  std::size_t letter;
};

/// A person's own effect on a joint, without compiling:
///
///   {"name": "kneeCable", "at": "LKneePitch", "correction": "a*sin(3*q) + b*abs(tau)",
///    "unknowns": {"a": {"unit": "rad", "sigma": 0.01}, "b": {"unit": "rad/Nm", "sigma": 0.005}}}
///
/// `at`: a joint, or "*" for any. The correction [rad] may use q, qd, tau, approach, T, t, current of that joint, any
/// joint by its name (its q), tau_<joint>, imu_x, imu_y, com_x, com_y, the unknowns, and muParser's functions; it must
/// vanish where the unknowns do. Throws InputError that says where, what was expected and what is near; for the
/// correction's text a CorrectionError.
Effect parseUserEffect(const JsonCursor& definition, const Robot& robot);

/// A list of them. Names must differ from each other and from the built-in effects'.
std::vector<Effect> parseUserEffects(const JsonCursor& definitions, const Robot& robot);

} // namespace naocal
