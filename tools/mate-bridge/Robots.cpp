#include "Robots.hpp"

#include "RobotFrames.hpp"
#include "RobotLink.hpp"

#include "captures/InputError.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

std::string text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// What a robot sent as JSON; a note in its place where it is none.
Json parsed(const std::string& body) {
  Json json = Json::parse(body, nullptr, false);
  return json.is_discarded() ? Json() : json;
}

} // namespace

struct Robots::Entry {
  std::unique_ptr<RobotLink> link;
  std::map<std::string, std::set<std::size_t>> viewers; // by key
  std::map<std::string, std::string> latest;            // messages for panels to come, by kind
};

Robots::Robots(boost::asio::io_context& context, Calls calls) : context_{context}, calls_{std::move(calls)} {}

Robots::~Robots() = default;

void Robots::connect(const std::string& address) {
  if (entries_.contains(address)) {
    return;
  }
  auto entry = std::make_unique<Entry>();
  Entry& made = *entry;
  made.link = std::make_unique<RobotLink>(
      context_, address,
      RobotCalls{[this, address] { calls_.all(state(address, *entries_.at(address))); },
                 [this, address](const std::string& body) { listed(address, "list", body); },
                 [this, address](const std::string& body) { updated(address, body); },
                 [this, address](const std::string& body) { listed(address, "mounts", body); },
                 [this, address](const std::string& body) { listed(address, "keys", body); },
                 [this, address](const std::string& body) { pictured(address, body); }});
  entries_[address] = std::move(entry);
  calls_.all(state(address, made));
}

void Robots::disconnect(const std::string& address) {
  if (entries_.erase(address) > 0) {
    calls_.all(text({{"kind", "robotGone"}, {"robot", address}}));
  }
}

std::string Robots::state(const std::string& address, const Entry& entry) const {
  return text({{"kind", "robot"},
               {"robot", address},
               {"connected", entry.link->connected()},
               {"sentence", entry.link->sentence()}});
}

void Robots::listed(const std::string& address, const std::string& kind, const std::string& body) {
  const std::string message = text({{"kind", kind}, {"robot", address}, {"body", parsed(body)}});
  Entry& entry = *entries_.at(address);
  if (kind != "keys" && entry.latest[kind] == message) {
    return; // the robot only said that it is there
  }
  entry.latest[kind] = message;
  calls_.all(message);
}

void Robots::updated(const std::string& address, const std::string& body) {
  const Json values = parsed(body);
  std::map<std::size_t, Json> wanted; // by panel
  for (const Json& value : values.is_array() ? values : Json::array()) {
    if (!value.is_object() || !value.contains("key") || !value["key"].is_string()) {
      continue;
    }
    const Entry& entry = *entries_.at(address);
    if (const auto viewers = entry.viewers.find(value["key"].get<std::string>()); viewers != entry.viewers.end()) {
      for (const std::size_t panel : viewers->second) {
        wanted[panel].push_back(value);
      }
    }
  }
  for (const auto& [panel, list] : wanted) {
    calls_.update(panel, text({{"kind", "update"}, {"robot", address}, {"values", list}}));
  }
}

void Robots::pictured(const std::string& address, const std::string& body) {
  const auto picture = robotPicture(body);
  if (!picture) {
    return;
  }
  const std::string key{picture->key};
  const auto& viewers = entries_.at(address)->viewers;
  if (const auto found = viewers.find(key); found != viewers.end()) {
    const std::string head = text({{"kind", "picture"},
                                   {"robot", address},
                                   {"key", key},
                                   {"timestamp", picture->timestamp},
                                   {"width", picture->width},
                                   {"height", picture->height}});
    for (const std::size_t panel : found->second) {
      calls_.picture(panel, head + "\n" + std::string{picture->file});
    }
  }
}

bool Robots::asked(std::size_t panel, const Json& request) {
  const std::string verb = request.at("do");
  if (verb == "connect") {
    connect(request.at("robot"));
    return true;
  }
  static const std::set<std::string> verbs{"disconnect", "subscribe", "unsubscribe", "keys", "set", "save"};
  if (!verbs.contains(verb)) {
    return false;
  }
  const std::string address = request.at("robot");
  const auto found = entries_.find(address);
  if (found == entries_.end()) {
    throw InputError{fmt::format("there is no robot {} to {}; connect to it first", address, verb)};
  }
  verb == "disconnect" ? disconnect(address) : change(panel, *found->second, verb, request);
  return true;
}

void Robots::change(std::size_t panel, Entry& entry, const std::string& verb, const Json& request) {
  bool done = true;
  if (verb == "subscribe") {
    const std::string key = request.at("key");
    entry.viewers[key].insert(panel);
    entry.link->subscribe(key);
  } else if (verb == "unsubscribe") {
    const std::string key = request.at("key");
    entry.viewers[key].erase(panel);
    if (entry.viewers[key].empty()) {
      entry.viewers.erase(key);
      entry.link->unsubscribe(key);
    }
  } else if (verb == "keys") {
    entry.link->askForKeys(request.at("mount"));
  } else if (verb == "set") {
    done = entry.link->set(text(request.at("settings")));
  } else {
    done = entry.link->save();
  }
  if (!done) {
    throw InputError{"the robot is not connected: nothing was changed; try again when it is back"};
  }
}

void Robots::greet(std::size_t panel) const {
  for (const auto& [address, entry] : entries_) {
    calls_.one(panel, state(address, *entry));
    for (const auto& [kind, message] : entry->latest) {
      calls_.one(panel, message);
    }
  }
}

void Robots::forget(std::size_t panel) {
  for (auto& [address, entry] : entries_) {
    for (auto viewers = entry->viewers.begin(); viewers != entry->viewers.end();) {
      viewers->second.erase(panel);
      if (viewers->second.empty()) {
        entry->link->unsubscribe(viewers->first);
        viewers = entry->viewers.erase(viewers);
      } else {
        ++viewers;
      }
    }
  }
}

} // namespace naocal
