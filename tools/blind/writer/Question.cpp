#include "writer/Question.hpp"

#include "writer/Design.hpp"
#include "writer/Poses.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>
#include <tuple>

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

std::vector<double> scaled(std::vector<double> values, double size) {
  for (double& value : values) {
    value *= size;
  }
  return values;
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

/// `haste`: grows from 0 to 1 with the number of attempts; relaxes the requirements.
bool hide(const DesignItem& item, double haste, Question& question, RandomStream& chance) {
  const Noncentrality noncentrality{question.robot, question.session, question.plan.noise};
  const FlawSizing hiding{question.robot, question.session, noncentrality};
  const auto sized = [&](const FlawFamily& family, double wanted) {
    auto hidden = hiding.scaleTo(family, somePlace(family, question.plan, chance), randomShape(family, chance), wanted,
                                 (1 + haste) * mostPhysicalSizes);
    return hidden && hidden->kept > untestable ? hidden : std::nullopt;
  };
  if (item.group == "absorbed") {
    const auto [family, place] = absorbedEffect(item.kind, question.plan);
    question.hidden.push_back(hiding.makeFlaw(*family, place, physicalSize(*family, chance)));
    return question.hidden.front().kept < untestable;
  }
  if (item.group == "pair") {
    const auto& families = catalogue();
    const auto first = sized(families[chance.below(static_cast<int>(families.size()))], item.noncentrality);
    const auto second = sized(families[chance.below(static_cast<int>(families.size()))], item.noncentrality);
    if (!first || !second || first->family == second->family || hiding.correlation(*first, *second) >= 0.5) {
      return false;
    }
    question.hidden = {*first, *second};
    return true;
  }
  if (item.group == "twin") {
    constexpr double alike = 0.95, hardly = 0.8, plain = 40;
    const FlawFamily& family = someFamily(chance);
    const HiddenFlaw hidden = hiding.makeFlaw(
        family, somePlace(family, question.plan, chance),
        scaled(plausibleShape(family, chance), chance.between(plausibleSizes.front(), plausibleSizes.back())));
    if (hidden.noncentrality < (1 - haste) * plain || hidden.kept < untestable) {
      return false;
    }
    question.twins = twinsOf(hidden, hiding, question.plan, alike - haste * (alike - hardly));
    question.hidden.push_back(hidden);
    return !question.twins.empty();
  }
  const FlawFamily& family = familyNamed(item.kind == "offset step" ? offsetStep().effect : item.kind);
  if (item.noncentrality == 0) {
    auto values = item.group == "outside" ? randomShape(family, chance)
                  : item.group == "event" ? scaled(randomShape(family, chance), chance.between(0.5, 2))
                  : item.plausible > 0    ? scaled(plausibleShape(family, chance), item.plausible)
                                          : physicalSize(family, chance);
    question.hidden.push_back(hiding.makeFlaw(family, somePlace(family, question.plan, chance), std::move(values)));
    const HiddenFlaw& hidden = question.hidden.front();
    return hidden.noncentrality > (1 - haste) * visible && hidden.kept > untestable;
  }
  if (const auto hidden = sized(family, item.noncentrality)) {
    question.hidden.push_back(*hidden);
    return true;
  }
  return false;
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
    if (harmless || hide(item, static_cast<double>(attempt) / (tries - 1), question, chance)) {
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
  Happening result;
  std::pair<double, double> times;
  const auto stanceOf = [&](int reading) { return session.readings[static_cast<std::size_t>(reading)].stance; };
  // tied sight: another sight shares its board or stance (not both), or both but across the moment
  const auto tied = [&](const BoardSight& sight, double moment, const auto& sameOther) {
    const auto isAfter = [&](const BoardSight& one) {
      return session.readings[static_cast<std::size_t>(one.reading)].time > moment;
    };
    return std::any_of(session.sights.begin(), session.sights.end(), [&](const BoardSight& other) {
      const bool same = other.board == sight.board && stanceOf(other.reading) == stanceOf(sight.reading);
      return (sameOther(other, sight) && !same) || (same && isAfter(other) != isAfter(sight));
    });
  };
  const auto seen = [&](int reading, const auto& which) {
    return std::any_of(session.sights.begin(), session.sights.end(),
                       [&](const BoardSight& sight) { return sight.reading == reading && which(sight); });
  };
  if (const auto& kick = session.kickedBoard) {
    const auto sameStance = [&](const BoardSight& a, const BoardSight& b) {
      return stanceOf(a.reading) == stanceOf(b.reading);
    };
    times = around(session, kick->time, [&](int reading) {
      return seen(reading, [&](const BoardSight& sight) {
        return sight.board == kick->which && tied(sight, kick->time, sameStance);
      });
    });
    result = {"kicked board", std::string(1, static_cast<char>('A' + kick->which)), 0, 0, {}};
  } else if (const auto& slip = session.slippedStance) {
    const auto sameBoard = [](const BoardSight& a, const BoardSight& b) { return a.board == b.board; };
    times = around(session, slip->time, [&](int reading) {
      return stanceOf(reading) == slip->which &&
             seen(reading, [&](const BoardSight& sight) { return tied(sight, slip->time, sameBoard); });
    });
    result = {"slipped robot", std::to_string(slip->which), 0, 0, {}};
  } else if (!question.hidden.empty() && question.hidden.front().family == &offsetStep()) {
    const HiddenFlaw& step = question.hidden.front();
    const int joint = question.robot.drawing->joint(step.place);
    const bool ofLegs = !step.place.starts_with("Head") && step.place != "LHipYawPitch"; // which turns both legs
    times = around(session, question.robot.flaws.joints[static_cast<std::size_t>(joint)].slipTime, [&](int reading) {
      const int side = session.stances[static_cast<std::size_t>(stanceOf(reading))].side;
      return (!ofLegs || (step.place.front() == 'L') == (side == 0)) &&
             seen(reading, [](const BoardSight&) { return true; });
    });
    result = {"offset step", step.place, 0, 0, {{"step", step.values.front()}}};
  } else {
    return std::nullopt;
  }
  for (const auto& moved : {session.kickedBoard, session.slippedStance}) {
    if (moved) {
      result.by = {{"x", moved->by.x}, {"y", moved->by.y}, {"yaw", moved->by.yaw}};
    }
  }
  std::tie(result.before, result.after) = times;
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
