#pragma once

#include "TemporaryFolder.hpp"
#include "framework/configuration/Configuration.hpp"
#include "io/Files.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace naocal {

/// Configuration in a temporary folder, for a robot with head "Ada" and body "Bob" at the location "Home".
struct ConfiguredRobot {
  explicit ConfiguredRobot(RobotNames robot = {"Home", "Ada", "Bob"}) : names{std::move(robot)} {}

  TemporaryFolder folder;
  RobotNames names;
  Configuration configuration{folder.path(), names, writeAtomically};

  std::filesystem::path path(const std::string& file) const { return folder.path() / "location" / file; }
  void file(const std::string& file, const std::string& content) const {
    std::filesystem::create_directories(path(file).parent_path());
    writeAtomically(path(file), content);
  }
  nlohmann::json content(const std::string& file) const { return nlohmann::json::parse(readFile(path(file))); }
  nlohmann::json readKeys(const std::string& mount) const {
    nlohmann::json out;
    configuration.readKeys(mount, out);
    return out;
  }
};

} // namespace naocal
