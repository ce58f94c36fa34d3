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

/// Heavy header (Boost.Asio): include it in Robots.cpp and Panel.cpp only.
namespace naocal {

/// Viewers of a robot's keys.
class Subscriptions {
public:
  void add(const std::string& key, std::size_t viewer);
  /// True if the key has lost its last viewer.
  bool remove(const std::string& key, std::size_t viewer);
  /// Removes a viewer; returns the keys that have lost their last viewer.
  std::vector<std::string> forget(std::size_t viewer);

  const std::set<std::size_t>& subscribersOf(std::string_view key) const;

private:
  std::map<std::string, std::set<std::size_t>, std::less<>> viewers_; // by key; never empty sets
};

/// Sinks of robots' messages; called on the context's thread.
struct PanelCallbacks {
  std::function<void(const std::string& json)> all;                        // to every panel
  std::function<void(std::size_t panel, const std::string& json)> one;     // to one panel
  std::function<void(std::size_t panel, std::string json)> update;         // live values, skippable
  std::function<void(std::size_t panel, std::string headAndFile)> picture; // "{json}\n" and the file, skippable
  std::function<void(std::function<void()>)> later;                        // posts to that thread; thread-safe
  std::function<void(const std::string& robot, const nlohmann::json& runs)> runs = {}; // a robot's newest runs
};

/// A robot shown in panels: its connection, the viewers of its keys, and its live detection.
class WatchedRobot : public std::enable_shared_from_this<WatchedRobot> {
public:
  /// Throws InputError for an invalid address.
  WatchedRobot(boost::asio::io_context& context, std::string address, const PanelCallbacks& calls);

  /// Adds a viewer of a key: a panel, or the live detection.
  void subscribe(const std::string& key, std::size_t viewer);
  void unsubscribe(const std::string& key, std::size_t viewer);
  /// Starts live detection for a panel.
  void watch(std::size_t panel);
  void unwatch(std::size_t panel);
  void requestKeys(const std::string& mount) { mounts_.request(mount); }
  /// `settings`: [{"mp", "key", "value"}]; a single one of naocal.access is the secret and is sent after every
  /// reconnect. Throw InputError if the robot is not connected.
  void set(const nlohmann::json& settings);
  void save();
  /// Sends the current state to a new panel.
  void addPanel(std::size_t panel) const;
  /// The image of a capture ("SERIES/PLACE" in its list); absent if there is none.
  std::optional<std::string> takenPicture(std::string_view which) const;
  /// Removes a closed panel's subscriptions.
  void removePanel(std::size_t panel);

  /// Disconnects from the robot until `resume`.
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

  void followRuns(const nlohmann::json& list);

  std::string address_;
  const PanelCallbacks& calls_;
  Subscriptions viewers_;
  std::map<std::string, std::string> latest_; // last messages for new panels, by kind
  std::string latestRuns_;                    // last list of runs, to notice changes
  std::set<std::size_t> watchers_;            // panels with live detection
  CapturePictures taken_;                     // images of its calibration's captures
  std::unique_ptr<LiveDetection> watch_;      // created on first use
  MountRegistry mounts_{[this](const std::string& mount) { link_->askForKeys(mount); }};
  std::unique_ptr<RobotClient> link_;
};

/// The robots shown in panels, by address. A key is subscribed to while a panel shows it. After `patience` without an
/// open panel no Stop button exists: all robots are disconnected, which stops them by their last will, until a panel
/// opens.
class Robots {
public:
  static constexpr std::chrono::milliseconds defaultPatience{5000}; // allows reloading the page
  Robots(boost::asio::io_context& context, PanelCallbacks calls, std::chrono::milliseconds patience = defaultPatience);

  /// Throws InputError for an invalid address.
  void connect(const std::string& address);

  void disconnect(const std::string& address);
  /// nullptr if not connected.
  WatchedRobot* find(const std::string& address) const;
  /// Throws InputError if not connected; `verb`: the requested action.
  WatchedRobot& at(const std::string& address, const std::string& verb) const;

  std::vector<std::string> addresses() const;
  /// The image of a capture, "ROBOT/SERIES/PLACE"; absent if there is none.
  std::optional<std::string> takenPicture(std::string_view path) const;

  /// Registers a new panel and sends it the current state.
  void addPanel(std::size_t panel);
  /// Removes a closed panel.
  void removePanel(std::size_t panel);

private:
  boost::asio::io_context& context_;
  PanelCallbacks calls_;
  std::chrono::milliseconds patience_;
  std::set<std::size_t> panels_; // open ones
  boost::asio::steady_timer alone_;
  std::map<std::string, std::shared_ptr<WatchedRobot>> robots_;
};

} // namespace naocal
