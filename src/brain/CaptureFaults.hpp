#pragma once

#include "data/Capture.hpp"
#include "hardware/CameraInterface.hpp"

#include <map>
#include <string>

namespace naocal {

/// Finds faults by which the captures of a calibration's round would be worthless: a camera that repeats a picture or
/// sees nothing, and a robot that is lifted off the floor. Foot sensors that never showed a load prove nothing.
class CaptureFaults {
public:
  static constexpr double darkestMean = 5;  // of a picture [grey levels]; below it the camera is covered
  static constexpr double lightestLoad = 1; // on both feet [kg]; below it nobody stands there: a NAO weighs over 5 kg

  void startRound() { *this = {}; }

  /// Why a picture cannot be used for a pose, as what has to happen first ("the top camera ..."); empty: it can. A
  /// picture that equals one of another pose bit by bit is a repetition: no camera is free of noise.
  std::string findCameraFault(const CameraFrame& frame, const std::string& pose) const;

  /// Notes a picture that was used, and the load on the feet.
  void note(const CameraFrame& frame, const Capture& capture);

  /// Whether the feet carry nothing, but did in an earlier capture of this round.
  bool isLifted(const Capture& still) const;

  /// Whether no capture showed a load: the foot sensors are dead.
  bool feltNoLoad() const { return !last_.empty() && !feltLoad_; }

private:
  struct Used {
    CameraFrame frame;
    std::string pose;
  };
  std::map<CameraName, Used> last_;
  bool feltLoad_ = false;
};

} // namespace naocal
