#include "Robots.hpp"

#include "Wire.hpp"

#include "io/InputError.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

Robots::Robots(boost::asio::io_context& context, RobotsCalls calls, std::chrono::milliseconds patience)
    : context_{context}, calls_{std::move(calls)}, patience_{patience}, alone_{context} {}

void Robots::connect(const std::string& address) {
  if (!robots_.contains(address)) {
    robots_[address] = std::make_shared<SeenRobot>(context_, address, calls_);
  }
}

void Robots::disconnect(const std::string& address) {
  if (robots_.erase(address) > 0) {
    calls_.all(wireText({{"kind", "robotGone"}, {"robot", address}}));
  }
}

bool Robots::asked(std::size_t panel, const nlohmann::json& request) {
  const std::string verb = request.at("do");
  if (verb == "connect") {
    connect(request.at("robot"));
    return true;
  }
  static const std::set<std::string> verbs{"disconnect", "subscribe", "unsubscribe", "watch",
                                           "unwatch",    "keys",      "set",         "save"};
  if (!verbs.contains(verb)) {
    return false;
  }
  const std::string address = request.at("robot");
  const auto found = robots_.find(address);
  if (found == robots_.end() && (verb == "unsubscribe" || verb == "unwatch")) {
    return true; // it went with its robot
  }
  if (found == robots_.end()) {
    throw InputError{fmt::format("there is no robot {} to {}; connect to it first", address, verb)};
  }
  verb == "disconnect" ? disconnect(address) : found->second->asked(panel, verb, request);
  return true;
}

std::vector<std::string> Robots::addresses() const {
  std::vector<std::string> all;
  for (const auto& [address, robot] : robots_) {
    all.push_back(address);
  }
  return all;
}

std::optional<std::string> Robots::takenPicture(std::string_view path) const {
  const std::size_t place = path.rfind('/');
  const std::size_t series = place == std::string_view::npos || place == 0 ? place : path.rfind('/', place - 1);
  if (series == std::string_view::npos) {
    return std::nullopt;
  }
  const auto found = robots_.find(std::string{path.substr(0, series)});
  return found == robots_.end() ? std::nullopt : found->second->takenPicture(path.substr(series + 1));
}

void Robots::greet(std::size_t panel) {
  panels_.insert(panel);
  for (const auto& [address, robot] : robots_) {
    robot->wake();
    robot->greet(panel);
  }
}

void Robots::forget(std::size_t panel) {
  for (const auto& [address, robot] : robots_) {
    robot->forget(panel);
  }
  if (panels_.erase(panel) == 0 || !panels_.empty()) {
    return;
  }
  alone_.expires_after(patience_);
  alone_.async_wait([this](boost::system::error_code stopped) {
    if (stopped || !panels_.empty()) {
      return;
    }
    for (const auto& [address, robot] : robots_) {
      robot->rest();
    }
  });
}

} // namespace naocal
