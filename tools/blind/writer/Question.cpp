#include "writer/Question.hpp"

#include "writer/Design.hpp"
#include "writer/Poses.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>
#include <utility>

namespace blind {

namespace {

constexpr double mostPhysicalSizes = 6; // in units of the physical size; larger flaws are redrawn
constexpr double visible = 10;          // noncentrality; smaller flaws count as absorbed
constexpr double untestable = 1e-4;     // fraction of the evidence; below it unknowns mimic the flaw to first order

const FlawFamily& familyNamed(const std::string& effect) {
  for (const std::vector<FlawFamily>* families : {&catalogue(), &offCatalogue()}) {
    for (const FlawFamily& family : *families) {
      if (family.effect == effect) {
        return family;
      }
    }
  }
  if (effect == offsetStep().effect) {
    return offsetStep();
  }
  throw std::runtime_error{fmt::format("no effect is named {}", effect)};
}

std::string somePlace(const FlawFamily& family, const SessionPlan& plan, RandomStream& chance) {
  const std::vector<std::string> places = placesFor(family, plan.mainSide, static_cast<std::size_t>(plan.boards));
  return places[chance.below(static_cast<int>(places.size()))];
}

/// The effect that a session planned this way cannot test, and its place.
std::pair<const FlawFamily*, std::string> absorbedEffect(const std::string& kind, const SessionPlan& plan) {
  const std::string letter = plan.mainSide == 0 ? "L" : "R";
  if (kind == "one-sided gap") {
    return {&familyNamed("backlash"), letter + "HipRoll"};
  }
  if (kind == "one-sided approach") {
    return {&familyNamed("hysteresis"), letter + "KneePitch"};
  }
  if (kind == "constant temperature") {
    return {&familyNamed("thermalDrift"), letter + "KneePitch"};
  }
  if (kind == "constant angle") {
    return {&familyNamed("encoderGain"), "LHipYawPitch"};
  }
  return {&familyNamed("timeOffset"), "all"}; // "no motion"
}

std::vector<double> physicalSize(const FlawFamily& family, RandomStream& chance) {
  std::vector<double> values = randomShape(family, chance);
  return scaled(std::move(values), chance.between(0.7, 1.5));
}

/// Times of the last reading before a moment and of the first one after it, since the first reading.
template <typename Shows> std::pair<double, double> around(const Session& session, double moment, Shows shows) {
  const double first = session.readings.front().time;
  std::pair<double, double> times{0, session.readings.back().time - first};
  for (std::size_t i = 0; i < session.readings.size(); ++i) {
    const double time = session.readings[i].time;
    if (!shows(static_cast<int>(i))) {
      continue;
    }
    if (time < moment) {
      times.first = time - first;
    } else {
      times.second = std::min(times.second, time - first);
    }
  }
  return times;
}

/// Effects at the same place with nearly the same change of the images given the calibration's unknowns, by canonical
/// correlation.
std::vector<std::string> twinsOf(const HiddenFlaw& hidden, const FlawSizing& hiding, const SessionPlan& plan,
                                 double alike) {
  std::vector<std::string> twins;
  for (const FlawFamily& family : catalogue()) {
    const std::vector<std::string> places = placesFor(family, plan.mainSide, static_cast<std::size_t>(plan.boards));
    const bool there = std::find(places.begin(), places.end(), hidden.place) != places.end();
    if (&family != hidden.family && there && hiding.correlation(hidden, {&family, hidden.place, {}, 0, 0}) > alike) {
      twins.push_back(family.effect + "@" + hidden.place);
    }
  }
  return twins;
}

const FlawFamily& someFamily(RandomStream& chance) {
  return catalogue()[static_cast<std::size_t>(chance.below(static_cast<int>(catalogue().size())))];
}

/// Hides the flaws of a design's item in a drawn robot and session.
class FlawHider {
public:
  /// `haste`: grows from 0 to 1 with the number of attempts; relaxes the requirements.
  FlawHider(const DesignItem& item, double haste, Question& question, RandomStream& chance)
      : item_{item}, haste_{haste}, question_{question}, chance_{chance},
        noncentrality_{question.robot, question.session, question.plan.noise}, hiding_{question.robot, question.session,
                                                                                       noncentrality_} {}
  FlawHider(const FlawHider&) = delete;

  /// False if the requirements are not met.
  bool hide();

private:
  /// A flaw of noncentrality `wanted` at some place; absent if it would be implausibly large or untestable.
  std::optional<HiddenFlaw> drawSized(const FlawFamily& family, double wanted) {
    auto hidden = hiding_.scaleTo(family, somePlace(family, question_.plan, chance_), randomShape(family, chance_),
                                  wanted, (1 + haste_) * mostPhysicalSizes);
    return hidden && hidden->kept > untestable ? hidden : std::nullopt;
  }
  bool hideAbsorbed();
  bool hidePair();
  bool hideWithTwin();
  bool hideUnsized(const FlawFamily& family);

  const DesignItem& item_;
  double haste_;
  Question& question_;
  RandomStream& chance_;
  Noncentrality noncentrality_;
  FlawSizing hiding_; // uses `noncentrality_`
};

bool FlawHider::hideAbsorbed() {
  const auto [family, place] = absorbedEffect(item_.kind, question_.plan);
  question_.hidden.push_back(hiding_.makeFlaw(*family, place, physicalSize(*family, chance_)));
  return question_.hidden.front().kept < untestable;
}

bool FlawHider::hidePair() {
  const auto first = drawSized(someFamily(chance_), item_.noncentrality);
  const auto second = drawSized(someFamily(chance_), item_.noncentrality);
  if (!first || !second || first->family == second->family || hiding_.correlation(*first, *second) >= 0.5) {
    return false;
  }
  question_.hidden = {*first, *second};
  return true;
}

/// Hides a flaw that has a twin.
bool FlawHider::hideWithTwin() {
  constexpr double alike = 0.95, hardly = 0.8, plain = 40;
  const FlawFamily& family = someFamily(chance_);
  const HiddenFlaw hidden = hiding_.makeFlaw(
      family, somePlace(family, question_.plan, chance_),
      scaled(plausibleShape(family, chance_), chance_.between(plausibleSizes.front(), plausibleSizes.back())));
  if (hidden.noncentrality < (1 - haste_) * plain || hidden.kept < untestable) {
    return false;
  }
  question_.twins = twinsOf(hidden, hiding_, question_.plan, alike - haste_ * (alike - hardly));
  question_.hidden.push_back(hidden);
  return !question_.twins.empty();
}

/// Hides a flaw whose size does not depend on its visibility.
bool FlawHider::hideUnsized(const FlawFamily& family) {
  auto values = item_.group == "outside" ? randomShape(family, chance_)
                : item_.group == "event" ? scaled(randomShape(family, chance_), chance_.between(0.5, 2))
                : item_.plausible > 0    ? scaled(plausibleShape(family, chance_), item_.plausible)
                                         : physicalSize(family, chance_);
  question_.hidden.push_back(hiding_.makeFlaw(family, somePlace(family, question_.plan, chance_), std::move(values)));
  const HiddenFlaw& hidden = question_.hidden.front();
  return hidden.noncentrality > (1 - haste_) * visible && hidden.kept > untestable;
}

bool FlawHider::hide() {
  if (item_.group == "absorbed") {
    return hideAbsorbed();
  }
  if (item_.group == "pair") {
    return hidePair();
  }
  if (item_.group == "twin") {
    return hideWithTwin();
  }
  const FlawFamily& family = familyNamed(item_.kind == "offset step" ? offsetStep().effect : item_.kind);
  if (item_.noncentrality == 0) {
    return hideUnsized(family);
  }
  const auto hidden = drawSized(family, item_.noncentrality);
  if (hidden) {
    question_.hidden.push_back(*hidden);
  }
  return hidden.has_value();
}

int stanceOf(const Session& session, int reading) {
  return session.readings[static_cast<std::size_t>(reading)].stance;
}

/// Whether a sight is tied across a moment: another one shares its board or stance (`sameOther`) but not both, or both
/// and lies on the other side of the moment.
template <typename SameOther>
bool isTied(const Session& session, const BoardSight& sight, double moment, const SameOther& sameOther) {
  const auto isAfter = [&](const BoardSight& one) {
    return session.readings[static_cast<std::size_t>(one.reading)].time > moment;
  };
  return std::any_of(session.sights.begin(), session.sights.end(), [&](const BoardSight& other) {
    const bool same =
        other.board == sight.board && stanceOf(session, other.reading) == stanceOf(session, sight.reading);
    return (sameOther(other, sight) && !same) || (same && isAfter(other) != isAfter(sight));
  });
}

/// Whether any sight of a reading satisfies `which`.
template <typename Which> bool anySight(const Session& session, int reading, const Which& which) {
  return std::any_of(session.sights.begin(), session.sights.end(),
                     [&](const BoardSight& sight) { return sight.reading == reading && which(sight); });
}

Happening describeKick(const Session& session, const Displacement& kick) {
  const auto sameStance = [&](const BoardSight& a, const BoardSight& b) {
    return stanceOf(session, a.reading) == stanceOf(session, b.reading);
  };
  const auto [before, after] = around(session, kick.time, [&](int reading) {
    return anySight(session, reading, [&](const BoardSight& sight) {
      return sight.board == kick.which && isTied(session, sight, kick.time, sameStance);
    });
  });
  return {"kicked board", std::string(1, static_cast<char>('A' + kick.which)), before, after, {}};
}

Happening describeSlip(const Session& session, const Displacement& slip) {
  const auto sameBoard = [](const BoardSight& a, const BoardSight& b) { return a.board == b.board; };
  const auto [before, after] = around(session, slip.time, [&](int reading) {
    return stanceOf(session, reading) == slip.which && anySight(session, reading, [&](const BoardSight& sight) {
             return isTied(session, sight, slip.time, sameBoard);
           });
  });
  return {"slipped robot", std::to_string(slip.which), before, after, {}};
}

/// `step`: a flaw of the family `offsetStep`.
Happening describeOffsetStep(const Question& question, const HiddenFlaw& step) {
  const Session& session = question.session;
  const int joint = question.robot.drawing->joint(step.place);
  const bool ofLegs = !step.place.starts_with("Head") && step.place != "LHipYawPitch"; // which turns both legs
  const double time = question.robot.flaws.joints[static_cast<std::size_t>(joint)].slipTime;
  const auto [before, after] = around(session, time, [&](int reading) {
    const int side = session.stances[static_cast<std::size_t>(stanceOf(session, reading))].side;
    return (!ofLegs || (step.place.front() == 'L') == (side == 0)) &&
           anySight(session, reading, [](const BoardSight&) { return true; });
  });
  return {"offset step", step.place, before, after, {{"step", step.values.front()}}};
}

} // namespace

Question drawQuestion(const Drawing& drawing, const DesignItem& item, RandomStream& chance) {
  constexpr int tries = 120;
  for (int attempt = 0; attempt < tries; ++attempt) {
    Question question;
    question.plan = drawPlan(item, chance);
    const std::string letter = question.plan.mainSide == 0 ? "L" : "R";
    if (item.kind == "one-sided approach") {
      question.plan.sameApproach = drawing.joint(letter + "KneePitch");
    }
    if (item.kind == "constant angle") {
      question.plan.hipYawPitch = -0.25;
    }
    question.robot = drawRobot(drawing, static_cast<std::size_t>(question.plan.boards), chance);
    question.session = stageSession(question.robot, question.plan, placeBoards(question.plan.boards, chance), chance);
    for (JointFlaws& joint : question.robot.flaws.joints) {
      const auto& readings = question.session.readings;
      joint.slipTime = readings[readings.size() * (30 + chance.below(40)) / 100].time; // only if it slips
      joint.stickiness = chance.between(0.05, 0.5);                                    // only if its gear has play
    }
    const bool harmless = item.group == "control" || item.group == "decoy" || item.group == "corrupted" ||
                          item.group == "jitter" || (item.group == "event" && item.kind != "offset step");
    if (harmless || FlawHider{item, static_cast<double>(attempt) / (tries - 1), question, chance}.hide()) {
      for (const HiddenFlaw& hidden : question.hidden) {
        applyFlaw(hidden, question.robot);
      }
      return question;
    }
  }
  throw std::runtime_error{fmt::format("no robot and session were found in which {} of size {} can be hidden",
                                       item.kind, item.noncentrality)};
}

std::optional<Happening> happening(const Question& question) {
  const Session& session = question.session;
  std::optional<Happening> result;
  if (session.kickedBoard) {
    result = describeKick(session, *session.kickedBoard);
  } else if (session.slippedStance) {
    result = describeSlip(session, *session.slippedStance);
  } else if (!question.hidden.empty() && question.hidden.front().family == &offsetStep()) {
    result = describeOffsetStep(question, question.hidden.front());
  }
  for (const auto& moved : {session.kickedBoard, session.slippedStance}) {
    if (moved) {
      result->by = {{"x", moved->by.x}, {"y", moved->by.y}, {"yaw", moved->by.yaw}};
    }
  }
  return result;
}

Session lockedSession(const Question& question, RandomStream& chance) {
  SessionPlan plan = question.plan;
  plan.poses = 60; // enough that the model, not these poses' noise, determines the error
  plan.samples = 1;
  plan.rests = plan.restands = plan.sortedByKnee = false;
  plan.sameApproach = std::nullopt;
  plan.hipYawPitch = std::nullopt;
  const Robot sound = withoutFlaws(question.robot); // poses and visibility are computed without the flaw
  return stageSession(sound, plan, question.session.boards, chance);
}

std::vector<std::string> driversAt(const HiddenFlaw& hidden) {
  std::vector<std::string> drivers = hidden.family->drivers;
  const std::string side = hidden.place.starts_with("Head") ? "" : hidden.place.substr(0, 1);
  for (std::string& driver : drivers) {
    driver = driver.ends_with("Pitch") ? side + driver : driver;
  }
  return drivers;
}

} // namespace blind
