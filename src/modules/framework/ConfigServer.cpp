#include "framework/ConfigServer.hpp"

#include "framework/Access.hpp"
#include "framework/BoundedJson.hpp"
#include "framework/Configuration.hpp"
#include "framework/Frames.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using nlohmann::json;

void send(Peer& peer, ConfigType type, const json& body) {
  peer.send(std::make_shared<const std::string>(configFrame(type, line(body))));
}

std::string nameOf(const Peer& peer) {
  return peer.address().empty() ? "on this computer" : peer.address();
}

} // namespace

struct ConfigServer::Setting {
  std::string mount, key;
  json value;
};

ConfigServer::ConfigServer(Configuration& configuration, Access& access, Log log)
    : configuration_{configuration}, access_{access}, log_{std::move(log)} {}

ConfigServer::~ConfigServer() = default;

const FrameFormat& ConfigServer::format() const {
  return configFormat;
}

void ConfigServer::closed(Peer& peer) {
  if (const auto will = wills_.extract(&peer)) {
    for (const Setting& last : will.mapped()) {
      change(peer, fmt::format("its last will, {} of {},", last.key, last.mount),
             [&] { configuration_.set(last.mount, last.key, last.value); });
    }
  }
  if (entered_.erase(&peer) > 0) {
    access_.leave(peer.address());
  }
  refused_.erase(&peer);
}

bool ConfigServer::isTrusted(const Peer& peer) const {
  return !access_.needsSecret(peer.address()) || entered_.contains(&peer);
}

void ConfigServer::received(Peer& peer, std::uint8_t type, std::string body) {
  switch (static_cast<ConfigType>(type)) {
  case ConfigType::set:
    return set(peer, body);
  case ConfigType::getMounts:
    return sendMounts(peer);
  case ConfigType::getKeys:
    return sendKeys(peer, body);
  case ConfigType::save:
    return change(peer, "saving the configuration", [&] { configuration_.save(); });
  case ConfigType::sendKeys:
  case ConfigType::sendMounts:
    break;
  }
  throw ProtocolError{fmt::format("expected a request, found message type {}, which only robots send", type)};
}

template <class Action> void ConfigServer::change(const Peer& peer, std::string_view what, const Action& action) {
  if (!isTrusted(peer)) {
    if (refused_.insert(&peer).second) { // once is enough to know, and does not fill a disk
      log_(fmt::format("Client {}: {} was refused, as all that it asks for will be; it has not sent the secret of "
                       "access.json.",
                       nameOf(peer), what));
    }
    return;
  }
  try {
    action();
  } catch (const std::exception& error) {
    log_(fmt::format("Client {}: {} failed: {}.", nameOf(peer), what, error.what()));
  }
}

void ConfigServer::set(Peer& peer, const std::string& body) {
  json changes;
  try {
    changes = parsedJson(body);
    for (const json& entry : changes) {
      static_cast<void>(entry.at("mp").get_ref<const std::string&>());
      static_cast<void>(entry.at("key").get_ref<const std::string&>());
      static_cast<void>(entry.at("value"));
    }
  } catch (const json::exception& error) {
    throw ProtocolError{fmt::format(
        "expected [{{\"mp\": mount, \"key\": key, \"value\": value}}, ..] to set, found: {}", reasonOf(error))};
  }
  for (const json& entry : changes) {
    setOne(peer, entry["mp"], entry["key"], entry["value"]);
  }
}

void ConfigServer::setOne(Peer& peer, const std::string& mount, const std::string& key, const json& value) {
  if (mount == "naocal.access" && key == "secret") {
    return enter(peer, value);
  }
  change(peer, fmt::format("setting {} of {}", key, mount), [&] {
    if (mount == "naocal.configuration" && key == "undo" && value.is_string()) {
      configuration_.undo(value.get<std::string>());
    } else if (mount == "naocal.configuration" && key == "lastWill") {
      keepWill(peer, value);
    } else {
      configuration_.set(mount, key, value);
      for (auto& [other, will] : wills_) {
        if (other != &peer) {
          std::erase_if(will, [&](const Setting& last) { return last.mount == mount && last.key == key; });
        }
      }
    }
  });
}

void ConfigServer::keepWill(const Peer& peer, const json& settings) {
  std::vector<Setting> will;
  for (const json& entry : settings) {
    will.push_back({entry.at("mp").get<std::string>(), entry.at("key").get<std::string>(), entry.at("value")});
  }
  wills_[&peer] = std::move(will);
}

void ConfigServer::enter(Peer& peer, const json& secret) {
  if (entered_.contains(&peer)) {
    return;
  }
  if (!secret.is_string() || !access_.enter(peer.address(), secret.get_ref<const std::string&>())) {
    if (!access_.needsSecret(peer.address())) {
      return;
    }
    throw ProtocolError{"expected the secret of access.json, found another one"};
  }
  entered_.insert(&peer);
}

void ConfigServer::sendMounts(Peer& peer) const {
  json keys = json::array();
  for (const auto& mount : configuration_.mounts()) {
    keys.push_back({{"key", mount.name}, {"filename", mount.file.string()}});
  }
  send(peer, ConfigType::sendMounts, {{"keys", std::move(keys)}});
}

void ConfigServer::sendKeys(Peer& peer, const std::string& mount) const {
  json found;
  configuration_.keys(mount, found);
  json keys = json::array();
  for (const auto& [key, value] : found.items()) {
    keys.push_back({{"key", key}, {"value", value}});
  }
  send(peer, ConfigType::sendKeys, {{"mountPoint", mount}, {"keys", std::move(keys)}});
}

} // namespace naocal
