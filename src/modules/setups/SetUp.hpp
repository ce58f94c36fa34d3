#pragma once

#include "measurements/Measurements.hpp"

#include <functional>
#include <string>
#include <vector>

namespace naocal {

/// What a wrong set-up falsifies: the captures, and the robot's description where it comes with them.
struct Recording {
  std::vector<CaptureSet> sets;
  Robot robot;
};

/// One way to undo a mistake.
struct Mending {
  std::string what; // what was wrong, as a clause: "elbow's angles have the wrong sign"
  std::function<void(Recording&)> apply;
};

/// A mistake in how captures were set up: not physics of the robot, but a convention, a name or a unit that was taken
/// for another. It is discrete: nothing between right and wrong. One file each in setups/catalogue/.
struct SetUp {
  std::string name;             // "reversedJoint"
  std::string description;      // one plain sentence for users
  std::string question;         // to ask a person; {} stands for the place
  std::string needs = {};       // what must be known for it, besides the captures; empty: nothing
  bool needsNeighbours = false; // mends a capture by those before and after it, so that none may be left out
  /// Where it may have been made in these captures: "elbow", "elbow,wrist"; one empty place where it concerns all.
  std::function<std::vector<std::string>(const Measurements&)> listPlaces;
  /// The ways in which it may have been made there; which one, the captures tell.
  std::function<std::vector<Mending>(const Measurements&, const std::string& place)> listMendings;

  std::string labelAt(const std::string& place) const { return place.empty() ? name : name + '@' + place; }
};

} // namespace naocal
