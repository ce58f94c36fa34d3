#pragma once

#include "RobotFrames.hpp"
#include "RobotPlace.hpp"

#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <functional>
#include <memory>

/// Heavy (Boost.Asio): included by RobotSocket.cpp and RobotClient.cpp only.
namespace naocal {

/// One of a robot's two sockets: connects, cuts what comes into frames, sends frames. Ends once, with a sentence.
class RobotSocket : public std::enable_shared_from_this<RobotSocket> {
public:
  struct Calls {
    std::function<void()> connected;
    std::function<void(std::uint8_t type, std::string body)> received;
    std::function<void(const std::string& sentence)> ended; // without the robot's name: "refused the connection"
  };
  RobotSocket(boost::asio::io_context& context, const RobotFormat& format, Calls calls);

  /// `offset`: of the TCP port above the base port; `name`: of the UNIX socket.
  void connect(const RobotPlace& place, std::uint16_t offset, const std::string& name);
  void send(std::string frame);
  /// Ends without a call.
  void drop();

private:
  using Socket = boost::asio::generic::stream_protocol::socket;
  void connectTo(const Socket::endpoint_type& endpoint);
  void readHeader();
  void readBody(std::uint8_t type, std::size_t size);
  void write();
  void end(const std::string& sentence);

  const RobotFormat& format_;
  Calls calls_;
  Socket socket_;
  boost::asio::ip::tcp::resolver resolver_;
  boost::asio::steady_timer patience_;
  bool open_ = true;
  std::string header_, body_;
  std::deque<std::string> queue_; // the first is being written
};

} // namespace naocal
