#pragma once

#include "SeenRobot.hpp"

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace boost::asio {
class io_context;
}

namespace naocal {

/// The robots that panels look at, by address. A key is subscribed to as long as some panel shows it.
class Robots {
public:
  Robots(boost::asio::io_context& context, RobotsCalls calls);

  /// Throws InputError for an address that cannot be one.
  void connect(const std::string& address);

  /// Does what a panel asks for: {"do": "connect" | "disconnect" | "watch" | "unwatch", "robot"}, {"do": "subscribe" |
  /// "unsubscribe", "robot", "key"}, {"do": "keys", "robot", "mount"}, {"do": "set", "robot", "settings"}, {"do":
  /// "save", "robot"}. False: that is nothing for robots.
  bool asked(std::size_t panel, const nlohmann::json& request);

  std::vector<std::string> addresses() const;

  /// What a panel that has just come must know.
  void greet(std::size_t panel) const;
  /// A panel has gone.
  void forget(std::size_t panel);

private:
  void disconnect(const std::string& address);

  boost::asio::io_context& context_;
  RobotsCalls calls_;
  std::map<std::string, std::shared_ptr<SeenRobot>> robots_;
};

} // namespace naocal
