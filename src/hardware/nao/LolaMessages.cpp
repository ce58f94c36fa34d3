#include "hardware/nao/LolaMessages.hpp"

#include "hardware/nao/DeviceConventions.hpp"

#include <algorithm>
#include <bitset>
#include <cassert>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// All red values, then all green, then all blue.
template <std::size_t Count> std::array<float, 3 * Count> byColour(const std::array<Rgb, Count>& lights) {
  std::array<float, 3 * Count> result;
  for (std::size_t i = 0; i < Count; ++i) {
    result[i] = lights[i].red;
    result[Count + i] = lights[i].green;
    result[2 * Count + i] = lights[i].blue;
  }
  return result;
}

/// In LoLA's joint order and in single precision, as on the wire.
std::array<float, 25> byLola(const PerJoint<double>& values) {
  std::array<float, 25> result;
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = float(values[lolaJointOrder[i]]);
  }
  return result;
}

/// The number lists of a state, in LoLA's units, which equal ours.
struct LolaList {
  std::string_view name;
  std::size_t first, count; // range in LolaNumbers
};
constexpr std::array<LolaList, 12> lolaLists{{{"Accelerometer", 0, 3},
                                              {"Angles", 3, 2},
                                              {"Battery", 5, 4},
                                              {"Current", 9, 25},
                                              {"FSR", 34, 8},
                                              {"Gyroscope", 42, 3},
                                              {"Position", 45, 25},
                                              {"Sonar", 70, 2},
                                              {"Stiffness", 72, 25},
                                              {"Temperature", 97, 25},
                                              {"Touch", 122, 14},
                                              {"Status", 136, 25}}};
using LolaNumbers = std::array<double, 161>;

/// Event handler (SAX) that parses a state message without building a document.
class LolaSax : public nlohmann::json_sax<nlohmann::json> {
public:
  bool null() override { return refuse("nothing (nil)"); }
  bool boolean(bool) override { return refuse("a truth value"); }
  bool number_integer(number_integer_t value) override { return number(double(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(double(value)); }
  bool number_float(number_float_t value, const string_t&) override { return number(value); }
  bool binary(binary_t&) override { return refuse("binary data"); }
  bool string(string_t& value) override {
    if (depth_ != 2 || current_ != configName || count_ == config.size()) {
      return refuse("a text");
    }
    config[count_++] = value;
    return true;
  }
  bool start_object(std::size_t) override { return depth_++ == 0 || refuse("a map"); }
  bool end_object() override {
    --depth_;
    return true;
  }
  bool key(string_t& name) override {
    current_ = 0;
    while (current_ < lolaLists.size() && lolaLists[current_].name != name) {
      ++current_;
    }
    count_ = 0;
    if (current_ == configName && name != "RobotConfig") {
      reason = "it has a list that is unknown";
      return false;
    }
    return true;
  }
  bool start_array(std::size_t) override { return depth_++ == 1 || refuse("a list in a list"); }
  bool end_array() override {
    --depth_;
    const std::size_t expected = current_ == configName ? config.size() : lolaLists[current_].count;
    if (count_ != expected) {
      reason = fmt::format("a list has {} entries instead of {}", count_, expected);
      return false;
    }
    seen_.set(current_);
    return true;
  }
  bool parse_error(std::size_t place, const std::string&, const nlohmann::json::exception&) override {
    reason = fmt::format("byte {} of it is no MessagePack", place);
    return false;
  }

  /// Whether every list was present.
  bool complete() {
    if (!seen_.all()) {
      reason = fmt::format("it has {} of {} lists", seen_.count(), seen_.size());
    }
    return seen_.all();
  }

  std::array<std::string, 4> config; // body id and version, head id and version
  LolaNumbers numbers{};
  std::string reason;

private:
  static constexpr std::size_t configName = lolaLists.size();

  bool number(double value) {
    if (depth_ != 2 || current_ == configName || count_ == lolaLists[current_].count) {
      return refuse("a number");
    }
    numbers[lolaLists[current_].first + count_++] = value;
    return true;
  }
  bool refuse(std::string_view found) {
    reason = fmt::format("{} stands where none can be", found);
    return false;
  }

  int depth_ = 0;
  std::size_t current_ = configName; // index of the current list
  std::size_t count_ = 0;            // entries read so far
  std::bitset<lolaLists.size() + 1> seen_;
};

PerJoint<double> byJoint(const double* ofLola) {
  PerJoint<double> result{};
  for (std::size_t i = 0; i < lolaJointOrder.size(); ++i) {
    result[lolaJointOrder[i]] = ofLola[i];
  }
  result[*jointIndex("RHipYawPitch")] = result[*jointIndex("LHipYawPitch")];
  return result;
}

RobotState stateOf(const LolaNumbers& numbers) {
  const auto of = [&](std::string_view name) {
    const auto* list = std::find_if(lolaLists.begin(), lolaLists.end(), [&](auto& one) { return one.name == name; });
    return &numbers[list->first];
  };
  RobotState state;
  state.angles = {byJoint(of("Position"))};
  state.stiffness = byJoint(of("Stiffness"));
  state.current = byJoint(of("Current"));
  state.temperature = byJoint(of("Temperature"));
  const PerJoint<double> status = byJoint(of("Status"));
  std::transform(status.begin(), status.end(), state.status.begin(), toStatusCode);
  state.accelerometer = Eigen::Map<const Eigen::Vector3d>{of("Accelerometer")};
  state.gyroscope = Eigen::Map<const Eigen::Vector3d>{of("Gyroscope")};
  state.torsoAngles = Eigen::Map<const Eigen::Vector2d>{of("Angles")};
  std::copy_n(of("FSR"), state.forces.size(), state.forces.begin());
  std::copy_n(of("Sonar"), state.sonar.size(), state.sonar.begin());
  const double* touch = of("Touch");
  for (std::size_t i = 0; i < touchOrder.size(); ++i) {
    state.touch.*touchOrder[i] = touch[i] > 0.5;
  }
  const double* battery = of("Battery");
  state.battery = {battery[0], battery[1], battery[2], battery[3]};
  return state;
}

} // namespace

bool hasLolaStateHeader(std::span<const std::uint8_t> message) {
  constexpr std::string_view beginning{"\x8d\xabRobotConfig"}; // a map of 13, a text of 11
  return message.size() >= beginning.size() && std::memcmp(message.data(), beginning.data(), beginning.size()) == 0;
}

std::variant<LolaState, std::string> parseLolaState(std::span<const std::uint8_t> message) {
  if (!hasLolaStateHeader(message)) {
    return "the robot's message does not begin as a state: the stream is out of step";
  }
  LolaSax sax;
  if (!nlohmann::json::sax_parse(message.begin(), message.end(), &sax, nlohmann::json::input_format_t::msgpack) ||
      !sax.complete()) {
    return fmt::format("the robot's message is no state: {}", sax.reason);
  }
  return LolaState{{sax.config[0], sax.config[2], sax.config[1], sax.config[3]}, stateOf(sax.numbers)};
}

struct LolaCommandWriter::Document {
  nlohmann::json root; // sorted keys match LoLA's order

  template <std::size_t Count> void set(const char* key, const std::array<float, Count>& numbers) {
    nlohmann::json& list = root[key];
    if (list.is_null()) {
      list = nlohmann::json::array();
      list.get_ref<nlohmann::json::array_t&>().resize(Count);
    }
    for (std::size_t i = 0; i < Count; ++i) {
      list[i] = std::isfinite(numbers[i]) ? numbers[i] : 0.f; // LED values only; joints were checked before
    }
  }
};

LolaCommandWriter::LolaCommandWriter() : document_{std::make_unique<Document>()} {
  document_->root["Sonar"] = {true, true};
}

LolaCommandWriter::~LolaCommandWriter() = default;

std::span<const std::uint8_t> LolaCommandWriter::encode(const RobotCommand& command) {
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
