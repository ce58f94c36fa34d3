#pragma once

#include "SeenRobot.hpp"

#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

/// Heavy (Boost.Asio): included by Robots.cpp and Panel.cpp only.

namespace naocal {

/// The robots that panels look at, by address. A key is subscribed to as long as some panel shows it. When no panel has
/// been open for a while there is nobody to press Stop: the robots are left alone until one comes, and so end what they
/// were told to do.
class Robots {
public:
  static constexpr std::chrono::milliseconds usualPatience{5000}; // a page may be loaded anew
  Robots(boost::asio::io_context& context, RobotsCalls calls, std::chrono::milliseconds patience = usualPatience);

  /// Throws InputError for an address that cannot be one.
  void connect(const std::string& address);

  /// Does what a panel asks for: {"do": "connect" | "disconnect" | "watch" | "unwatch", "robot"}, {"do": "subscribe" |
  /// "unsubscribe", "robot", "key"}, {"do": "keys", "robot", "mount"}, {"do": "set", "robot", "settings"}, {"do":
  /// "save", "robot"}. False: that is nothing for robots.
  bool asked(std::size_t panel, const nlohmann::json& request);

  std::vector<std::string> addresses() const;
  /// The picture of a capture, "ROBOT/SERIES/PLACE"; absent where none was seen.
  std::optional<std::string> takenPicture(std::string_view path) const;

  /// A panel has come; tells it what it must know.
  void greet(std::size_t panel);
  /// A panel has gone.
  void forget(std::size_t panel);

private:
  void disconnect(const std::string& address);

  boost::asio::io_context& context_;
  RobotsCalls calls_;
  std::chrono::milliseconds patience_;
  std::set<std::size_t> panels_; // that are open
  boost::asio::steady_timer alone_;
  std::map<std::string, std::shared_ptr<SeenRobot>> robots_;
};

} // namespace naocal
