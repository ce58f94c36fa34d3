#pragma once

#include "Server.hpp"

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <deque>

/// Heavy (Boost.Beast): included by Live.cpp and Server.cpp only.
namespace naocal {

/// One panel's live connection. Never waits for a slow panel: pictures and live values skip it, and one that does not
/// read what it must have is closed (it connects anew and gets everything).
class Live : public std::enable_shared_from_this<Live> {
public:
  using Closed = std::function<void()>;
  using Received = std::function<void(std::string)>;

  Live(boost::beast::tcp_stream stream, Received received, Closed closed);

  void accept(const boost::beast::http::request<boost::beast::http::empty_body>& request, std::function<void()> opened);
  void send(const Message& message);
  void end();

private:
  void read();
  void write();

  boost::beast::websocket::stream<boost::beast::tcp_stream> socket_;
  Received received_;
  Closed closed_;
  boost::beast::flat_buffer buffer_;
  std::deque<Message> queue_; // the first is being written
  std::size_t owed_ = 0;      // [bytes]
  bool open_ = true;
};

} // namespace naocal
