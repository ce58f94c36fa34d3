#include "RobotSocket.hpp"

#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <fmt/format.h>

namespace naocal {

using Error = boost::system::error_code;

RobotSocket::RobotSocket(boost::asio::io_context& context, const RobotFormat& format, Calls calls)
    : format_{format}, calls_{std::move(calls)}, socket_{context}, resolver_{context}, patience_{context} {}

void RobotSocket::connect(const RobotPlace& place, std::uint16_t offset, const std::string& name) {
  patience_.expires_after(std::chrono::seconds{3});
  patience_.async_wait([self = shared_from_this()](Error stopped) {
    if (!stopped) {
      self->end("did not answer within 3 s");
    }
  });
  if (place.host.empty()) {
    const std::string path = (place.folder / name).string();
    constexpr std::size_t longest = 107; // of a UNIX socket's path, sockaddr_un
    if (path.size() > longest) {
      boost::asio::post(socket_.get_executor(), [self = shared_from_this()] {
        self->end("has a socket whose path is longer than 107 letters, which no system opens");
      });
      return;
    }
    connectTo(boost::asio::local::stream_protocol::endpoint{path});
    return;
  }
  resolver_.async_resolve(boost::asio::ip::tcp::v4(), place.host, std::to_string(place.basePort + offset),
                          [self = shared_from_this()](Error error, const auto& found) {
                            if (error || found.empty()) {
                              self->end(fmt::format("was not found in the network ({})", error.message()));
                            } else {
                              self->connectTo(found.begin()->endpoint());
                            }
                          });
}

void RobotSocket::connectTo(const Socket::endpoint_type& endpoint) {
  if (!open_) {
    return;
  }
  socket_.async_connect(endpoint, [self = shared_from_this()](Error error) {
    if (!self->open_) {
      return;
    }
    if (error) {
      self->end(fmt::format("cannot be reached ({})", error.message()));
      return;
    }
    self->patience_.cancel();
    self->calls_.connected();
    self->readHeader();
  });
}

void RobotSocket::readHeader() {
  header_.resize(format_.headerSize);
  boost::asio::async_read(socket_, boost::asio::buffer(header_), [self = shared_from_this()](Error error, std::size_t) {
    if (error) {
      self->end("closed the connection");
      return;
    }
    const RobotHeader header = robotHeader(self->format_, self->header_);
    if (!header.problem.empty()) {
      self->end(header.problem);
    } else {
      self->readBody(header.type, header.bodySize);
    }
  });
}

void RobotSocket::readBody(std::uint8_t type, std::size_t size) {
  body_.resize(size);
  boost::asio::async_read(socket_, boost::asio::buffer(body_),
                          [self = shared_from_this(), type](Error error, std::size_t) {
                            if (error) {
                              self->end("closed the connection in the middle of a frame");
                              return;
                            }
                            self->calls_.received(type, std::exchange(self->body_, {}));
                            if (self->open_) {
                              self->readHeader();
                            }
                          });
}

void RobotSocket::send(std::string frame) {
  queue_.push_back(std::move(frame));
  if (queue_.size() == 1) {
    write();
  }
}

void RobotSocket::write() {
  boost::asio::async_write(socket_, boost::asio::buffer(queue_.front()),
                           [self = shared_from_this()](Error error, std::size_t) {
                             if (error) {
                               self->end("closed the connection");
                               return;
                             }
                             self->queue_.pop_front();
                             if (!self->queue_.empty() && self->open_) {
                               self->write();
                             }
                           });
}

void RobotSocket::end(const std::string& sentence) {
  if (open_) {
    drop();
    calls_.ended(sentence);
  }
}

void RobotSocket::drop() {
  open_ = false;
  patience_.cancel();
  resolver_.cancel();
  Error ignored;
  socket_.close(ignored);
}

} // namespace naocal
