#pragma once

#include "framework/Sample.hpp"
#include "hardware/CameraInterface.hpp"

#include <nlohmann/json_fwd.hpp>

namespace naocal {

/// The picture that came last; `isNew` in the cycle in which it came.
struct NewFrame {
  bool isNew = false;
  CameraFrame frame;
};
void to_json(nlohmann::json& out, const NewFrame& frame);
void to_json(nlohmann::json& out, const CameraLink& link);

/// A camera's picture for people: as a JPEG of quality 75, in colour where it has any.
struct ShownFrame {
  CameraFrame frame;
};
EncodedPicture toPicture(const ShownFrame& shown);

} // namespace naocal
