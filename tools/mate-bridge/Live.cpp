#include "Live.hpp"

#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

namespace naocal {

namespace {

constexpr std::size_t mostReceived = 1 << 20; // [bytes] of one message from a panel
constexpr std::size_t mostSkippable = 2 << 20, mostOwed = 256 << 20;

} // namespace

Live::Live(boost::beast::tcp_stream stream, Received received, Closed closed)
    : socket_{std::move(stream)}, received_{std::move(received)}, closed_{std::move(closed)} {}

void Live::accept(const boost::beast::http::request<boost::beast::http::empty_body>& request,
                  std::function<void()> opened) {
  boost::beast::get_lowest_layer(socket_).expires_never();
  socket_.set_option(
      boost::beast::websocket::stream_base::timeout::suggested(boost::beast::role_type::server)); // pings
  socket_.read_message_max(mostReceived);
  socket_.async_accept(request,
                       [self = shared_from_this(), opened = std::move(opened)](boost::beast::error_code error) {
                         if (error) {
                           self->end();
                           return;
                         }
                         opened();
                         self->read();
                       });
}

void Live::read() {
  socket_.async_read(buffer_, [self = shared_from_this()](boost::beast::error_code error, std::size_t) {
    if (error) {
      self->end();
      return;
    }
    std::string text = boost::beast::buffers_to_string(self->buffer_.data());
    self->buffer_.consume(self->buffer_.size());
    if (self->open_) {
      self->received_(std::move(text));
      self->read();
    }
  });
}

void Live::send(const Message& message) {
  if (!open_ || (message.skippable && owed_ > mostSkippable)) {
    return;
  }
  owed_ += message.bytes->size();
  if (owed_ > mostOwed) {
    end();
    return;
  }
  queue_.push_back(message);
  if (queue_.size() == 1) {
    write();
  }
}

void Live::write() {
  socket_.binary(queue_.front().binary);
  socket_.async_write(boost::asio::buffer(*queue_.front().bytes),
                      [self = shared_from_this()](boost::beast::error_code error, std::size_t) {
                        if (error) {
                          self->end();
                          return;
                        }
                        self->owed_ -= self->queue_.front().bytes->size();
                        self->queue_.pop_front();
                        if (!self->queue_.empty() && self->open_) {
                          self->write();
                        }
                      });
}

void Live::end() {
  if (open_) {
    open_ = false;
    boost::beast::get_lowest_layer(socket_).close();
    closed_();
  }
}

} // namespace naocal
