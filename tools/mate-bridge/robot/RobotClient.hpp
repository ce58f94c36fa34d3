#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>

namespace boost::asio {
class io_context;
}

namespace naocal {

/// Address of a robot's sockets: "nao21", "10.1.24.31:12440" (base port; debug is one above, configuration two), or a
/// folder with the UNIX sockets `debug` and `config`.
struct RobotAddress {
  std::string host;             // empty: UNIX sockets
  std::uint16_t basePort = 0;   // [1, 65533]
  std::filesystem::path folder; // of UNIX sockets
};

/// Throws InputError that gives the expected format.
RobotAddress parseRobotAddress(const std::string& address);

/// Delays requests for a mount's keys until the robot has listed the mount: HULKs' own service crashes on an unknown
/// mount name.
class MountRegistry {
public:
  explicit MountRegistry(std::function<void(const std::string& mount)> ask) : ask_{std::move(ask)} {}

  /// Requests the keys now, or as soon as the mount is listed.
  void request(const std::string& mount);
  /// Handles the robot's list: {"keys": [{"key": mount}]}. Throws Json::exception for an invalid list.
  void onListed(const nlohmann::json& told);
  /// Resets the state after a disconnect: another robot or program may answer next.
  void forget();

private:
  std::function<void(const std::string& mount)> ask_;
  std::set<std::string> listed_, wanted_;
};

/// Receives a robot's messages: unparsed bodies, JSON unless noted.
struct RobotCallbacks {
  std::function<void()> changed; // connected or disconnected: see `sentence`
  std::function<void(const std::string&body)> list, update, mounts, keys;
  std::function<void(const std::string& body)> picture; // body of an IMAGE frame
};

/// A robot's two sockets: connects, requests the lists, and after a failure reconnects once per second and renews all
/// subscriptions. Runs on the context's thread only.
class RobotClient {
public:
  /// Throws InputError for an invalid address.
  RobotClient(boost::asio::io_context& context, const std::string& address, RobotCallbacks calls);
  ~RobotClient();

  bool isConnected() const;
  /// State for display: "connected", "connecting", or the problem.
  const std::string& sentence() const;

  void subscribe(const std::string& key);
  void unsubscribe(const std::string& key);
  void askForKeys(const std::string& mount);
  /// `settings`: [{"mp": .., "key": .., "value": ..}]. False if not connected; nothing was sent.
  bool set(const std::string& settings);
  bool save();
  /// Sends `settings` (the secret) now and first after every reconnect, until the robot closes a connection because of
  /// them.
  bool authenticate(const std::string& settings);

  /// Closes both connections until `resume`, so that the robot applies its last will.
  void suspend();
  void resume();

private:
  class Implementation;
  std::shared_ptr<Implementation> implementation_;
};

} // namespace naocal
