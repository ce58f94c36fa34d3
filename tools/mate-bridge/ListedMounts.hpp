#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>

namespace naocal {

/// Which of a robot's mounts may be asked for their keys. HULKs' own service ends at the name of a mount that it does
/// not have, so that a question waits until the robot has listed its mount.
class ListedMounts {
public:
  explicit ListedMounts(std::function<void(const std::string& mount)> ask) : ask_{std::move(ask)} {}

  /// Asks now, or once the mount is listed.
  void want(const std::string& mount);
  /// The robot's list: {"keys": [{"key": mount}]}. Throws Json::exception for anything else.
  void listed(const nlohmann::json& told);
  /// It may be another robot, or another program on it, that comes back.
  void forget();

private:
  std::function<void(const std::string& mount)> ask_;
  std::set<std::string> listed_, wanted_;
};

} // namespace naocal
