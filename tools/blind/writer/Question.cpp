#include "writer/Question.hpp"

#include "writer/Drawn.hpp"
#include "writer/Layout.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

namespace blind {

namespace {

constexpr double mostPhysicalSizes = 6; // a flaw larger than so many of its physical sizes is drawn anew
constexpr double visible = 10;          // where poses show a flaw less, the question belongs to the absorbed ones

const Family& familyNamed(const std::string& effect) {
  for (const std::vector<Family>* families : {&catalogue(), &outside()}) {
    for (const Family& family : *families) {
      if (family.effect == effect) {
        return family;
      }
    }
  }
  throw std::runtime_error{fmt::format("no effect is named {}", effect)};
}

std::string somePlace(const Family& family, const SessionPlan& plan, Chance& chance) {
  const std::vector<std::string> places = placesFor(family, plan.mainSide, static_cast<std::size_t>(plan.boards));
  return places[chance.below(static_cast<int>(places.size()))];
}

/// Which effect nobody can see in a session that was planned so.
std::pair<const Family*, std::string> absorbedEffect(const std::string& kind, const SessionPlan& plan) {
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

std::vector<double> physicalSize(const Family& family, Chance& chance) {
  std::vector<double> values = randomShape(family, chance);
  const double size = chance.between(0.7, 1.5);
  for (double& value : values) {
    value *= size;
  }
  return values;
}

/// `haste`: from 0 to 1 the longer nothing was found; demands are lowered accordingly.
bool hide(const Item& item, double haste, Question& question, Chance& chance) {
  const Noncentrality noncentrality{question.robot, question.session, question.plan.noise};
  const Hiding hiding{question.robot, question.session, noncentrality};
  const auto sized = [&](const Family& family, double wanted) {
    return hiding.sized(family, somePlace(family, question.plan, chance), randomShape(family, chance), wanted,
                        (1 + haste) * mostPhysicalSizes);
  };
  if (item.group == "absorbed") {
    constexpr double untestable = 1e-4; // of the evidence
    const auto [family, place] = absorbedEffect(item.kind, question.plan);
    question.hidden.push_back(hiding.given(*family, place, physicalSize(*family, chance)));
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
  const Family& family = familyNamed(item.kind);
  if (item.noncentrality == 0) {
    auto values = item.group == "outside" ? randomShape(family, chance) : physicalSize(family, chance);
    question.hidden.push_back(hiding.given(family, somePlace(family, question.plan, chance), std::move(values)));
    return question.hidden.front().noncentrality > (1 - haste) * visible;
  }
  if (const auto hidden = sized(family, item.noncentrality)) {
    question.hidden.push_back(*hidden);
    return true;
  }
  return false;
}

} // namespace

Question ask(const Drawing& drawing, const Item& item, Chance& chance) {
  constexpr int tries = 120;
  for (int attempt = 0; attempt < tries; ++attempt) {
    Question question;
    question.plan = drawnPlan(item, chance);
    const std::string letter = question.plan.mainSide == 0 ? "L" : "R";
    if (item.kind == "one-sided approach") {
      question.plan.sameApproach = drawing.joint(letter + "KneePitch");
    }
    if (item.kind == "constant angle") {
      question.plan.hipYawPitch = -0.25;
    }
    question.robot = drawnRobot(drawing, static_cast<std::size_t>(question.plan.boards), chance);
    question.session = staged(question.robot, question.plan, layOut(question.plan.boards, chance), chance);
    for (JointFlaws& joint : question.robot.flaws.joints) {
      const auto& readings = question.session.readings;
      joint.slipTime = readings[readings.size() * (30 + chance.below(40)) / 100].time; // when it slips at all
    }
    const bool harmless = item.group == "control" || item.group == "decoy" || item.group == "corrupted";
    if (harmless || hide(item, static_cast<double>(attempt) / (tries - 1), question, chance)) {
      for (const Hidden& hidden : question.hidden) {
        apply(hidden, question.robot);
      }
      return question;
    }
  }
  throw std::runtime_error{fmt::format("no robot and session were found in which {} of size {} can be hidden",
                                       item.kind, item.noncentrality)};
}

Session lockedSession(const Question& question, Chance& chance) {
  SessionPlan plan = question.plan;
  plan.poses = 60; // so many that whether the error falls is told by the model, hardly by these poses' own noise
  plan.samples = 1;
  plan.rests = plan.restands = plan.sortedByKnee = false;
  plan.sameApproach = std::nullopt;
  plan.hipYawPitch = std::nullopt;
  const Robot sound = withoutFlaws(question.robot); // poses are drawn and boards seen without the flaw
  return staged(sound, plan, question.session.boards, chance);
}

std::vector<std::string> driversAt(const Hidden& hidden) {
  std::vector<std::string> drivers = hidden.family->drivers;
  const std::string side = hidden.place.starts_with("Head") ? "" : hidden.place.substr(0, 1);
  for (std::string& driver : drivers) {
    driver = driver.ends_with("Pitch") ? side + driver : driver;
  }
  return drivers;
}

} // namespace blind
