#include "LolaTwin.hpp"
#include "hardware/nao/LolaMessages.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace naocal;

namespace {

std::span<const std::uint8_t> bytesOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Brightness values that identify their light.
template <std::size_t Count> std::array<Rgb, Count> lights(float first) {
  std::array<Rgb, Count> result;
  for (std::size_t i = 0; i < Count; ++i) {
    result[i] = {first + float(i) / 100, first + float(i) / 100 + 0.2f, first + float(i) / 100 + 0.4f};
  }
  return result;
}

void expect(twin::Writer& out, const char* name, const std::vector<float>& numbers) {
  out.text(name);
  out.list(numbers.size());
  for (const float number : numbers) {
    out.number(number);
  }
}

template <std::size_t Count> std::vector<float> redsGreensBlues(const std::array<Rgb, Count>& of) {
  std::vector<float> result;
  for (float Rgb::*colour : {&Rgb::red, &Rgb::green, &Rgb::blue}) {
    for (const Rgb& light : of) {
      result.push_back(light.*colour);
    }
  }
  return result;
}

} // namespace

// Proves sizes, names, positions and units of a state against the test's own encoder. The description of LoLA is taken
// as correct.
TEST_CASE("a state of 896 bytes is understood: every number arrives at its joint and sensor") {
  const std::string message = twin::state(12345);
  REQUIRE(message.size() == lolaStateSize);
  const auto read = parseLolaState(bytesOf(message));
  REQUIRE(std::holds_alternative<LolaState>(read));
  const auto& [identity, state] = std::get<LolaState>(read);

  CHECK(identity == RobotIdentity{"P0000073A07S94700012", "P0000074A05S93M00061", "6.0.0", "6.0.1"});
  for (std::size_t i = 0; i < twin::names.size(); ++i) {
    const std::size_t joint = *jointIndex(twin::names[i]);
    CHECK(state.angles[joint] == twin::reported("Position", i, 12345));
    CHECK(state.stiffness[joint] == twin::reported("Stiffness", i, 12345));
    CHECK(state.current[joint] == twin::reported("Current", i, 12345));
    CHECK(state.temperature[joint] == twin::reported("Temperature", i, 12345));
    CHECK(state.status[joint] == int((12345 + i) % 8));
  }
  const std::size_t left = *jointIndex("LHipYawPitch"), right = *jointIndex("RHipYawPitch");
  CHECK(state.angles[left] == state.angles[right]);
  CHECK(state.temperature[left] == state.temperature[right]);
  CHECK(state.accelerometer.z() == twin::reported("Accelerometer", 2, 12345));
  CHECK(state.gyroscope.y() == twin::reported("Gyroscope", 1, 12345));
  CHECK(state.torsoAngles.x() == twin::reported("Angles", 0, 12345));
  CHECK(state.forces[7] == twin::reported("FSR", 7, 12345));
  CHECK(state.sonar[1] == twin::reported("Sonar", 1, 12345));
  CHECK(state.battery.temperature == twin::reported("Battery", 3, 12345));
}

// Proves the order of the touch sensors.
TEST_CASE("each of the fourteen touch sensors is understood as its own") {
  const std::array<bool Touch::*, 14> wire{&Touch::chestButton,   &Touch::headFront,      &Touch::headMiddle,
                                           &Touch::headRear,      &Touch::leftFootLeft,   &Touch::leftFootRight,
                                           &Touch::leftHandBack,  &Touch::leftHandLeft,   &Touch::leftHandRight,
                                           &Touch::rightFootLeft, &Touch::rightFootRight, &Touch::rightHandBack,
                                           &Touch::rightHandLeft, &Touch::rightHandRight};
  for (std::size_t i = 0; i < wire.size(); ++i) {
    Touch only;
    only.*wire[i] = true;
    const auto read = parseLolaState(bytesOf(twin::state(std::uint32_t{1} << i)));
    REQUIRE(std::holds_alternative<LolaState>(read));
    CHECK(std::get<LolaState>(read).state.touch == only);
  }
}

// Proves that truncated, extended or structurally damaged messages are refused. A changed number is not noticed: the
// protocol has no checksum.
TEST_CASE("a message that is no whole state is refused, wherever it is broken") {
  const std::string good = twin::state(7);
  for (std::size_t length = 0; length < good.size(); ++length) {
    CHECK(std::holds_alternative<std::string>(parseLolaState(bytesOf(good.substr(0, length)))));
  }
  CHECK(std::holds_alternative<std::string>(parseLolaState(bytesOf(good + '\0'))));
  std::size_t refused = 0;
  for (std::size_t place = 0; place < good.size(); ++place) {
    for (const int value : {0x00, 0x8f, 0x9f, 0xc0, 0xc1, 0xc3, 0xcb, 0xcf, 0xdd, 0xdf, 0xff}) {
      std::string bent = good;
      bent[place] = char(value);
      refused += std::holds_alternative<std::string>(parseLolaState(bytesOf(bent)));
    }
  }
  CHECK(refused > 11 * 200); // names, lengths and types are about a quarter of a state
}

// Compares every byte of a command with the test's own encoder.
TEST_CASE("a command has 786 bytes in LoLA's order, and motors without stiffness are switched off") {
  RobotCommand command;
  for (std::size_t joint = 0; joint < jointCount; ++joint) {
    command.angles[joint] = 0.125 * double(joint) - 1;
    command.stiffness[joint] = 0.01 * double(joint);
  }
  command.stiffness[1] = 3;
  command.leds.chest = {0.1f, 0.2f, 0.3f};
  command.leds.leftFoot = {0.4f, 0.5f, 0.6f};
  command.leds.rightFoot = {0.7f, 0.8f, 0.9f};
  command.leds.leftEye = lights<8>(0.1f);
  command.leds.rightEye = lights<8>(0.3f);
  std::vector<float> positions, stiffness, ears(10), skull(12);
  for (std::size_t i = 0; i < 10; ++i) {
    command.leds.leftEar[i] = command.leds.rightEar[i] = ears[i] = float(i) / 10;
  }
  for (std::size_t i = 0; i < 12; ++i) {
    command.leds.skull[i] = skull[i] = float(i) / 12;
  }
  for (const std::string_view name : twin::names) {
    const std::size_t joint = *jointIndex(name);
    positions.push_back(float(0.125 * double(joint) - 1));
    stiffness.push_back(joint == 0 ? -1.f : joint == 1 ? 1.f : float(0.01 * double(joint)));
  }

  twin::Writer expected;
  expected.byte(0x8b);
  expect(expected, "Chest", {0.1f, 0.2f, 0.3f});
  expect(expected, "LEar", ears);
  expect(expected, "LEye", redsGreensBlues(command.leds.leftEye));
  expect(expected, "LFoot", {0.4f, 0.5f, 0.6f});
  expect(expected, "Position", positions);
  expect(expected, "REar", ears);
  expect(expected, "REye", redsGreensBlues(command.leds.rightEye));
  expect(expected, "RFoot", {0.7f, 0.8f, 0.9f});
  expect(expected, "Skull", skull);
  expected.text("Sonar");
  expected.list(2);
  expected.byte(0xc3);
  expected.byte(0xc3);
  expect(expected, "Stiffness", stiffness);

  LolaCommandWriter writer;
  for (int repeat = 0; repeat < 2; ++repeat) { // the second time the buffer is reused
    const auto message = writer.encode(command);
    REQUIRE(message.size() == lolaCommandSize);
    CHECK((std::string(message.begin(), message.end()) == expected.bytes));
  }
}

// Proves that no command with NaN or infinity is encoded, which MessagePack would allow. Lights may be NaN.
TEST_CASE("a command with an angle that is no finite number is not written") {
  LolaCommandWriter writer;
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300}) {
    RobotCommand command;
    command.angles[3] = bad;
    CHECK(writer.encode(command).empty());
    command.angles[3] = 0;
    command.stiffness[25] = bad;
    CHECK(writer.encode(command).empty());
  }
  RobotCommand dark;
  dark.leds.skull[0] = std::numeric_limits<float>::quiet_NaN();
  CHECK(writer.encode(dark).size() == lolaCommandSize);
}
