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

/// Where a robot's sockets are: "nao21", "10.1.24.31:12440" (base port; debug is one above, configuration two), or a
/// folder with the UNIX sockets `debug` and `config`.
struct RobotAddress {
  std::string host;             // empty: UNIX sockets
  std::uint16_t basePort = 0;   // [1, 65533]
  std::filesystem::path folder; // of UNIX sockets
};

/// Throws InputError that says what is expected.
RobotAddress parseRobotAddress(const std::string& address);

/// Which of a robot's mounts may be asked for their keys. HULKs' own service ends at the name of a mount that it does
/// not have, so that a question waits until the robot has listed its mount.
class MountRegistry {
public:
  explicit MountRegistry(std::function<void(const std::string& mount)> ask) : ask_{std::move(ask)} {}

  /// Asks now, or once the mount is listed.
  void request(const std::string& mount);
  /// The robot's list: {"keys": [{"key": mount}]}. Throws Json::exception for anything else.
  void onListed(const nlohmann::json& told);
  /// It may be another robot, or another program on it, that comes back.
  void forget();

private:
  std::function<void(const std::string& mount)> ask_;
  std::set<std::string> listed_, wanted_;
};

/// What a robot tells; bodies as they came, JSON where it should be.
struct RobotCallbacks {
  std::function<void()> changed; // connected, or not any more: `sentence` says why
  std::function<void(const std::string&body)> list, update, mounts, keys;
  std::function<void(const std::string& body)> picture; // an IMAGE's body
};

/// A robot's two sockets: connects, asks what there is, and when they break says why and connects anew after a second,
/// with everything that was subscribed to. All on the thread that runs the context.
class RobotClient {
public:
  /// Throws InputError for an address that cannot be one.
  RobotClient(boost::asio::io_context& context, const std::string& address, RobotCallbacks calls);
  ~RobotClient();

  bool isConnected() const;
  /// How it stands, for people: "connected", "connecting", or what went wrong.
  const std::string& sentence() const;

  void subscribe(const std::string& key);
  void unsubscribe(const std::string& key);
  void askForKeys(const std::string& mount);
  /// `settings`: [{"mp": .., "key": .., "value": ..}]. False: not connected, so nothing was sent.
  bool set(const std::string& settings);
  bool save();
  /// The same settings again whenever it connects anew, before anything else, until a robot ends the connection for
  /// them: its secret.
  bool authenticate(const std::string& settings);

  /// Ends both connections, so that the robot does what was left with it as a last will, until `wake`.
  void suspend();
  void resume();

private:
  class Implementation;
  std::shared_ptr<Implementation> implementation_;
};

} // namespace naocal
