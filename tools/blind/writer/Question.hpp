#pragma once

#include "writer/Corruption.hpp"
#include "writer/Design.hpp"
#include "writer/FlawSizing.hpp"
#include "writer/SessionPlanner.hpp"

namespace blind {

/// A robot with its hidden flaws, and the session in which they are to be found.
struct Question {
  SessionPlan plan;
  Robot robot;
  Session session;
  std::vector<HiddenFlaw> hidden;
  std::vector<std::string>
      twins; // EFFECT@PLACE of what does nearly the same to these pictures, where that was asked for
};

/// Something that happens once, and between which two of the readings that show it.
struct Happening {
  std::string what, at;             // "kicked board", "slipped robot" or "offset step"; board, stance or joint
  double before = 0, after = 0;     // last reading before it, first one after it, since the first reading [s]
  std::map<std::string, double> by; // how far: x, y [m], yaw [rad], or step [rad]
};
/// Absent: nothing happens.
std::optional<Happening> happening(const Question& question);

/// Draws robots, places of the flaw and sessions until the flaw of the item has its size there without being absurdly
/// large. Throws when that never happens.
Question drawQuestion(const Drawing& drawing, const DesignItem& item, RandomStream& chance);

/// Sixteen further poses of the same robot with the same flaws: enough that what is measured there is the robot's
/// error and not luck.
Session lockedSession(const Question& question, RandomStream& chance);

/// What the misfit of a flaw outside the catalogue varies with, with the side's letter.
std::vector<std::string> driversAt(const HiddenFlaw& hidden);

} // namespace blind
