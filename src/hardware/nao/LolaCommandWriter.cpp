#include "hardware/nao/LolaMessages.hpp"

#include "hardware/nao/Finite.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

/// All red, then all green, then all blue.
template <std::size_t Count> std::array<float, 3 * Count> byColour(const std::array<Rgb, Count>& lights) {
  std::array<float, 3 * Count> result;
  for (std::size_t i = 0; i < Count; ++i) {
    result[i] = lights[i].red;
    result[Count + i] = lights[i].green;
    result[2 * Count + i] = lights[i].blue;
  }
  return result;
}

/// In LoLA's order, to single precision, as the wire has them.
std::array<float, 25> byLola(const PerJoint<double>& values) {
  std::array<float, 25> result;
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = float(values[jointOfLola[i]]);
  }
  return result;
}

} // namespace

struct LolaCommandWriter::Document {
  nlohmann::json root; // sorted keys are LoLA's order

  template <std::size_t Count> void set(const char* key, const std::array<float, Count>& numbers) {
    nlohmann::json& list = root[key];
    if (list.is_null()) {
      list = nlohmann::json::array();
      list.get_ref<nlohmann::json::array_t&>().resize(Count);
    }
    for (std::size_t i = 0; i < Count; ++i) {
      list[i] = std::isfinite(numbers[i]) ? numbers[i] : 0.f; // a light's: joints were looked at
    }
  }
};

LolaCommandWriter::LolaCommandWriter() : document_{std::make_unique<Document>()} {
  document_->root["Sonar"] = {true, true};
}

LolaCommandWriter::~LolaCommandWriter() = default;

std::span<const std::uint8_t> LolaCommandWriter::message(const RobotCommand& command) {
  if (!isFinite(command)) {
    return {};
  }
  PerJoint<double> stiffness;
  std::transform(command.stiffness.begin(), command.stiffness.end(), stiffness.begin(), motorStiffness);
  const Leds& leds = command.leds;
  document_->set("Chest", byColour(std::array{leds.chest}));
  document_->set("LEar", leds.leftEar);
  document_->set("LEye", byColour(leds.leftEye));
  document_->set("LFoot", byColour(std::array{leds.leftFoot}));
  document_->set("Position", byLola(command.angles.values));
  document_->set("REar", leds.rightEar);
  document_->set("REye", byColour(leds.rightEye));
  document_->set("RFoot", byColour(std::array{leds.rightFoot}));
  document_->set("Skull", leds.skull);
  document_->set("Stiffness", byLola(stiffness));
  bytes_.clear();
  nlohmann::json::to_msgpack(document_->root, bytes_);
  assert(bytes_.size() == lolaCommandSize);
  return bytes_;
}

} // namespace naocal
