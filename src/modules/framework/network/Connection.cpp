#include "framework/network/Connection.hpp"

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/read.hpp>
#include <fmt/format.h>

namespace naocal {

using boost::system::error_code;

Connection::Connection(Socket socket, std::string address, Protocol& protocol, const ClientLimits& limits, Log log,
                       Ended ended)
    : socket_{std::move(socket)}, address_{std::move(address)}, protocol_{protocol}, limits_{limits},
      log_{std::move(log)}, ended_{std::move(ended)}, allowance_{2 * limits.messagesPerSecond} {}

void Connection::start() {
  error_code ignored; // a closed socket reports its error when it is read
  socket_.non_blocking(true, ignored);
  protocol_.onOpened(*this);
  readHeader();
}

void Connection::end() {
  if (!open_) {
    return;
  }
  open_ = false;
  protocol_.onClosed(*this);
  error_code ignored;
  socket_.close(ignored);
  ended_(*this);
}

void Connection::refuse(const std::string& sentence) {
  if (!open_) {
    return;
  }
  log_(fmt::format("Client {}: {}; the connection was closed.", address_.empty() ? "on this computer" : address_,
                   sentence));
  end();
}

void Connection::readFailed(const error_code& error) {
  if (error == boost::asio::error::eof || error == boost::asio::error::connection_reset) {
    return end(); // regular end of the connection
  }
  refuse("cannot be read from: " + error.message());
}

void Connection::readHeader() {
  header_.resize(protocol_.format().headerSize);
  boost::asio::async_read(socket_, boost::asio::buffer(header_), [self = self()](const error_code& error, std::size_t) {
    if (error) {
      return self->readFailed(error);
    }
    const FrameFormat& format = self->protocol_.format();
    const std::uint32_t maxBodyBytes = self->limits_.maxBodyBytes;
    const FrameHeader header = parseHeader(format, self->header_, maxBodyBytes);
    if (const std::string refusal = describeProblem(header, format, maxBodyBytes); !refusal.empty()) {
      return self->refuse(refusal);
    }
    self->readBody(header.type, header.bodySize);
  });
}

void Connection::readBody(std::uint8_t type, std::uint32_t size) {
  body_.resize(size);
  boost::asio::async_read(socket_, boost::asio::buffer(body_),
                          [self = self(), type](const error_code& error, std::size_t) {
                            if (error) {
                              return self->readFailed(error);
                            }
                            self->handle(type);
                          });
}

void Connection::handle(std::uint8_t type) {
  if (!open_) {
    return; // the connection ended after this frame was read
  }
  if (tooFast()) {
    return refuse(fmt::format("expected at most {:.0f} messages per second, found more", limits_.messagesPerSecond));
  }
  hasSpoken_ = true;
  attempt([&] {
    protocol_.onReceived(*this, type, std::move(body_));
    return open_ && protocol_.continueMessage(*this);
  });
}

void Connection::continueMessage() {
  if (open_) {
    attempt([this] { return protocol_.continueMessage(*this); });
  }
}

/// Runs `work`, which returns whether more of the message remains, and reads on after the whole message.
void Connection::attempt(const std::function<bool()>& work) {
  bool remains = false;
  try {
    remains = work();
  } catch (const ProtocolError& error) {
    return refuse(error.what());
  }
  if (remains) {
    boost::asio::post(socket_.get_executor(), [self = self()] { self->continueMessage(); });
  } else if (open_) {
    body_.clear();
    readHeader();
  }
}

bool Connection::hasDataWaiting() const {
  error_code ignored;
  return socket_.available(ignored) > 0;
}

void Connection::closeIfSilent(TimePoint now) {
  const Duration silence = now - lastMessage_;
  if (!hasSpoken_ && silence >= limits_.firstMessage) {
    refuse(fmt::format("expected a first message within {:g} s, found none", toSeconds(limits_.firstMessage)));
  } else if (hasSpoken_ && silence >= limits_.rest && !protocol_.mayBeSilent(*this)) {
    refuse(fmt::format("expected a message within {:g} s of one that wants nothing from the robot, found none",
                       toSeconds(limits_.rest)));
  }
}

bool Connection::tooFast() {
  const TimePoint now = Clock::now();
  allowance_ += toSeconds(now - lastMessage_) * limits_.messagesPerSecond;
  allowance_ = std::min(allowance_, 2 * limits_.messagesPerSecond) - 1;
  lastMessage_ = now;
  return allowance_ < 0;
}

void Connection::send(std::shared_ptr<const std::string> bytes) {
  if (!open_) {
    return;
  }
  pendingBytes_ += bytes->size();
  queue_.push_back(std::move(bytes));
  if (queue_.size() == 1) {
    write();
  } else if (pendingBytes_ > limits_.maxPendingBytes) {
    boost::asio::post(socket_.get_executor(),
                      [self = self()] { self->refuse("asks for answers and does not read them"); });
  }
}

void Connection::write() {
  while (!queue_.empty()) {
    error_code error; // writes synchronously first: a client whose data the system accepts at once never counts as busy
    written_ += socket_.write_some(boost::asio::buffer(*queue_.front()) + written_, error);
    if (error && error != boost::asio::error::would_block && error != boost::asio::error::interrupted) {
      boost::asio::post(socket_.get_executor(), [self = self(), error] {
        self->refuse("what is sent to it cannot be written: " + error.message());
      });
      return;
    }
    if (written_ < queue_.front()->size()) {
      return writeWhenPossible();
    }
    pendingBytes_ -= queue_.front()->size();
    queue_.pop_front();
    written_ = 0;
  }
}

void Connection::writeWhenPossible() {
  socket_.async_wait(Socket::wait_write, [self = self()](const error_code& error) {
    if (!error && self->open_) {
      self->write();
    }
  });
}

} // namespace naocal
