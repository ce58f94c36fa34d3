#include "calibration/result/Wording.hpp"
#include "effects/Catalogue.hpp"
#include "inference/Thresholds.hpp"
#include "io/Units.hpp"
#include "math/Angles.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <span>

namespace naocal {

namespace {

bool isCapital(char letter) {
  return std::isupper(static_cast<unsigned char>(letter)) != 0;
}

/// "focal length" for focalLength.
std::string splitCamelCase(const std::string& camelCase) {
  std::string words;
  for (const char letter : camelCase) {
    if (isCapital(letter) && !words.empty()) {
      words += ' ';
    }
    words += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return words;
}

/// "the left knee pitch" for LKneePitch, "the head yaw" for HeadYaw.
std::string joint(const std::string& name) {
  const bool sided = name.size() > 1 && isCapital(name[1]);
  if (sided && (name[0] == 'L' || name[0] == 'R')) {
    return fmt::format("the {} {}", name[0] == 'L' ? "left" : "right", splitCamelCase(name.substr(1)));
  }
  return "the " + splitCamelCase(name);
}

/// Direction in words of an unknown's name, in camera or floor axes: "roll" for "rx", "forward" for "x".
std::string direction(const std::string& unknown) {
  static const std::map<std::string, std::string> words{{"rx", "roll"},   {"ry", "pitch"},   {"rz", "yaw"},
                                                        {"x", "forward"}, {"y", "sideways"}, {"z", "up"}};
  const auto word = words.find(unknown);
  return word == words.end() ? unknown : word->second;
}

/// What an explanation adds to the model and takes from it: "elasticity@LKneePitch is missing and backlash@LKneePitch
/// is not there".
std::string formatExplanation(const std::vector<std::string>& effects, const std::vector<std::string>& without) {
  const std::vector<std::string> missing = describeMissing(effects);
  std::vector<std::string> parts;
  if (!missing.empty()) {
    parts.push_back(joinWords(missing) + (missing.size() == 1 ? " is missing" : " are missing"));
  }
  if (!without.empty()) {
    parts.push_back(joinWords(without) + (without.size() == 1 ? " is not there" : " are not there"));
  }
  return parts.empty() ? "nothing is missing" : joinWords(parts);
}

} // namespace

std::vector<std::string> describeMissing(const std::vector<std::string>& labels) {
  std::vector<std::string> result;
  for (const std::string& label : labels) {
    result.push_back(label.find('@') != label.npos        ? label
                     : label.find(" over ") != label.npos ? "a curve of " + label
                                                          : "a motion of " + label);
  }
  return result;
}

std::string describeUnknown(const Term& term, std::size_t unknown) {
  const std::string& name = term.effect.unknowns[unknown].name;
  if (term.effect.name == effectName::jointOffset) {
    return joint(term.placeName);
  }
  if (term.effect.name == effectName::cameraRotation) {
    return fmt::format("the {} camera's {}", term.placeName, direction(name));
  }
  if (term.effect.name == "cameraTranslation") {
    return fmt::format("the {} camera's place ({})", term.placeName, direction(name));
  }
  const std::string which = term.effect.unknowns.size() > 1 ? " (" + name + ")" : "";
  if (term.effect.placeKind == PlaceKind::camera) {
    return fmt::format("the {} camera's {}{}", term.placeName, splitCamelCase(term.effect.name), which);
  }
  if (term.effect.placeKind == PlaceKind::board) { // boardBow, boardScale, ...
    const bool says = term.effect.name.starts_with("board");
    return fmt::format("board {}'s {}{}", term.placeName, splitCamelCase(term.effect.name.substr(says ? 5 : 0)), which);
  }
  if (term.effect.placeKind == PlaceKind::sole) { // soleTilt, ...
    const bool says = term.effect.name.starts_with("sole");
    return fmt::format("the {} sole's {}{}", term.placeName, splitCamelCase(term.effect.name.substr(says ? 4 : 0)),
                       which);
  }
  if (term.effect.placeKind == PlaceKind::tracker) { // trackerScale, trackerDrift
    const bool says = term.effect.name.starts_with("tracker");
    return fmt::format("tracker {}'s {}{}", term.placeName, splitCamelCase(term.effect.name.substr(says ? 7 : 0)),
                       which);
  }
  if (term.effect.placeKind == PlaceKind::all) {
    return fmt::format("the {}{}", splitCamelCase(term.effect.name), which);
  }
  return fmt::format("{}'s {}{}", joint(term.placeName), splitCamelCase(term.effect.name), which);
}

std::string nameUnknown(const Term& term, std::size_t unknown) {
  return term.effect.name == effectName::jointOffset
             ? term.placeName
             : fmt::format("{} {}", term.label(), term.effect.unknowns[unknown].name);
}

std::string describeImitator(const Term& term) {
  switch (term.effect.placeKind) {
  case PlaceKind::board:
    return fmt::format("where board {} is", term.placeName);
  case PlaceKind::camera:
    return term.isPlacement ? fmt::format("where camera {} stands", term.placeName)
                            : fmt::format("how camera {} is mounted", term.placeName);
  case PlaceKind::tracker:
    return fmt::format("where tracker {} stands", term.placeName);
  case PlaceKind::marker:
    return fmt::format("where marker {} sits", term.placeName);
  case PlaceKind::frame:
    return fmt::format("how frame {} is mounted", term.placeName);
  case PlaceKind::place:
    return fmt::format("where the places ({} and others) are", term.placeName);
  case PlaceKind::motor:
  case PlaceKind::joint:
    return fmt::format("how the {} is mounted on the link before it ({})", term.placeName, term.label());
  default:
    return fmt::format("where the robot stands in stance {}", term.placeName);
  }
}

std::string formatShoulder(const std::string& name, const std::string& unit, const Averaged& averaged) {
  if (!averaged.shoulder) {
    return {};
  }
  const Shoulder& shoulder = *averaged.shoulder;
  const auto [shown, scale] = displayUnit(unit);
  const int decimals = decimalsFor(scale * averaged.sigma);
  const auto format = [&, &shownUnit = shown, &factor = scale](double value) {
    return appendUnit(fmt::format("{:.{}f}", factor * value, decimals), shownUnit);
  };
  const std::string cause = formatExplanation(shoulder.effects, shoulder.without);
  const std::string low = format(averaged.bound[0]), high = format(averaged.bound[1]);
  if (std::abs(shoulder.value - averaged.value) <
      0.1 * (averaged.bound[1] - averaged.bound[0])) { // no other value: wider
    return fmt::format("{} may lie from {} to {} (99.95 %) if {} ({:.2g} %)", name, low, high, cause,
                       100 * shoulder.weight);
  }
  return fmt::format("{} may be {} ({:.2g} %) if {}; 99.95 % bound {} to {}", name, format(shoulder.value),
                     100 * shoulder.weight, cause, low, high);
}

std::string formatJointNoise(const Noise& noise, bool hasUnknownSteps) {
  const std::string encoders = hasUnknownSteps ? "encoders' steps unknown, their noise part of the"
                                               : fmt::format("encoders {:.4f}°,", degrees(noise.encoder));
  return fmt::format("{} joint scatter {:.4f}° from pose to pose{}", encoders, degrees(noise.pose),
                     noise.stance > 0 ? fmt::format(" and {:.4f}° from stance to stance", degrees(noise.stance)) : "");
}

bool isTold(const Unknown& unknown, double variance) {
  return std::sqrt(variance) < threshold::undetermined * unknown.sigma;
}

std::string formatSizes(const Effect& effect, const Eigen::VectorXd& estimate, const Eigen::MatrixXd& covariance) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < effect.unknowns.size(); ++i) {
    const Unknown& unknown = effect.unknowns[i];
    const auto row = static_cast<Eigen::Index>(i);
    if (!isTold(unknown, covariance(row, row))) {
      parts.push_back(unknown.name + " undetermined");
      continue;
    }
    const auto [unit, scale] = displayUnit(unknown.unit);
    const std::string size = formatEstimate(scale * estimate[row], scale * std::sqrt(covariance(row, row)));
    parts.push_back(appendUnit(fmt::format("{} = {}", unknown.name, size), unit));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string formatRejected(const RejectedMeasurements& rejected) {
  std::vector<std::string> kinds;
  if (rejected.corners > 0) {
    kinds.push_back(fmt::format("{} of {} corners", rejected.corners, rejected.ofCorners));
  }
  if (rejected.readings > 0) {
    kinds.push_back(fmt::format("{} of {} readings", rejected.readings, rejected.ofReadings));
  }
  const bool single = rejected.corners + rejected.readings == 1;
  return fmt::format("{} {} not fit the rest", joinWords(kinds), single ? "does" : "do");
}

std::string formatNegligible(const NegligibleEffect& effect, const ErrorUnit& unit) {
  return fmt::format("{} is hardly chance{}, but it changes the predictions by only {:.2g} {}: too little to matter.",
                     effect.label, effect.sizes.empty() ? "" : " (" + effect.sizes + ")", unit.perPx * effect.movedPx,
                     unit.name);
}

std::string joinWords(const std::vector<std::string>& words) {
  if (words.size() < 2) {
    return words.empty() ? "" : words.front();
  }
  return fmt::format("{} and {}", fmt::join(std::span{words}.first(words.size() - 1), ", "), words.back());
}

} // namespace naocal
