#pragma once

#include "RobotClient.hpp"
#include "RobotSocket.hpp"

#include <set>

/// Heavy (Boost.Asio): included by RobotConversation.cpp and RobotClient.cpp only.
namespace naocal {

/// What goes on between a RobotClient and its robot.
class RobotConversation : public std::enable_shared_from_this<RobotConversation> {
public:
  RobotConversation(boost::asio::io_context& context, const std::string& address, RobotCalls calls);

  void connect();
  void drop();
  /// As RobotClient.
  void rest();
  void wake();
  bool connected() const { return missing_ == 0; }
  const std::string& sentence() const { return sentence_; }

  void subscribe(const std::string& key);
  void unsubscribe(const std::string& key);
  /// As RobotClient.
  bool introduce(const std::string& settings);
  /// False: not connected, so nothing was sent.
  bool say(ConfigFrame type, std::string_view body = {});

private:
  void opened();
  void listen();
  void ended(const std::string& why);
  void debugSaid(DebugFrame type, const std::string& body);
  void configSaid(ConfigFrame type, const std::string& body);

  boost::asio::io_context& context_;
  RobotPlace place_;
  RobotCalls calls_;
  boost::asio::steady_timer timer_;
  std::shared_ptr<RobotSocket> debug_, config_;
  int missing_ = 2; // sockets that are not connected
  bool rests_ = false;
  std::string sentence_ = "connecting";
  std::chrono::steady_clock::time_point heard_;
  std::set<std::string> keys_; // subscribed to
  std::string introduction_;   // settings that are sent first
  bool isWelcome_ = false;     // the robot has shown its mounts on this connection
};

} // namespace naocal
