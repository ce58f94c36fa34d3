#include "framework/network/ConfigServer.hpp"

#include "framework/configuration/Configuration.hpp"
#include "framework/network/Access.hpp"
#include "protocol/BoundedJson.hpp"
#include "protocol/Frames.hpp"

#include <deque>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace naocal {
namespace {

using nlohmann::json;

void send(Peer& peer, ConfigType type, const json& body) {
  peer.send(std::make_shared<const std::string>(encodeConfigFrame(type, jsonLine(body))));
}

std::string nameOf(const Peer& peer) {
  return peer.address().empty() ? "on this computer" : peer.address();
}

} // namespace

struct ConfigServer::Setting {
  std::string mount, key;
  json value;
};

struct ConfigServer::Client {
  bool hasEntered = false; // has sent the secret
  bool isRefused = false;  // the refusal has been logged
  std::vector<Setting> will;
  std::deque<Setting> pending; // of its last message
};

ConfigServer::ConfigServer(Configuration& configuration, Access& access, Log log)
    : configuration_{configuration}, access_{access}, log_{std::move(log)} {}

ConfigServer::~ConfigServer() = default;

const FrameFormat& ConfigServer::format() const {
  return configFormat;
}

void ConfigServer::onOpened(Peer& peer) {
  clients_[peer.weak_from_this()];
}

void ConfigServer::onClosed(Peer& peer) {
  const auto client = clients_.find(peer.weak_from_this());
  if (client == clients_.end()) {
    return;
  }
  for (const Setting& last : client->second.will) {
    change(peer, fmt::format("its last will, {} of {},", last.key, last.mount),
           [&] { configuration_.set(last.mount, last.key, last.value); });
  }
  if (client->second.hasEntered) {
    access_.leave(peer.address());
  }
  clients_.erase(client);
}

ConfigServer::Client& ConfigServer::clientOf(const Peer& peer) {
  return clients_.find(peer.weak_from_this())->second;
}

bool ConfigServer::isTrusted(const Peer& peer) const {
  const auto client = clients_.find(peer.weak_from_this());
  return client != clients_.end() && (client->second.hasEntered || !access_.needsSecret(peer.address()));
}

bool ConfigServer::needsSecret(const std::string& address) const {
  return access_.needsSecret(address);
}

bool ConfigServer::isInUse(const Peer& peer) const {
  const auto client = clients_.find(peer.weak_from_this());
  return client != clients_.end() && !client->second.will.empty();
}

bool ConfigServer::mayBeSilent(const Peer& peer) const {
  return isTrusted(peer);
}

void ConfigServer::onReceived(Peer& peer, std::uint8_t type, std::string body) {
  if (!clients_.contains(peer.weak_from_this())) {
    return; // the connection has ended
  }
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
    if (!std::exchange(clientOf(peer).isRefused, true)) { // logged once: repetition would fill the disk
      log_(fmt::format("Client {}: what it asks for is refused until it sends the secret of access.json: {}.",
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
    changes = parseBoundedJson(body);
    for (const json& entry : changes) {
      static_cast<void>(entry.at("mp").get_ref<const std::string&>());
      static_cast<void>(entry.at("key").get_ref<const std::string&>());
      static_cast<void>(entry.at("value"));
    }
  } catch (const json::exception& error) {
    throw ProtocolError{fmt::format(
        "expected [{{\"mp\": mount, \"key\": key, \"value\": value}}, ..] to set, found: {}", parseErrorReason(error))};
  }
  if (changes.size() > mostSettings) {
    throw ProtocolError{
        fmt::format("expected at most {} settings in a message, found {}", mostSettings, changes.size())};
  }
  auto& pending = clientOf(peer).pending;
  for (json& entry : changes) {
    pending.push_back({entry["mp"], entry["key"], std::move(entry["value"])});
  }
}

bool ConfigServer::continueMessage(Peer& peer) {
  const auto client = clients_.find(peer.weak_from_this());
  if (client == clients_.end()) {
    return false; // the connection has ended
  }
  auto& pending = client->second.pending;
  for (std::size_t i = 0; i < settingsPerTurn && !pending.empty(); ++i) {
    const Setting setting = std::move(pending.front());
    pending.pop_front();
    setOne(peer, setting.mount, setting.key, setting.value);
  }
  return !pending.empty();
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
      forgetWills(peer, mount, key);
    }
  });
}

void ConfigServer::keepWill(const Peer& peer, const json& settings) {
  if (settings.size() > mostWillSettings) {
    throw ConfigurationError{
        fmt::format("expected at most {} settings in a last will, found {}", mostWillSettings, settings.size())};
  }
  std::vector<Setting> will;
  for (const json& entry : settings) {
    will.push_back({entry.at("mp").get<std::string>(), entry.at("key").get<std::string>(), entry.at("value")});
  }
  clientOf(peer).will = std::move(will);
}

void ConfigServer::forgetWills(const Peer& except, const std::string& mount, const std::string& key) {
  for (auto& [who, client] : clients_) {
    if (who.lock().get() != &except) {
      std::erase_if(client.will, [&](const Setting& last) { return last.mount == mount && last.key == key; });
    }
  }
}

void ConfigServer::enter(Peer& peer, const json& secret) {
  if (clientOf(peer).hasEntered) {
    return;
  }
  if (!secret.is_string() || !access_.enter(peer.address(), secret.get_ref<const std::string&>())) {
    if (!access_.needsSecret(peer.address())) {
      return;
    }
    throw ProtocolError{"expected the secret of access.json, found another one"};
  }
  clientOf(peer).hasEntered = true;
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
  configuration_.readKeys(mount, found);
  json keys = json::array();
  for (const auto& [key, value] : found.items()) {
    keys.push_back({{"key", key}, {"value", value}});
  }
  send(peer, ConfigType::sendKeys, {{"mountPoint", mount}, {"keys", std::move(keys)}});
}

} // namespace naocal
