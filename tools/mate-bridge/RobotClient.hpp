#pragma once

#include <functional>
#include <memory>
#include <string>

namespace boost::asio {
class io_context;
}

namespace naocal {

class RobotConversation;

/// What a robot tells; bodies as they came, JSON where it should be.
struct RobotCalls {
  std::function<void()> changed; // connected, or not any more: `sentence` says why
  std::function<void(const std::string&body)> list, update, mounts, keys;
  std::function<void(const std::string& body)> picture; // an IMAGE's body
};

/// A robot's two sockets: connects, asks what there is, and when they break says why and connects anew after a second,
/// with everything that was subscribed to. All on the thread that runs the context.
class RobotClient {
public:
  /// Throws InputError for an address that cannot be one (RobotPlace.hpp).
  RobotClient(boost::asio::io_context& context, const std::string& address, RobotCalls calls);
  ~RobotClient();

  bool connected() const;
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
  bool introduce(const std::string& settings);

  /// Ends both connections, so that the robot does what was left with it as a last will, until `wake`.
  void rest();
  void wake();

private:
  std::shared_ptr<RobotConversation> conversation_;
};

} // namespace naocal
