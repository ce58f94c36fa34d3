#pragma once

#include "world/Drawing.hpp"

#include <Eigen/Core>
#include <array>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace blind {

/// Flaws of one joint's mechanism.
struct JointFlaws {
  double gap = 0;                           // play between motor and link, taken up by the load [rad]
  double gapFriction = 0.03;                // a smaller load leaves the play to the motion [Nm]
  double stickiness = 0.2;                  // value of that friction in a sticking gear [Nm]
  double lag = 0;                           // play held by friction: taken up by motion only [rad]
  double compliance = 0;                    // of the spring between motor and link [rad/Nm]
  double gain = 0;                          // link rotation = (1 + gain) * reading [1]
  double magnetX = 0, magnetY = 0;          // eccentricity of the encoder's magnet, in units of its radius [1]
  double warming = 0;                       // drift with temperature above 30 degrees Celsius [rad/K]
  double creep = 0;                         // [rad/s]
  double tiltAlpha = 0, tiltBeta = 0;       // of the axis [rad]
  double ripple = 0;                        // amplitude of a six-lobed gear error [rad]
  double rootSag = 0;                       // [rad/sqrt(Nm)]
  double slip = 0, slipTime = 0;            // a step [rad] at a time [s]
  double pulled = 0, pulledByMagnitude = 0; // [rad/rad] per angle of another joint, per its magnitude
  int puller = -1;                          // that joint; -1: none
};

struct CameraFlaws {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();     // in the head's frame [m]
  double focal = 0;                                    // [1]
  Eigen::Vector2d principal = Eigen::Vector2d::Zero(); // [px]
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0;               // [1]
  double rowTime = 0;                                  // [s/row]
  double turning = 0;                                  // slow rotation of the mount about its y axis [rad/s]
};

struct BoardFlaws {
  double scale = 0;           // [1]
  double bow = 0;             // height of the centre above the corners of a bent sheet (spherical cap) [m]
  double roll = 0, pitch = 0; // [rad]
};

struct SoleFlaws {
  double compliance = 0;      // [rad/m]
  double roll = 0, pitch = 0; // [rad]
};

/// All errors of a robot and its surroundings, except joint offsets and camera mounts.
struct Flaws {
  std::vector<JointFlaws> joints; // in the drawing's order
  std::array<CameraFlaws, 2> cameras;
  std::vector<BoardFlaws> boards;
  std::array<SoleFlaws, 2> soles;
  std::map<std::string, double> lengths; // changes [m]
  double delay = 0;                      // images are taken this much later than the angles [s]
};

/// A kind of hidden flaw and its possible places.
struct FlawFamily {
  struct Unknown {
    std::string name, unit;
    double physical;      // expected size on a used robot
    double plausible = 0; // plausible size, 1 sigma; 0: same as `physical`
    double wide() const { return plausible > 0 ? plausible : physical; }
  };
  std::string effect; // catalogue name, or a name of our own outside the catalogue
  std::vector<Unknown> unknowns;
  std::vector<std::string> places; // for leg joints without the letter of the side
  std::function<void(Flaws&, const Drawing&, const std::string& place, std::span<const double>)> apply;
  std::vector<std::string> drivers; // outside the catalogue: accepted names of the misfit's driver
};

/// Families of the effects catalogue.
const std::vector<FlawFamily>& catalogue();
/// A joint offset that steps at a time.
const FlawFamily& offsetStep();
/// Physical effects not in the catalogue; `physical` is 0.3 degrees at the joint's usual extreme.
const std::vector<FlawFamily>& offCatalogue();

/// Camera families: translation, focal length, principal point, radial distortion.
const std::vector<std::string>& cameraFamilies();

/// The places of a family for a robot on this foot (0 left, 1 right), as named in files.
std::vector<std::string> placesFor(const FlawFamily& family, int side, std::size_t boards);

} // namespace blind
