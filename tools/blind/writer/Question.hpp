#pragma once

#include "writer/Corruption.hpp"
#include "writer/Design.hpp"
#include "writer/FlawSizing.hpp"
#include "writer/SessionPlanner.hpp"

namespace blind {

/// A robot with hidden flaws and a session in which to find them.
struct Question {
  SessionPlan plan;
  Robot robot;
  Session session;
  std::vector<HiddenFlaw> hidden;
  std::vector<std::string> twins; // EFFECT@PLACE of effects with nearly the same images; group twin only
};

/// An event, and the readings before and after it.
struct Happening {
  std::string what, at;             // "kicked board", "slipped robot" or "offset step"; board, stance or joint
  double before = 0, after = 0;     // last reading before it, first one after it, since the first reading [s]
  std::map<std::string, double> by; // displacement: x, y [m], yaw [rad], or step [rad]
};
/// Absent if there is no event.
std::optional<Happening> happening(const Question& question);

/// Draws robots, places and sessions until the item's flaw has the required size without being implausibly large.
/// Throws std::runtime_error if that fails.
Question drawQuestion(const Drawing& drawing, const DesignItem& item, RandomStream& chance);

/// Sixty further poses of the same robot with the same flaws: enough to measure the model error rather than noise.
Session lockedSession(const Question& question, RandomStream& chance);

/// Drivers of an off-catalogue flaw's misfit, with the letter of the side.
std::vector<std::string> driversAt(const HiddenFlaw& hidden);

} // namespace blind
