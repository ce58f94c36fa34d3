#pragma once

#include "robot/CapturePictures.hpp"
#include "robot/LiveDetection.hpp"
#include "robot/RobotClient.hpp"

#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// Heavy (Boost.Asio): included by Robots.cpp and Panel.cpp only.
namespace naocal {

/// Who looks at which of a robot's keys.
class Subscriptions {
public:
  void add(const std::string& key, std::size_t viewer);
  /// Whether nobody looks at that key any more.
  bool remove(const std::string& key, std::size_t viewer);
  /// The keys that nobody looks at once this one has gone.
  std::vector<std::string> forget(std::size_t viewer);

  const std::set<std::size_t>& subscribersOf(std::string_view key) const;

private:
  std::map<std::string, std::set<std::size_t>, std::less<>> viewers_; // by key; none is empty
};

/// Where robots' messages go; all on the thread that runs the context.
struct PanelCallbacks {
  std::function<void(const std::string& json)> all;                        // for every panel
  std::function<void(std::size_t panel, const std::string& json)> one;     // for one
  std::function<void(std::size_t panel, std::string json)> update;         // live values, skippable
  std::function<void(std::size_t panel, std::string headAndFile)> picture; // "{json}\n" and the file, skippable
  std::function<void(std::function<void()>)> later;                        // to that thread, from any other
};

/// A robot that panels look at: its link, who looks at which of its keys, and what its watch works out.
class WatchedRobot : public std::enable_shared_from_this<WatchedRobot> {
public:
  /// Throws InputError for an address that cannot be one.
  WatchedRobot(boost::asio::io_context& context, std::string address, const PanelCallbacks& calls);

  /// A viewer's interest in a key: a panel's, or the watch's.
  void subscribe(const std::string& key, std::size_t viewer);
  void unsubscribe(const std::string& key, std::size_t viewer);
  /// Live detection for a panel.
  void watch(std::size_t panel);
  void unwatch(std::size_t panel);
  void requestKeys(const std::string& mount) { mounts_.request(mount); }
  /// `settings`: [{"mp", "key", "value"}]; those of naocal.access alone are its secret, and sent whenever it connects.
  /// Throw InputError when the robot is away.
  void set(const nlohmann::json& settings);
  void save();
  /// What a panel that has just come must know.
  void addPanel(std::size_t panel) const;
  /// The picture of a capture ("SERIES/PLACE" of its list); absent where none was seen.
  std::optional<std::string> takenPicture(std::string_view which) const;
  /// A panel has gone.
  void removePanel(std::size_t panel);

  /// Leaves the robot alone until `wake`.
  void suspend() { link_->suspend(); }
  void resume() { link_->resume(); }

private:
  std::string state() const;
  void changed();
  void listed(const std::string& kind, const std::string& body);
  void updated(const std::string& body);
  void pictured(const std::string& body);
  void wantMounts();
  std::string takenPictures() const;
  void tellTaken() const;

  std::string address_;
  const PanelCallbacks& calls_;
  Subscriptions viewers_;
  std::map<std::string, std::string> latest_; // messages for panels to come, by kind
  std::set<std::size_t> watchers_;            // panels
  CapturePictures taken_;                     // of its calibration's captures
  std::unique_ptr<LiveDetection> watch_;      // once somebody asked for it
  MountRegistry mounts_{[this](const std::string& mount) { link_->askForKeys(mount); }};
  std::unique_ptr<RobotClient> link_;
};

/// The robots that panels look at, by address. A key is subscribed to as long as some panel shows it. When no panel has
/// been open for a while there is nobody to press Stop: the robots are left alone until one comes, and so end what they
/// were told to do.
class Robots {
public:
  static constexpr std::chrono::milliseconds defaultPatience{5000}; // a page may be loaded anew
  Robots(boost::asio::io_context& context, PanelCallbacks calls, std::chrono::milliseconds patience = defaultPatience);

  /// Throws InputError for an address that cannot be one.
  void connect(const std::string& address);

  void disconnect(const std::string& address);
  /// nullptr: not connected to.
  WatchedRobot* find(const std::string& address) const;
  /// Throws InputError where it is not connected to; `verb`: what it is wanted for.
  WatchedRobot& at(const std::string& address, const std::string& verb) const;

  std::vector<std::string> addresses() const;
  /// The picture of a capture, "ROBOT/SERIES/PLACE"; absent where none was seen.
  std::optional<std::string> takenPicture(std::string_view path) const;

  /// A panel has come; tells it what it must know.
  void addPanel(std::size_t panel);
  /// A panel has gone.
  void removePanel(std::size_t panel);

private:
  boost::asio::io_context& context_;
  PanelCallbacks calls_;
  std::chrono::milliseconds patience_;
  std::set<std::size_t> panels_; // that are open
  boost::asio::steady_timer alone_;
  std::map<std::string, std::shared_ptr<WatchedRobot>> robots_;
};

} // namespace naocal
