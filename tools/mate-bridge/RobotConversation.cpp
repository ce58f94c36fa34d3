#include "RobotConversation.hpp"

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

RobotConversation::RobotConversation(boost::asio::io_context& context, const std::string& address, RobotCalls calls)
    : context_{context}, place_{robotPlace(address)}, calls_{std::move(calls)}, timer_{context} {}

void RobotConversation::connect() {
  const std::weak_ptr<RobotConversation> weak = weak_from_this();
  const auto guarded = [weak](auto action) {
    return [weak, action](auto&&... given) {
      if (const auto self = weak.lock()) {
        action(*self, std::forward<decltype(given)>(given)...);
      }
    };
  };
  const auto opened = guarded([](RobotConversation& self) { self.opened(); });
  const auto ended = guarded([](RobotConversation& self, const std::string& why) { self.ended(why); });
  debug_ = std::make_shared<RobotSocket>(
      context_, debugFrames,
      RobotSocket::Calls{opened, guarded([](RobotConversation& self, std::uint8_t type, const std::string& body) {
                           self.debugSaid(static_cast<DebugFrame>(type), body);
                         }),
                         ended});
  config_ = std::make_shared<RobotSocket>(
      context_, configFrames,
      RobotSocket::Calls{opened, guarded([](RobotConversation& self, std::uint8_t type, const std::string& body) {
                           self.configSaid(static_cast<ConfigFrame>(type), body);
                         }),
                         ended});
  missing_ = 2;
  debug_->connect(place_, 1, "debug");
  config_->connect(place_, 2, "config");
}

void RobotConversation::opened() {
  if (--missing_ > 0) {
    return;
  }
  sentence_ = "connected";
  heard_ = std::chrono::steady_clock::now();
  isWelcome_ = false;
  if (!introduction_.empty()) {
    config_->send(configFrame(ConfigFrame::set, introduction_));
  }
  debug_->send(debugFrame(DebugFrame::requestList));
  config_->send(configFrame(ConfigFrame::getMounts));
  for (const std::string& key : keys_) {
    debug_->send(debugFrame(DebugFrame::subscribe, key));
  }
  listen();
  calls_.changed();
}

/// A robot whose cable was pulled says nothing: now and then it is asked for a word.
void RobotConversation::listen() {
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
      self->debug_->send(debugFrame(DebugFrame::requestList));
    }
    self->listen();
  });
}

void RobotConversation::ended(const std::string& why) {
  if (missing_ == 0 && !isWelcome_) {
    introduction_.clear(); // the robot did not like it
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

void RobotConversation::debugSaid(DebugFrame type, const std::string& body) {
  heard_ = std::chrono::steady_clock::now();
  if (type == DebugFrame::update) {
    calls_.update(body);
  } else if (type == DebugFrame::list) {
    calls_.list(body);
  } else if (type == DebugFrame::image) {
    calls_.picture(body);
  }
}

void RobotConversation::configSaid(ConfigFrame type, const std::string& body) {
  if (type == ConfigFrame::sendMounts) {
    isWelcome_ = isWelcome_ || body.find("\"key\"") != body.npos;
    calls_.mounts(body);
  } else if (type == ConfigFrame::sendKeys) {
    calls_.keys(body);
  }
}

void RobotConversation::drop() {
  timer_.cancel();
  debug_->drop();
  config_->drop();
}

void RobotConversation::rest() {
  drop();
  rests_ = true;
  missing_ = 2;
  sentence_ = "was left alone, as no panel was open";
  calls_.changed();
}

void RobotConversation::wake() {
  if (std::exchange(rests_, false)) {
    sentence_ = "connecting";
    connect();
  }
}

void RobotConversation::subscribe(const std::string& key) {
  if (keys_.insert(key).second && connected()) {
    debug_->send(debugFrame(DebugFrame::subscribe, key));
  }
}

void RobotConversation::unsubscribe(const std::string& key) {
  if (keys_.erase(key) > 0 && connected()) {
    debug_->send(debugFrame(DebugFrame::unsubscribe, key));
  }
}

bool RobotConversation::introduce(const std::string& settings) {
  introduction_ = settings;
  return say(ConfigFrame::set, settings) && say(ConfigFrame::getMounts);
}

bool RobotConversation::say(ConfigFrame type, std::string_view body) {
  if (connected()) {
    config_->send(configFrame(type, body));
  }
  return connected();
}

} // namespace naocal
