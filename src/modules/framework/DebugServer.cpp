#include "framework/DebugServer.hpp"

#include "framework/Access.hpp"
#include "framework/BoundedJson.hpp"
#include "framework/Frames.hpp"
#include "framework/Outbox.hpp"
#include "framework/Production.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using nlohmann::json;

constexpr std::size_t mostKeys = 1000; // of one client
constexpr std::size_t longestKey = 256;

} // namespace

/// What is known of one key.
struct DebugServer::Shown {
  std::string key;
  AnyProduction* production;
  std::string element; // of the last UPDATE, or of LIST before there was one; empty for pictures
};

DebugServer::DebugServer(const std::vector<Thread*>& threads, Access& access, TimePoint base)
    : access_{access}, base_{base} {
  for (const Thread* thread : threads) {
    for (AnyProduction* production : thread->productions()) {
      if (!production->isShown()) {
        continue;
      }
      const std::string key = thread->name() + "." + production->name();
      const json unknown = {{"key", key}, {"timestamp", 0}, {"value", nullptr}};
      auto shown = std::make_unique<Shown>(Shown{key, production, production->isPicture() ? "" : line(unknown)});
      byProduction_[production] = shown.get();
      shown_[key] = std::move(shown);
    }
  }
}
DebugServer::~DebugServer() = default;

const FrameFormat& DebugServer::format() const {
  return debugFormat;
}

void DebugServer::opened(Peer& peer) {
  clients_[&peer];
}

void DebugServer::closed(Peer& peer) {
  const auto client = clients_.extract(&peer);
  if (!client.empty()) {
    for (const std::string& key : client.mapped().keys) {
      updateWanted(key);
    }
  }
}

bool DebugServer::isTrusted(const Peer& peer) const {
  return access_.isOpen(peer.address());
}

void DebugServer::received(Peer& peer, std::uint8_t type, std::string body) {
  switch (static_cast<DebugType>(type)) {
  case DebugType::subscribe:
    return subscribe(peer, body);
  case DebugType::unsubscribe:
    return unsubscribe(peer, body);
  case DebugType::requestList:
    return sendList(peer);
  case DebugType::subscribeBulk:
    return subscribeAll(peer, body);
  case DebugType::update:
  case DebugType::list:
  case DebugType::image:
    break;
  }
  throw ProtocolError{fmt::format("expected a request, found message type {}, which only robots send", type)};
}

void DebugServer::subscribe(Peer& peer, const std::string& key) {
  auto& keys = clients_[&peer].keys;
  if (key.size() > longestKey) {
    throw ProtocolError{fmt::format("expected a key of at most {} letters, found {}", longestKey, key.size())};
  }
  if (keys.size() >= mostKeys && !keys.contains(key)) {
    throw ProtocolError{fmt::format("expected at most {} subscriptions of one client, found more", mostKeys)};
  }
  keys.insert(key);
  updateWanted(key);
}

void DebugServer::unsubscribe(Peer& peer, const std::string& key) {
  clients_[&peer].keys.erase(key);
  updateWanted(key);
}

void DebugServer::subscribeAll(Peer& peer, const std::string& body) {
  try {
    const json request = parsedJson(body);
    for (const json& key : request.at("keys")) {
      subscribe(peer, key.get_ref<const std::string&>());
    }
  } catch (const json::exception&) {
    throw ProtocolError{"expected {\"keys\": [..]} with texts as a list of subscriptions, found something else"};
  }
}

void DebugServer::updateWanted(const std::string& key) {
  if (const auto shown = shown_.find(key); shown != shown_.end()) {
    shown->second->production->setWanted(std::any_of(
        clients_.begin(), clients_.end(), [&](const auto& client) { return client.second.keys.contains(key); }));
  }
}

void DebugServer::sendList(Peer& peer) const {
  std::string body = "{\"keys\":[";
  if (access_.isOpen(peer.address())) {
    for (const auto& [key, shown] : shown_) {
      body += body.back() == '[' ? "" : ",";
      body += shown->production->isPicture() ? json{{"key", key}, {"isImage", true}}.dump() : shown->element;
    }
  }
  peer.send(std::make_shared<const std::string>(debugFrame(DebugType::list, body + "]}\n")));
}

bool DebugServer::isReady(const Peer& peer) const {
  return !peer.busy() && access_.isOpen(peer.address());
}

bool DebugServer::isAwaited(const std::string& key) const {
  return std::any_of(clients_.begin(), clients_.end(),
                     [&](const auto& client) { return client.second.keys.contains(key) && isReady(*client.first); });
}

std::vector<CycleReport::Item*> DebugServer::picturesToEncode(CycleReport& report) const {
  std::vector<CycleReport::Item*> result;
  for (CycleReport::Item& item : report.items) {
    if (item.production->isPicture() && isAwaited(byProduction_.at(item.production)->key)) {
      result.push_back(&item);
    }
  }
  return result;
}

void DebugServer::send(const CycleReport& report) {
  const auto age = std::chrono::duration_cast<std::chrono::milliseconds>(report.time - base_).count();
  const auto timestamp = static_cast<std::uint64_t>(std::max<decltype(age)>(age, 0));
  struct Part {
    const std::string* key;
    std::string frame, element; // one of the two: a picture's frame, a value's element of UPDATE
  };
  std::vector<Part> parts;
  for (const auto& [production, sample, picture] : report.items) {
    Shown& shown = *byProduction_.at(production);
    if (!isAwaited(shown.key)) {
      continue; // not even turned into text
    }
    if (production->isPicture() && !picture) {
      continue;
    }
    if (picture) {
      const auto body = imageBody(timestamp, picture->width, picture->height, shown.key, picture->bytes);
      parts.push_back({&shown.key, debugFrame(DebugType::image, body), ""});
    } else {
      json value;
      sample->json(value);
      shown.element = line({{"key", shown.key}, {"timestamp", timestamp}, {"value", std::move(value)}});
      parts.push_back({&shown.key, "", shown.element});
    }
  }
  for (auto& [peer, client] : clients_) {
    if (!isReady(*peer)) {
      continue;
    }
    std::string bytes, update;
    for (const Part& part : parts) {
      if (client.keys.contains(*part.key)) {
        bytes += part.frame;
        update += part.element.empty() ? "" : (update.empty() ? "" : ",") + part.element;
      }
    }
    bytes += update.empty() ? "" : debugFrame(DebugType::update, "[" + update + "]");
    if (!bytes.empty()) {
      peer->send(std::make_shared<const std::string>(std::move(bytes)));
    }
  }
}

void DebugServer::listTo(const std::string& address) {
  for (const auto& [peer, client] : clients_) {
    if (peer->address() == address) {
      sendList(*peer);
    }
  }
}

} // namespace naocal
