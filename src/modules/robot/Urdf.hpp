#pragma once

#include "robot/Robot.hpp"

#include <filesystem>
#include <string>

namespace naocal {

/// Reads a robot from a URDF: links with masses and collision shapes (but for meshes), revolute, continuous, prismatic
/// and fixed joints, limits, mimic (https://wiki.ros.org/urdf/XML). Links and joints are listed depth first from the
/// root; absent elements have the specification's defaults. A joint that mimics one that mimics is driven by the first
/// of them; a motor that drives several joints has one name, that of the joint that mimics none.
///
/// Throws InputError with file, place, expected and found: files with xacro's elements or unexpanded expressions,
/// names that are not UTF-8, loops, no root or several, unknown joint types, numbers that are none, zero axes, negative
/// masses, mimic of unknown joints.
Robot loadUrdf(const std::filesystem::path& file);

/// The text of a URDF. Throws InputError for a file that cannot be read or is larger than any URDF.
std::string readUrdf(const std::filesystem::path& file);

/// `name`: the file's, for error messages.
Robot parseUrdf(const std::string& text, const std::string& name);

} // namespace naocal
