#include "robot/RobotClient.hpp"

#include "io/InputError.hpp"
#include "protocol/Frames.hpp"

#include <boost/asio/error.hpp>
#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <charconv>
#include <deque>
#include <fmt/format.h>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

namespace naocal {

RobotAddress parseRobotAddress(const std::string& address) {
  constexpr std::uint16_t usual = 12440;
  if (address.starts_with('/')) {
    return {"", 0, address};
  }
  const std::size_t colon = address.find(':');
  RobotAddress place{address.substr(0, colon), usual, ""};
  bool good = !place.host.empty() && place.host.find_first_of(" \t\r\n/@") == std::string::npos;
  if (colon != std::string::npos) {
    const char *const first = address.data() + colon + 1, *const last = address.data() + address.size();
    const auto [end, error] = std::from_chars(first, last, place.basePort);
    good = good && error == std::errc{} && end == last && place.basePort >= 1 && place.basePort <= 65533;
  }
  if (!good) {
    throw InputError{fmt::format("expected a robot's name or IPv4 address, HOST:PORT with its base port, or the folder "
                                 "of its UNIX sockets beginning with /; found \"{}\"",
                                 address)};
  }
  return place;
}

void MountRegistry::request(const std::string& mount) {
  listed_.contains(mount) ? ask_(mount) : void(wanted_.insert(mount));
}

void MountRegistry::onListed(const nlohmann::json& told) {
  listed_.clear();
  for (const nlohmann::json& mount : told.at("keys")) {
    listed_.insert(mount.at("key").get<std::string>());
  }
  for (const std::string& mount : std::exchange(wanted_, {})) {
    request(mount);
  }
}

void MountRegistry::forget() {
  listed_.clear();
  wanted_.clear();
}

namespace {

constexpr std::chrono::milliseconds pauseBetweenTries{1000}, heartbeat{2000}, longestSilence{6000};

/// Largest body accepted from a robot: a list of all keys with their values, or an image [bytes].
constexpr std::uint32_t maxBodyBytes = 32 << 20;

/// The problem of a frame header, without the robot's name; empty if valid.
std::string describeRobotProblem(const FrameHeader& header, const FrameFormat& format) {
  switch (header.problem) {
  case FrameProblem::magic:
    return fmt::format("does not speak HULKs' protocol (expected a frame that begins with {})", format.magic);
  case FrameProblem::version:
    return fmt::format("speaks another version of HULKs' protocol (expected {}, found {})", format.version,
                       header.version);
  case FrameProblem::size:
    return fmt::format("announced a frame of {} bytes; at most {} are taken", header.bodySize, maxBodyBytes);
  case FrameProblem::none:
    break;
  }
  return "";
}

/// One of a robot's two sockets: connects, splits received bytes into frames, sends frames. Ends once, with a sentence.
class RobotSocket : public std::enable_shared_from_this<RobotSocket> {
public:
  struct Callbacks {
    std::function<void()> connected;
    std::function<void(std::uint8_t type, std::string body)> received;
    std::function<void(const std::string& sentence)> ended; // without the robot's name: "refused the connection"
  };
  RobotSocket(boost::asio::io_context& context, const FrameFormat& format, Callbacks calls);

  /// `offset`: TCP port above the base port; `name`: of the UNIX socket.
  void connect(const RobotAddress& place, std::uint16_t offset, const std::string& name);
  void send(std::string frame);
  /// Closes without calling `ended`.
  void drop();
  /// Whether the robot closed the connection, rather than the network or this side.
  bool wasClosedByRobot() const { return closedByRobot_; }

private:
  using Socket = boost::asio::generic::stream_protocol::socket;
  void connectTo(const Socket::endpoint_type& endpoint);
  void readHeader();
  void readBody(std::uint8_t type, std::size_t size);
  void write();
  void end(const std::string& sentence);
  void end(const boost::system::error_code& error, const std::string& sentence);

  const FrameFormat& format_;
  Callbacks calls_;
  Socket socket_;
  boost::asio::ip::tcp::resolver resolver_;
  boost::asio::steady_timer patience_;
  bool open_ = true, closedByRobot_ = false;
  std::string header_, body_;
  std::deque<std::string> queue_; // the front is being written
};

using Error = boost::system::error_code;

RobotSocket::RobotSocket(boost::asio::io_context& context, const FrameFormat& format, Callbacks calls)
    : format_{format}, calls_{std::move(calls)}, socket_{context}, resolver_{context}, patience_{context} {}

void RobotSocket::connect(const RobotAddress& place, std::uint16_t offset, const std::string& name) {
  patience_.expires_after(std::chrono::seconds{3});
  patience_.async_wait([self = shared_from_this()](Error stopped) {
    if (!stopped) {
      self->end("did not answer within 3 s");
    }
  });
  if (place.host.empty()) {
    const std::string path = (place.folder / name).string();
    constexpr std::size_t longest = 107; // of a UNIX socket path (sockaddr_un)
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
    Error isLocal;
    self->socket_.set_option(boost::asio::ip::tcp::no_delay{true}, isLocal); // no request waits for acknowledgments
    self->patience_.cancel();
    self->calls_.connected();
    self->readHeader();
  });
}

void RobotSocket::readHeader() {
  header_.resize(format_.headerSize);
  boost::asio::async_read(socket_, boost::asio::buffer(header_), [self = shared_from_this()](Error error, std::size_t) {
    if (error) {
      self->end(error, "closed the connection");
      return;
    }
    const FrameHeader header = parseHeader(self->format_, self->header_, maxBodyBytes);
    if (header.problem != FrameProblem::none) {
      self->end(describeRobotProblem(header, self->format_));
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
                              self->end(error, "closed the connection in the middle of a frame");
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
                               self->end(error, "closed the connection");
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

void RobotSocket::end(const Error& error, const std::string& sentence) {
  if (open_) {
    closedByRobot_ = error == boost::asio::error::eof || error == boost::asio::error::connection_reset ||
                     error == boost::asio::error::broken_pipe;
  }
  end(sentence);
}

void RobotSocket::drop() {
  open_ = false;
  patience_.cancel();
  resolver_.cancel();
  Error ignored;
  socket_.close(ignored);
}

} // namespace

/// Connection state of a RobotClient.
class RobotClient::Implementation : public std::enable_shared_from_this<Implementation> {
public:
  Implementation(boost::asio::io_context& context, const std::string& address, RobotCallbacks calls);

  void connect();
  void drop();
  void suspend();
  void resume();
  bool isConnected() const { return missing_ == 0; }
  const std::string& sentence() const { return sentence_; }

  void subscribe(const std::string& key);
  void unsubscribe(const std::string& key);
  bool authenticate(const std::string& settings);
  /// False if not connected; nothing was sent.
  bool send(ConfigType type, std::string_view body = {});

private:
  void opened();
  void listen();
  void ended(const std::string& why);
  void debugSaid(DebugType type, const std::string& body);
  void configSaid(ConfigType type, const std::string& body);

  boost::asio::io_context& context_;
  RobotAddress place_;
  RobotCallbacks calls_;
  boost::asio::steady_timer timer_;
  std::shared_ptr<RobotSocket> debug_, config_;
  int missing_ = 2; // sockets not connected yet
  bool rests_ = false;
  std::string sentence_ = "connecting";
  std::chrono::steady_clock::time_point heard_;
  std::set<std::string> keys_; // subscriptions
  std::string introduction_;   // settings sent first after connecting
  bool isWelcome_ = false;     // the robot has listed its mounts on this connection
};

RobotClient::Implementation::Implementation(boost::asio::io_context& context, const std::string& address,
                                            RobotCallbacks calls)
    : context_{context}, place_{parseRobotAddress(address)}, calls_{std::move(calls)}, timer_{context} {}

void RobotClient::Implementation::connect() {
  const std::weak_ptr<Implementation> weak = weak_from_this();
  const auto guarded = [weak](auto action) {
    return [weak, action](auto&&... given) {
      if (const auto self = weak.lock()) {
        action(*self, std::forward<decltype(given)>(given)...);
      }
    };
  };
  const auto opened = guarded([](Implementation& self) { self.opened(); });
  const auto ended = guarded([](Implementation& self, const std::string& why) { self.ended(why); });
  debug_ = std::make_shared<RobotSocket>(
      context_, debugFormat,
      RobotSocket::Callbacks{opened, guarded([](Implementation& self, std::uint8_t type, const std::string& body) {
                               self.debugSaid(static_cast<DebugType>(type), body);
                             }),
                             ended});
  config_ = std::make_shared<RobotSocket>(
      context_, configFormat,
      RobotSocket::Callbacks{opened, guarded([](Implementation& self, std::uint8_t type, const std::string& body) {
                               self.configSaid(static_cast<ConfigType>(type), body);
                             }),
                             ended});
  missing_ = 2;
  debug_->connect(place_, 1, "debug");
  config_->connect(place_, 2, "config");
}

void RobotClient::Implementation::opened() {
  if (--missing_ > 0) {
    return;
  }
  sentence_ = "connected";
  heard_ = std::chrono::steady_clock::now();
  isWelcome_ = false;
  if (!introduction_.empty()) {
    config_->send(encodeConfigFrame(ConfigType::set, introduction_));
  }
  debug_->send(encodeDebugFrame(DebugType::requestList));
  config_->send(encodeConfigFrame(ConfigType::getMounts));
  for (const std::string& key : keys_) {
    debug_->send(encodeDebugFrame(DebugType::subscribe, key));
  }
  listen();
  calls_.changed();
}

/// Keep-alive: requests LIST after 1 s without traffic; drops the connection after 6 s.
void RobotClient::Implementation::listen() {
  timer_.expires_after(heartbeat);
  timer_.async_wait([weak = weak_from_this()](boost::system::error_code stopped) {
    const auto self = weak.lock();
    if (stopped || !self || self->missing_ > 0) {
      return;
    }
    const auto silence = std::chrono::steady_clock::now() - self->heard_;
    if (silence > longestSilence) {
      self->ended("has been silent for 6 s");
      return;
    }
    if (silence > heartbeat / 2) {
      self->debug_->send(encodeDebugFrame(DebugType::requestList));
    }
    self->listen();
  });
}

void RobotClient::Implementation::ended(const std::string& why) {
  if (missing_ == 0 && !isWelcome_ && config_->wasClosedByRobot()) {
    introduction_.clear(); // rejected; a network that fails does not mean that
  }
  missing_ = 2;
  debug_->drop();
  config_->drop();
  const bool news = sentence_ != why;
  sentence_ = why;
  timer_.expires_after(pauseBetweenTries);
  timer_.async_wait([weak = weak_from_this()](boost::system::error_code stopped) {
    if (const auto self = weak.lock(); self && !stopped && !self->rests_) {
      self->connect();
    }
  });
  if (news) {
    calls_.changed();
  }
}

void RobotClient::Implementation::debugSaid(DebugType type, const std::string& body) {
  heard_ = std::chrono::steady_clock::now();
  if (type == DebugType::update) {
    calls_.update(body);
  } else if (type == DebugType::list) {
    calls_.list(body);
  } else if (type == DebugType::image) {
    calls_.picture(body);
  }
}

void RobotClient::Implementation::configSaid(ConfigType type, const std::string& body) {
  if (type == ConfigType::sendMounts) {
    isWelcome_ = isWelcome_ || body.find("\"key\"") != body.npos;
    calls_.mounts(body);
  } else if (type == ConfigType::sendKeys) {
    calls_.keys(body);
  }
}

void RobotClient::Implementation::drop() {
  timer_.cancel();
  debug_->drop();
  config_->drop();
}

void RobotClient::Implementation::suspend() {
  drop();
  rests_ = true;
  missing_ = 2;
  sentence_ = "was left alone, as no panel was open";
  calls_.changed();
}

void RobotClient::Implementation::resume() {
  if (std::exchange(rests_, false)) {
    sentence_ = "connecting";
    connect();
  }
}

void RobotClient::Implementation::subscribe(const std::string& key) {
  if (keys_.insert(key).second && isConnected()) {
    debug_->send(encodeDebugFrame(DebugType::subscribe, key));
  }
}

void RobotClient::Implementation::unsubscribe(const std::string& key) {
  if (keys_.erase(key) > 0 && isConnected()) {
    debug_->send(encodeDebugFrame(DebugType::unsubscribe, key));
  }
}

bool RobotClient::Implementation::authenticate(const std::string& settings) {
  introduction_ = settings;
  return send(ConfigType::set, settings) && send(ConfigType::getMounts);
}

bool RobotClient::Implementation::send(ConfigType type, std::string_view body) {
  if (isConnected()) {
    config_->send(encodeConfigFrame(type, body));
  }
  return isConnected();
}

RobotClient::RobotClient(boost::asio::io_context& context, const std::string& address, RobotCallbacks calls)
    : implementation_{std::make_shared<Implementation>(context, address, std::move(calls))} {
  implementation_->connect();
}

RobotClient::~RobotClient() {
  implementation_->drop();
}

bool RobotClient::isConnected() const {
  return implementation_->isConnected();
}

const std::string& RobotClient::sentence() const {
  return implementation_->sentence();
}

void RobotClient::subscribe(const std::string& key) {
  implementation_->subscribe(key);
}

void RobotClient::unsubscribe(const std::string& key) {
  implementation_->unsubscribe(key);
}

void RobotClient::askForKeys(const std::string& mount) {
  implementation_->send(ConfigType::getKeys, mount);
}

bool RobotClient::set(const std::string& settings) {
  return implementation_->send(ConfigType::set, settings);
}

bool RobotClient::authenticate(const std::string& settings) {
  return implementation_->authenticate(settings);
}

void RobotClient::suspend() {
  implementation_->suspend();
}

void RobotClient::resume() {
  implementation_->resume();
}

bool RobotClient::save() {
  return implementation_->send(ConfigType::save);
}

} // namespace naocal
