#include "RobotLink.hpp"

#include "RobotSocket.hpp"

#include <set>

namespace naocal {

namespace {

constexpr std::chrono::milliseconds pauseBetweenTries{1000}, heartbeat{2000}, longestSilence{6000};

std::string debugFrame(DebugFrame type, std::string_view body = {}) {
  return robotFrame(debugFrames, static_cast<std::uint8_t>(type), body);
}
std::string configFrame(ConfigFrame type, std::string_view body = {}) {
  return robotFrame(configFrames, static_cast<std::uint8_t>(type), body);
}

} // namespace

struct RobotLink::Implementation : std::enable_shared_from_this<Implementation> {
  Implementation(boost::asio::io_context& given, const std::string& address, RobotCalls toCall)
      : context{given}, place{robotPlace(address)}, calls{std::move(toCall)}, timer{given} {}

  void connect() {
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
    debug = std::make_shared<RobotSocket>(
        context, debugFrames,
        RobotSocket::Calls{opened, guarded([](Implementation& self, std::uint8_t type, const std::string& body) {
                             self.debugSaid(static_cast<DebugFrame>(type), body);
                           }),
                           ended});
    config = std::make_shared<RobotSocket>(
        context, configFrames,
        RobotSocket::Calls{opened, guarded([](Implementation& self, std::uint8_t type, const std::string& body) {
                             self.configSaid(static_cast<ConfigFrame>(type), body);
                           }),
                           ended});
    missing = 2;
    debug->connect(place, 1, "debug");
    config->connect(place, 2, "config");
  }

  void opened() {
    if (--missing > 0) {
      return;
    }
    sentence = "connected";
    heard = std::chrono::steady_clock::now();
    debug->send(debugFrame(DebugFrame::requestList));
    config->send(configFrame(ConfigFrame::getMounts));
    for (const std::string& key : keys) {
      debug->send(debugFrame(DebugFrame::subscribe, key));
    }
    listen();
    calls.changed();
  }

  /// A robot whose cable was pulled says nothing: now and then it is asked for a word.
  void listen() {
    timer.expires_after(heartbeat);
    timer.async_wait([weak = weak_from_this()](boost::system::error_code stopped) {
      const auto self = weak.lock();
      if (stopped || !self || self->missing > 0) {
        return;
      }
      const auto silence = std::chrono::steady_clock::now() - self->heard;
      if (silence > longestSilence) {
        self->ended("has been silent for 6 s");
        return;
      }
      if (silence > heartbeat / 2) {
        self->debug->send(debugFrame(DebugFrame::requestList));
      }
      self->listen();
    });
  }

  void ended(const std::string& why) {
    missing = 2;
    debug->drop();
    config->drop();
    const bool news = sentence != why;
    sentence = why;
    timer.expires_after(pauseBetweenTries);
    timer.async_wait([weak = weak_from_this()](boost::system::error_code stopped) {
      if (const auto self = weak.lock(); self && !stopped) {
        self->connect();
      }
    });
    if (news) {
      calls.changed();
    }
  }

  void debugSaid(DebugFrame type, const std::string& body) {
    heard = std::chrono::steady_clock::now();
    if (type == DebugFrame::update) {
      calls.update(body);
    } else if (type == DebugFrame::list) {
      calls.list(body);
    } else if (type == DebugFrame::image) {
      calls.picture(body);
    }
  }

  void configSaid(ConfigFrame type, const std::string& body) const {
    if (type == ConfigFrame::sendMounts) {
      calls.mounts(body);
    } else if (type == ConfigFrame::sendKeys) {
      calls.keys(body);
    }
  }

  bool connected() const { return missing == 0; }

  boost::asio::io_context& context;
  RobotPlace place;
  RobotCalls calls;
  boost::asio::steady_timer timer;
  std::shared_ptr<RobotSocket> debug, config;
  int missing = 2; // sockets that are not connected
  std::string sentence = "connecting";
  std::chrono::steady_clock::time_point heard;
  std::set<std::string> keys; // subscribed to
};

RobotLink::RobotLink(boost::asio::io_context& context, const std::string& address, RobotCalls calls)
    : implementation_{std::make_shared<Implementation>(context, address, std::move(calls))} {
  implementation_->connect();
}

RobotLink::~RobotLink() {
  implementation_->timer.cancel();
  implementation_->debug->drop();
  implementation_->config->drop();
}

bool RobotLink::connected() const {
  return implementation_->connected();
}

const std::string& RobotLink::sentence() const {
  return implementation_->sentence;
}

void RobotLink::subscribe(const std::string& key) {
  if (implementation_->keys.insert(key).second && connected()) {
    implementation_->debug->send(debugFrame(DebugFrame::subscribe, key));
  }
}

void RobotLink::unsubscribe(const std::string& key) {
  if (implementation_->keys.erase(key) > 0 && connected()) {
    implementation_->debug->send(debugFrame(DebugFrame::unsubscribe, key));
  }
}

void RobotLink::askForKeys(const std::string& mount) {
  if (connected()) {
    implementation_->config->send(configFrame(ConfigFrame::getKeys, mount));
  }
}

bool RobotLink::set(const std::string& settings) {
  if (connected()) {
    implementation_->config->send(configFrame(ConfigFrame::set, settings));
    implementation_->config->send(configFrame(ConfigFrame::getMounts)); // a secret may have opened them
  }
  return connected();
}

bool RobotLink::save() {
  if (connected()) {
    implementation_->config->send(configFrame(ConfigFrame::save));
  }
  return connected();
}

} // namespace naocal
