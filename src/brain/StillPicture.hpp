#pragma once

#include "brain/NewFrame.hpp"
#include "data/Capture.hpp"

namespace naocal {

/// A picture that was taken while nothing moved, with what the robot measured in the middle of its exposure.
struct StillPicture {
  bool isNew = false;
  bool isMoving = false; // instead: one came, but something moved
  CameraFrame frame;
  Capture capture;     // without pose and corners
  double stillFor = 0; // how long nothing had moved by then [s]
};
void to_json(nlohmann::json& out, const StillPicture& picture);

} // namespace naocal
