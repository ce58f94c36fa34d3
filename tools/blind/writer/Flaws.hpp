#pragma once

#include "writer/Drawing.hpp"

#include <Eigen/Core>
#include <array>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace blind {

/// What one joint's mechanism does beside turning. Zero everywhere: a perfect joint.
struct JointFlaws {
  double gap = 0;                           // play between motor and link [rad], taken up by the load
  double gapFriction = 0.03;                // a weaker load leaves the play to the motion [Nm]
  double stickiness = 0.2;                  // what that friction is in a gear that sticks [Nm]
  double lag = 0;                           // play that friction holds: taken up by motion alone [rad]
  double compliance = 0;                    // of the spring between motor and link [rad/Nm]
  double gain = 0;                          // a turn of the link is read as 1 / (1 + gain) turns [1]
  double magnetX = 0, magnetY = 0;          // the encoder's magnet off its axis, in parts of its radius [1]
  double warming = 0;                       // [rad/K] over 30 degrees Celsius
  double creep = 0;                         // [rad/s]
  double tiltAlpha = 0, tiltBeta = 0;       // of the axis [rad]
  double ripple = 0;                        // amplitude of a six-lobed gear error [rad]
  double rootSag = 0;                       // [rad/sqrt(Nm)]
  double slip = 0, slipTime = 0;            // a step [rad] at a time [s]
  double pulled = 0, pulledByMagnitude = 0; // [rad/rad] by another joint's angle, by its magnitude
  int puller = -1;                          // that joint
};

struct CameraFlaws {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();     // in the head's frame [m]
  double focal = 0;                                    // [1]
  Eigen::Vector2d principal = Eigen::Vector2d::Zero(); // [px]
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0;               // [1]
  double rowTime = 0;                                  // [s/row]
  double turning = 0;                                  // the mount's slow turn about its y axis [rad/s]
};

struct BoardFlaws {
  double scale = 0;           // [1]
  double bow = 0;             // height of the pattern's centre over its corners when the sheet is bent to a cap [m]
  double roll = 0, pitch = 0; // [rad]
};

struct SoleFlaws {
  double compliance = 0;      // [rad/m]
  double roll = 0, pitch = 0; // [rad]
};

/// Everything that is wrong with a robot and its surroundings beside its offsets.
struct Flaws {
  std::vector<JointFlaws> joints; // as in the drawing
  std::array<CameraFlaws, 2> cameras;
  std::vector<BoardFlaws> boards;
  std::array<SoleFlaws, 2> soles;
  std::map<std::string, double> lengths; // changes [m]
  double delay = 0;                      // the pictures are so much younger than the angles [s]
};

/// One kind of hidden flaw and where it can sit.
struct FlawFamily {
  struct Unknown {
    std::string name, unit;
    double physical;      // a size to be expected of a used robot
    double plausible = 0; // how large it may plausibly be (1 sigma), where that differs
    double wide() const { return plausible > 0 ? plausible : physical; }
  };
  std::string effect; // the contract's name, or one of our own where the catalogue has none
  std::vector<Unknown> unknowns;
  std::vector<std::string> places; // of joints of a leg without the side's letter
  std::function<void(Flaws&, const Drawing&, const std::string& place, std::span<const double>)> apply;
  std::vector<std::string> drivers; // outside the catalogue: what the misfit varies with, in any of these words
};

/// Effects that every user of the catalogue may find.
const std::vector<FlawFamily>& catalogue();
/// A joint that stands otherwise from a time on.
const FlawFamily& offsetStep();
/// Physics that no catalogue lists; `physical` is 0.3 degrees at a joint's usual extreme.
const std::vector<FlawFamily>& offCatalogue();

/// The cameras' own families: shift, focal length, principal point, radial distortion.
const std::vector<std::string>& cameraFamilies();

/// The places of a family for a robot that stands on this foot (0 left, 1 right), as files name them.
std::vector<std::string> placesFor(const FlawFamily& family, int side, std::size_t boards);

} // namespace blind
