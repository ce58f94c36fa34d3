#pragma once

/* Keys of the robot's devices in NAOqi's memory. Source: Aldebaran, NAO H25 actuator & sensor list, NAOqi 2.1. */

#include <string>
#include <vector>

namespace naocal {

typedef std::vector<std::string> Keys;

static const char* const deviceNames[] = {
    "HeadYaw",       "HeadPitch",  "LShoulderPitch", "LShoulderRoll", "LElbowYaw",  "LElbowRoll",
    "LWristYaw",     "LHand",      "LHipYawPitch",   "LHipRoll",      "LHipPitch",  "LKneePitch",
    "LAnklePitch",   "LAnkleRoll", "LHipYawPitch", /* the right one has no device of its own */
    "RHipRoll",      "RHipPitch",  "RKneePitch",     "RAnklePitch",   "RAnkleRoll", "RShoulderPitch",
    "RShoulderRoll", "RElbowYaw",  "RElbowRoll",     "RWristYaw",     "RHand"};

static const size_t rightHipYawPitch = 14; /* not commanded */

/* prefix + name + suffix for each name; names are separated by blanks. */
inline Keys keys(const std::string& prefix, const std::string& names, const std::string& suffix) {
  Keys result;
  for (size_t begin = 0; begin < names.size();) {
    size_t end = names.find(' ', begin);
    end = end == std::string::npos ? names.size() : end;
    result.push_back(prefix + names.substr(begin, end - begin) + suffix);
    begin = end + 1;
  }
  return result;
}

inline void append(Keys& to, const Keys& more) {
  to.insert(to.end(), more.begin(), more.end());
}

inline Keys jointKeys(const std::string& suffix, bool commanded) {
  Keys result;
  for (size_t joint = 0; joint < sizeof deviceNames / sizeof *deviceNames; ++joint) {
    if (!commanded || joint != rightHipYawPitch) {
      result.push_back("Device/SubDeviceList/" + std::string(deviceNames[joint]) + suffix);
    }
  }
  return result;
}

/* In the order of the members of shared::State after the time. */
inline Keys sensorKeys() {
  const std::string device = "Device/SubDeviceList/", value = "/Sensor/Value";
  Keys result = jointKeys("/Position/Sensor/Value", false);
  append(result, jointKeys("/Hardness/Actuator/Value", false));
  append(result, jointKeys("/ElectricCurrent/Sensor/Value", false));
  append(result, jointKeys("/Temperature/Sensor/Value", false));
  append(result, jointKeys("/Temperature/Sensor/Status", false));
  append(result,
         keys(device + "InertialSensor/",
              "AccelerometerX AccelerometerY AccelerometerZ GyroscopeX GyroscopeY GyroscopeZ AngleX AngleY", value));
  append(result, keys(device + "LFoot/FSR/", "FrontLeft FrontRight RearLeft RearRight", value));
  append(result, keys(device + "RFoot/FSR/", "FrontLeft FrontRight RearLeft RearRight", value));
  append(result, keys(device + "US/", "Left Right", value));
  append(result, keys(device,
                      "ChestBoard/Button Head/Touch/Front Head/Touch/Middle Head/Touch/Rear LFoot/Bumper/Left "
                      "LFoot/Bumper/Right LHand/Touch/Back LHand/Touch/Left LHand/Touch/Right RFoot/Bumper/Left "
                      "RFoot/Bumper/Right RHand/Touch/Back RHand/Touch/Left RHand/Touch/Right",
                      value));
  append(result, keys(device + "Battery/Charge/Sensor/", "Value Status", ""));
  append(result, keys(device + "Battery/", "Current Temperature", value));
  return result;
}

/* In the order of the LEDs in shared::Command. */
inline Keys lightKeys() {
  const std::string device = "Device/SubDeviceList/", value = "/Actuator/Value", colours = "Red Green Blue";
  Keys result = keys(device + "ChestBoard/Led/", colours, value);
  append(result, keys(device + "LFoot/Led/", colours, value));
  append(result, keys(device + "RFoot/Led/", colours, value));
  const Keys left = keys("", "45 0 315 270 225 180 135 90", "Deg"),
             right = keys("", "0 45 90 135 180 225 270 315", "Deg");
  for (size_t i = 0; i < 8; ++i) {
    append(result, keys(device + "Face/Led/", colours, "/Left/" + left[i] + value));
  }
  for (size_t i = 0; i < 8; ++i) {
    append(result, keys(device + "Face/Led/", colours, "/Right/" + right[i] + value));
  }
  append(result, keys(device + "Ears/Led/Left/", "0 36 72 108 144 180 216 252 288 324", "Deg" + value));
  append(result, keys(device + "Ears/Led/Right/", "324 288 252 216 180 144 108 72 36 0", "Deg" + value));
  append(result, keys(device + "Head/Led/",
                      "Front/Left/1 Front/Left/0 Middle/Left/0 Rear/Left/0 Rear/Left/1 Rear/Left/2 Rear/Right/2 "
                      "Rear/Right/1 Rear/Right/0 Middle/Right/0 Front/Right/0 Front/Right/1",
                      value));
  return result;
}

} // namespace naocal
