#include "dialects/UrdfCorrection.hpp"

#include "io/InputError.hpp"
#include "io/XmlDocument.hpp"
#include "math/Angles.hpp"
#include "robot/Kinematics.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <sstream>

namespace naocal {

namespace {

using Eigen::AngleAxisd, Eigen::Vector3d;
using Placement6 = Eigen::Matrix<double, 6, 1>; // x, y, z, roll, pitch, yaw

Vector3d readNumbers(const TiXmlElement& origin, const char* key) {
  Vector3d numbers = Vector3d::Zero(); // the URDF's default
  if (const char* text = origin.Attribute(key)) {
    std::istringstream{text} >> numbers.x() >> numbers.y() >> numbers.z();
  }
  return numbers;
}

std::string writeNumbers(const Vector3d& numbers) {
  return fmt::format("{} {} {}", numbers.x(), numbers.y(), numbers.z());
}

Eigen::Isometry3d motionOf(const Joint& joint, double q) {
  if (joint.isPrismatic) {
    return Eigen::Isometry3d{Eigen::Translation3d{q * joint.axis}};
  }
  return Eigen::Isometry3d{AngleAxisd{q, joint.axis}};
}

Eigen::Isometry3d geometryOf(const UrdfJointCorrection& correction) {
  const Vector3d& r = correction.rotation;
  return Eigen::Translation3d{correction.translation} * AngleAxisd{r.x(), Vector3d::UnitX()} *
         AngleAxisd{r.y(), Vector3d::UnitY()} * AngleAxisd{r.z(), Vector3d::UnitZ()};
}

std::string offsetText(const Joint& joint, double offset) {
  return joint.isPrismatic ? fmt::format("{:.4f} mm", offset * 1000) : fmt::format("{:.4f} degrees", degrees(offset));
}

/// Corrects the element of one joint.
void correctElement(TiXmlElement& element, const Joint& joint, const UrdfJointCorrection& correction) {
  TiXmlElement* origin = element.FirstChildElement("origin");
  if (origin == nullptr) {
    origin = element.InsertEndChild(TiXmlElement{"origin"})->ToElement();
  }
  Placement6 drawn;
  drawn << readNumbers(*origin, "xyz"), readNumbers(*origin, "rpy");
  const Eigen::Isometry3d step = geometryOf(correction) * motionOf(joint, -correction.offset);
  const Placement6 corrected =
      placementFromTransform(transformFromPlacement(drawn) * RigidTransform{step.linear(), step.translation()});
  origin->SetAttribute("xyz", writeNumbers(corrected.head<3>()));
  origin->SetAttribute("rpy", writeNumbers(corrected.tail<3>()));
  const std::string note = fmt::format(" calibrated by naocal: offset {} (reading minus true) is in the origin ",
                                       offsetText(joint, correction.offset));
  element.InsertBeforeChild(origin, TiXmlComment{note.c_str()});
}

} // namespace

std::string correctUrdf(const std::string& text, const std::string& name, const Robot& robot,
                        const std::map<std::string, UrdfJointCorrection>& corrections) {
  for (const auto& [joint, correction] : corrections) {
    if (!robot.jointIndex(joint)) {
      throw InputError{fmt::format("{}: expected the joint {} of the result, found none", name, joint)};
    }
  }
  TiXmlDocument document = parseXml(text, name, "a URDF");
  TiXmlElement* const root = document.FirstChildElement("robot");
  if (root == nullptr) {
    throw InputError{fmt::format("{}: expected a URDF, found other XML", name)};
  }
  for (TiXmlElement* element = root->FirstChildElement("joint"); element != nullptr;
       element = element->NextSiblingElement("joint")) {
    const char* const jointName = element->Attribute("name");
    const auto index = robot.jointIndex(jointName == nullptr ? "" : jointName);
    if (!index) {
      continue; // fixed
    }
    const Joint& joint = robot.joints[*index];
    UrdfJointCorrection correction;
    if (const auto own = corrections.find(joint.name); own != corrections.end()) {
      correction = own->second;
    }
    if (joint.motor != *index) {
      const auto driving = corrections.find(robot.joints[joint.motor].name);
      correction.offset += driving == corrections.end() ? 0 : joint.ratio * driving->second.offset;
    }
    if (correction.offset != 0 || !correction.translation.isZero(0) || !correction.rotation.isZero(0)) {
      correctElement(*element, joint, correction);
    }
  }
  TiXmlPrinter printer;
  printer.SetIndent("  ");
  document.Accept(&printer);
  return printer.Str();
}

std::string urdfOffsetsYaml(const Robot& robot, const std::map<std::string, UrdfJointCorrection>& corrections) {
  std::string yaml =
      "# Joint offsets by naocal: reading minus true angle [rad], of slides [m]. For the URDF as it was;\n"
      "# the corrected URDF has them in its origins.\njoint_offsets:\n";
  for (const Joint& joint : robot.joints) {
    if (const auto found = corrections.find(joint.name); found != corrections.end()) {
      yaml +=
          fmt::format("  {}: {{offset: {}, sigma: {}}}\n", joint.name, found->second.offset, found->second.offsetSigma);
    }
  }
  return yaml;
}

} // namespace naocal
