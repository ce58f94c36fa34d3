#include "residuals/Candidates.hpp"

#include "residuals/Slopes.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace naocal {

namespace {

using NamedPlaces = std::vector<std::pair<std::size_t, std::string>>;

/// What the pictures with corners touch.
struct Touched {
  std::set<std::size_t> motors, joints, cameras, boards, soles, lengths;
};

void touchLengths(const Robot& robot, const View& view, std::set<std::size_t>& lengths) {
  for (std::size_t link : view.links()) {
    for (const Link::Stretch& stretch : robot.links[link].stretches) {
      lengths.insert(stretch.length);
    }
  }
}

Touched touched(const Measurements& measurements) {
  const Robot& robot = measurements.robot;
  Touched result;
  for (const Picture& picture : measurements.pictures) {
    if (picture.sightings.empty()) {
      continue;
    }
    result.cameras.insert(picture.camera);
    for (const std::size_t joint : jointsBetween(robot, picture)) {
      result.joints.insert(joint);
      result.motors.insert(robot.joints[joint].motor);
    }
    for (const Sighting& sighting : picture.sightings) {
      const Target& target = measurements.targets[sighting.view.board()];
      touchLengths(robot, sighting.view, result.lengths);
      if (target.board.pattern) {
        result.boards.insert(sighting.view.board());
      }
      for (std::size_t sole = 0; target.onFloor && sole < robot.soles.size(); ++sole) {
        if (standsOn(robot.soles[sole], picture.instant.supportFoot)) {
          result.soles.insert(sole);
        }
      }
    }
  }
  return result;
}

template <typename List> NamedPlaces named(const std::set<std::size_t>& numbers, const List& list) {
  NamedPlaces result;
  for (const std::size_t number : numbers) {
    result.emplace_back(number, list[number].name);
  }
  return result;
}

NamedPlaces placesOf(const Effect& effect, const Measurements& measurements, const Touched& touched) {
  const Robot& robot = measurements.robot;
  switch (effect.place) {
  case Place::motor: {
    NamedPlaces result = named(touched.motors, robot.joints);
    std::erase_if(result, [&](const auto& place) { return effect.only && place.first != *effect.only; });
    return result;
  }
  case Place::joint:
    return named(touched.joints, robot.joints);
  case Place::camera:
    return named(touched.cameras, robot.cameras);
  case Place::board: {
    NamedPlaces result = named(touched.boards, measurements.targets);
    if (effect.shared && result.size() > 1) {
      result.emplace_back(everywhere, "all");
    }
    return result;
  }
  case Place::sole:
    return named(touched.soles, robot.soles);
  case Place::length:
    return named(touched.lengths, robot.lengths);
  case Place::all:
    return {{0, "all"}};
  case Place::stance:
    break;
  }
  return {};
}

/// What an instant does not tell at a joint, in words; nothing where it does.
const char* missing(const Instant& instant, Driver driver, std::size_t joint, const Robot& robot) {
  const auto at = static_cast<Eigen::Index>(joint);
  switch (driver) {
  case Driver::approach:
    return std::isnan(instant.approach[at]) ? "approach directions" : nullptr;
  case Driver::temperature:
    return std::isnan(instant.temperature[at]) ? "temperatures" : nullptr;
  case Driver::velocity:
    return std::isnan(instant.velocity[at]) ? "velocities" : nullptr;
  case Driver::current:
    return std::isnan(instant.current[at]) ? "currents" : nullptr;
  case Driver::imu:
    return std::isnan(instant.imu.x()) ? "torso angles (imu)" : nullptr;
  case Driver::torque:
  case Driver::torqueGrowth:
    return instant.supportFoot == SupportFoot::both && std::isnan(instant.leftLoad) && carriesSole(robot, joint)
               ? "shares of the load on both feet (fsr)"
               : nullptr;
  case Driver::com:
    return instant.supportFoot == SupportFoot::none ? "support feet" : nullptr;
  case Driver::angle:
  case Driver::time:
    break;
  }
  return nullptr;
}

} // namespace

std::vector<std::pair<std::size_t, std::string>> placesOf(const Effect& effect, const Measurements& measurements) {
  return placesOf(effect, measurements, touched(measurements));
}

std::optional<std::string> whyUntestable(const Effect& effect, std::size_t at, const Measurements& measurements) {
  if (effect.needs.empty() && effect.elsewhere.empty()) {
    return std::nullopt;
  }
  const Term term{effect, at, ""};
  std::size_t concerned = 0, without = 0;
  const char* what = nullptr;
  for (const Picture& picture : measurements.pictures) {
    const std::vector<std::size_t> places = placesOn(term, measurements, picture);
    const bool shares = effect.place == Place::sole && picture.instant.supportFoot == SupportFoot::both;
    if (picture.sightings.empty() || places.empty() || shares) {
      continue;
    }
    const bool ofJoint = effect.place == Place::motor || effect.place == Place::joint;
    std::vector<std::size_t> looked = jointsBetween(measurements.robot, picture);
    std::erase_if(looked, [&](std::size_t joint) {
      return ofJoint && std::find(places.begin(), places.end(), joint) == places.end();
    });
    if (looked.empty()) {
      continue;
    }
    const char* lacks = nullptr;
    const auto look = [&](Driver driver, std::size_t joint) {
      lacks = lacks ? lacks : missing(picture.instant, driver, joint, measurements.robot);
    };
    for (const std::size_t joint : looked) {
      for (const Driver driver : effect.needs) {
        look(driver, joint);
      }
    }
    for (const Elsewhere& other : effect.elsewhere) {
      look(other.driver, other.joint);
      const bool recorded = std::binary_search(measurements.recorded.begin(), measurements.recorded.end(),
                                               measurements.robot.joints[other.joint].motor);
      lacks = other.driver == Driver::angle && !recorded ? "angles of a joint that it looks at" : lacks;
    }
    ++concerned;
    without += lacks != nullptr;
    what = lacks ? lacks : what;
  }
  if (concerned == 0) {
    return effect.place == Place::sole ? "no picture was taken on one foot" : "no picture shows it";
  }
  const bool whereRecorded = effect.name == "imuTilt"; // each reading is one measurement more
  if (without == 0 || (whereRecorded && without < concerned)) {
    return std::nullopt;
  }
  return without == concerned ? fmt::format("no {} were recorded", what)
                              : fmt::format("{} of {} pictures have no {}", without, concerned, what);
}

std::vector<Term> candidateTerms(const Measurements& measurements, const std::vector<Effect>& effects) {
  const Touched all = touched(measurements);
  std::vector<Term> result;
  for (const Effect& effect : effects) {
    for (const auto& [at, place] : placesOf(effect, measurements, all)) {
      result.push_back({effect, at, place});
    }
  }
  return result;
}

std::vector<Term> testableTerms(const Measurements& measurements, const Model& model,
                                const std::vector<Effect>& effects) {
  std::vector<Term> result = candidateTerms(measurements, effects);
  std::erase_if(result, [&](const Term& term) {
    return whyUntestable(term.effect, term.at, measurements) ||
           std::any_of(model.terms().begin(), model.terms().end(),
                       [&](const Term& own) { return own.label() == term.label(); });
  });
  return result;
}

} // namespace naocal
