#include "robot/Robots.hpp"

#include "io/InputError.hpp"
#include "protocol/BoundedJson.hpp"
#include "protocol/Frames.hpp"

#include <charconv>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

constexpr const char* runsKey = "Brain.calibrationRuns";
constexpr std::size_t theHistory = std::numeric_limits<std::size_t>::max() - 1; // viewer id of the record of runs
constexpr std::string_view capturesKey = "Brain.calibrationCaptures";
constexpr std::size_t theWatch = std::numeric_limits<std::size_t>::max(); // viewer id of the live detection

/// Parses a robot's message; null if it is not JSON.
Json parsed(const std::string& body) {
  try {
    return parseBoundedJson(body);
  } catch (const Json::exception&) {
    return nullptr;
  }
}

/// Runs an action that fails if a robot's values do not have naocal-robot's format; ignores that failure.
template <typename Action> void whereItFits(const Action& action) {
  try {
    action();
  } catch (const Json::exception&) {
  }
}

/// Throws InputError if nothing was sent.
void requireDone(bool isSent) {
  if (!isSent) {
    throw InputError{"the robot is not connected: nothing was changed; try again when it is back"};
  }
}

} // namespace

void Subscriptions::add(const std::string& key, std::size_t viewer) {
  viewers_[key].insert(viewer);
}

bool Subscriptions::remove(const std::string& key, std::size_t viewer) {
  const auto found = viewers_.find(key);
  if (found == viewers_.end() || found->second.erase(viewer) == 0 || !found->second.empty()) {
    return false;
  }
  viewers_.erase(found);
  return true;
}

std::vector<std::string> Subscriptions::forget(std::size_t viewer) {
  std::vector<std::string> keys, unseen;
  for (const auto& [key, viewers] : viewers_) {
    keys.push_back(key);
  }
  for (const std::string& key : keys) {
    if (remove(key, viewer)) {
      unseen.push_back(key);
    }
  }
  return unseen;
}

const std::set<std::size_t>& Subscriptions::subscribersOf(std::string_view key) const {
  static const std::set<std::size_t> none;
  const auto found = viewers_.find(key);
  return found == viewers_.end() ? none : found->second;
}

WatchedRobot::WatchedRobot(boost::asio::io_context& context, std::string address, const PanelCallbacks& calls)
    : address_{std::move(address)}, calls_{calls},
      link_{std::make_unique<RobotClient>(context, address_,
                                          RobotCallbacks{[this] { changed(); },
                                                         [this](const std::string& body) { listed("list", body); },
                                                         [this](const std::string& body) { updated(body); },
                                                         [this](const std::string& body) { listed("mounts", body); },
                                                         [this](const std::string& body) { listed("keys", body); },
                                                         [this](const std::string& body) { pictured(body); }})} {
  calls_.all(state());
}

std::string WatchedRobot::state() const {
  return jsonText({{"kind", "robot"},
                   {"robot", address_},
                   {"connected", link_ && link_->isConnected()},
                   {"sentence", link_ ? link_->sentence() : "connecting"}});
}

void WatchedRobot::changed() {
  mounts_.forget();
  if (!watchers_.empty()) {
    taken_.beginWatch(); // messages during the disconnect are unknown
    wantMounts();
  }
  calls_.all(state());
}

void WatchedRobot::listed(const std::string& kind, const std::string& body) {
  const Json told = parsed(body);
  if (kind == "keys" && watch_) {
    whereItFits([&] {
      if (told.at("mountPoint") == LiveDetection::boardsMount) {
        watch_->onConfiguration(told.at("keys"));
      } else if (told.at("mountPoint") == LiveDetection::offsetsMount) {
        watch_->onOffsets(told.at("keys"));
      }
    });
  }
  if (kind == "list") {
    whereItFits([&] { followRuns(told); });
  }
  if (kind == "mounts") {
    whereItFits([&] { mounts_.onListed(told); });
  }
  const std::string message = jsonText({{"kind", kind}, {"robot", address_}, {"body", told}});
  if (kind != "keys" && latest_[kind] == message) {
    return; // keep-alive reply without changes
  }
  latest_[kind] = message;
  calls_.all(message);
}

void WatchedRobot::updated(const std::string& body) {
  const Json values = parsed(body);
  std::map<std::size_t, Json> wanted; // by panel
  for (const Json& value : values.is_array() ? values : Json::array()) {
    if (!value.is_object() || !value.contains("key") || !value["key"].is_string()) {
      continue;
    }
    for (const std::size_t viewer : viewers_.subscribersOf(value["key"].get<std::string>())) {
      if (viewer == theHistory) {
        if (value.contains("value") && latestRuns_ != value["value"].dump()) {
          latestRuns_ = value["value"].dump();
          calls_.runs(address_, value["value"]);
        }
      } else if (viewer == theWatch) {
        whereItFits([&] {
          if (value["key"] != capturesKey) {
            watch_->onUpdate(value);
          } else if (taken_.onCaptures(value.at("value"), value.at("timestamp"))) {
            tellTaken();
          }
        });
      } else {
        wanted[viewer].push_back(value);
      }
    }
  }
  for (const auto& [panel, list] : wanted) {
    calls_.update(panel, jsonText({{"kind", "update"}, {"robot", address_}, {"values", list}}));
  }
}

void WatchedRobot::pictured(const std::string& body) {
  const auto picture = parseImageBody(body);
  if (!picture) {
    return;
  }
  const std::string head = jsonText({{"kind", "picture"},
                                     {"robot", address_},
                                     {"key", std::string{picture->key}},
                                     {"timestamp", picture->timestamp},
                                     {"width", picture->width},
                                     {"height", picture->height}});
  for (const std::size_t viewer : viewers_.subscribersOf(picture->key)) {
    if (viewer == theWatch) {
      if (taken_.onImage(LiveDetection::cameraOf(picture->key), picture->timestamp, picture->file)) {
        tellTaken();
      }
      watch_->onImage(std::string{picture->key}, picture->timestamp, static_cast<int>(picture->width),
                      static_cast<int>(picture->height), picture->file);
    } else {
      calls_.picture(viewer, head + "\n" + std::string{picture->file});
    }
  }
}

/// Subscribes to the robot's newest runs as soon as it lists them; other programs do not have them.
void WatchedRobot::followRuns(const Json& list) {
  for (const Json& key : list.at("keys")) {
    if (calls_.runs && key.at("key") == runsKey && viewers_.subscribersOf(runsKey).empty()) {
      subscribe(runsKey, theHistory);
    }
  }
}

void WatchedRobot::set(const Json& settings) {
  const bool isSecret = settings.is_array() && settings.size() == 1 && settings[0].value("mp", "") == "naocal.access";
  requireDone(isSecret ? link_->authenticate(jsonText(settings)) : link_->set(jsonText(settings)));
}

void WatchedRobot::save() {
  requireDone(link_->save());
}

void WatchedRobot::subscribe(const std::string& key, std::size_t viewer) {
  viewers_.add(key, viewer);
  link_->subscribe(key);
}

void WatchedRobot::unsubscribe(const std::string& key, std::size_t viewer) {
  if (viewers_.remove(key, viewer)) {
    link_->unsubscribe(key);
  }
}

void WatchedRobot::watch(std::size_t panel) {
  if (watchers_.empty()) {
    taken_.beginWatch();
  }
  watchers_.insert(panel);
  if (!watch_) {
    watch_ =
        std::make_unique<LiveDetection>(address_, [weak = weak_from_this(), later = calls_.later](std::string json) {
          later([weak, json = std::move(json)] {
            if (const auto self = weak.lock()) {
              for (const std::size_t watcher : self->watchers_) {
                self->calls_.update(watcher, json);
              }
            }
          });
        });
  }
  for (const std::string_view key : LiveDetection::keys) {
    subscribe(std::string{key}, theWatch);
  }
  subscribe(std::string{capturesKey}, theWatch);
  calls_.one(panel, takenPictures());
  wantMounts();
}

void WatchedRobot::wantMounts() {
  for (const std::string_view mount : {LiveDetection::boardsMount, LiveDetection::offsetsMount}) {
    mounts_.request(std::string{mount});
  }
}

std::string WatchedRobot::takenPictures() const {
  Json message = taken_.list();
  message["kind"] = "taken";
  message["robot"] = address_;
  return jsonText(message);
}

void WatchedRobot::tellTaken() const {
  for (const std::size_t watcher : watchers_) {
    calls_.one(watcher, takenPictures());
  }
}

std::optional<std::string> WatchedRobot::takenPicture(std::string_view which) const {
  const std::size_t slash = which.find('/');
  std::size_t series = 0, place = 0;
  const auto number = [](std::string_view text, std::size_t& value) {
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    return problem == std::errc{} && end == text.data() + text.size();
  };
  if (slash == std::string_view::npos || !number(which.substr(0, slash), series) ||
      !number(which.substr(slash + 1), place)) {
    return std::nullopt;
  }
  return taken_.picture(series, place);
}

void WatchedRobot::unwatch(std::size_t panel) {
  watchers_.erase(panel);
  if (watch_ && watchers_.empty()) {
    for (const std::string_view key : LiveDetection::keys) {
      unsubscribe(std::string{key}, theWatch);
    }
    unsubscribe(std::string{capturesKey}, theWatch);
  }
}

void WatchedRobot::addPanel(std::size_t panel) const {
  calls_.one(panel, state());
  for (const auto& [kind, message] : latest_) {
    calls_.one(panel, message);
  }
}

void WatchedRobot::removePanel(std::size_t panel) {
  unwatch(panel);
  for (const std::string& key : viewers_.forget(panel)) {
    link_->unsubscribe(key);
  }
}

Robots::Robots(boost::asio::io_context& context, PanelCallbacks calls, std::chrono::milliseconds patience)
    : context_{context}, calls_{std::move(calls)}, patience_{patience}, alone_{context} {}

void Robots::connect(const std::string& address) {
  if (!robots_.contains(address)) {
    robots_[address] = std::make_shared<WatchedRobot>(context_, address, calls_);
  }
}

void Robots::disconnect(const std::string& address) {
  if (robots_.erase(address) > 0) {
    calls_.all(jsonText({{"kind", "robotGone"}, {"robot", address}}));
  }
}

WatchedRobot* Robots::find(const std::string& address) const {
  const auto found = robots_.find(address);
  return found == robots_.end() ? nullptr : found->second.get();
}

WatchedRobot& Robots::at(const std::string& address, const std::string& verb) const {
  WatchedRobot* const robot = find(address);
  if (!robot) {
    throw InputError{fmt::format("there is no robot {} to {}; connect to it first", address, verb)};
  }
  return *robot;
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

void Robots::addPanel(std::size_t panel) {
  panels_.insert(panel);
  for (const auto& [address, robot] : robots_) {
    robot->resume();
    robot->addPanel(panel);
  }
}

void Robots::removePanel(std::size_t panel) {
  for (const auto& [address, robot] : robots_) {
    robot->removePanel(panel);
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
      robot->suspend();
    }
  });
}

} // namespace naocal
