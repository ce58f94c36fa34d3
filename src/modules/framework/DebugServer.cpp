#include "framework/DebugServer.hpp"

#include "framework/Access.hpp"
#include "framework/BoundedJson.hpp"
#include "framework/Frames.hpp"
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

DebugServer::DebugServer(const std::vector<Thread*>& threads, Access& access, TimePoint base)
    : access_{access}, base_{base} {
  for (const Thread* thread : threads) {
    for (AnyProduction* production : thread->productions()) {
      if (!production->isShown()) {
        continue;
      }
      const std::string key = thread->name() + "." + production->name();
      const json unknown = {{"key", key}, {"timestamp", 0}, {"value", nullptr}};
      shown_.push_back({key, thread, production, production->isPicture() ? "" : line(unknown)});
    }
  }
  for (Shown& shown : shown_) {
    byKey_[shown.key] = byProduction_[shown.production] = &shown;
  }
}
DebugServer::~DebugServer() = default;

const FrameFormat& DebugServer::format() const {
  return debugFormat;
}

void DebugServer::opened(Peer& peer) {
  clients_[peer.weak_from_this()];
}

void DebugServer::closed(Peer& peer) {
  const auto client = clients_.extract(peer.weak_from_this());
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
  const auto client = clients_.find(peer.weak_from_this());
  if (client == clients_.end()) {
    return; // it has left
  }
  switch (static_cast<DebugType>(type)) {
  case DebugType::subscribe:
    return subscribe(client->second, body);
  case DebugType::unsubscribe:
    return unsubscribe(client->second, body);
  case DebugType::requestList:
    return sendList(peer);
  case DebugType::subscribeBulk:
    return subscribeAll(client->second, body);
  case DebugType::update:
  case DebugType::list:
  case DebugType::image:
    break;
  }
  throw ProtocolError{fmt::format("expected a request, found message type {}, which only robots send", type)};
}

void DebugServer::subscribe(Client& client, const std::string& key) {
  auto& keys = client.keys;
  if (key.size() > longestKey) {
    throw ProtocolError{fmt::format("expected a key of at most {} letters, found {}", longestKey, key.size())};
  }
  if (keys.size() >= mostKeys && !keys.contains(key)) {
    throw ProtocolError{fmt::format("expected at most {} subscriptions of one client, found more", mostKeys)};
  }
  keys.insert(key);
  updateWanted(key);
}

void DebugServer::unsubscribe(Client& client, const std::string& key) {
  client.keys.erase(key);
  if (const auto shown = byKey_.find(key); shown != byKey_.end()) {
    client.due.erase(shown->second);
  }
  updateWanted(key);
}

void DebugServer::subscribeAll(Client& client, const std::string& body) {
  try {
    const json request = parsedJson(body);
    for (const json& key : request.at("keys")) {
      subscribe(client, key.get_ref<const std::string&>());
    }
  } catch (const json::exception&) {
    throw ProtocolError{"expected {\"keys\": [..]} with texts as a list of subscriptions, found something else"};
  }
}

void DebugServer::updateWanted(const std::string& key) {
  if (const auto shown = byKey_.find(key); shown != byKey_.end()) {
    const bool wanted = std::any_of(clients_.begin(), clients_.end(),
                                    [&](const auto& client) { return client.second.keys.contains(key); });
    shown->second->production->setWanted(wanted);
    if (!wanted) {
      shown->second->newest.reset();
    }
  }
}

void DebugServer::sendList(Peer& peer) const {
  std::string body = "{\"keys\":[";
  if (access_.isOpen(peer.address())) {
    for (const auto& [key, shown] : byKey_) {
      body += body.back() == '[' ? "" : ",";
      body += shown->production->isPicture() ? json{{"key", key}, {"isImage", true}}.dump() : shown->bytes;
    }
  }
  peer.send(std::make_shared<const std::string>(debugFrame(DebugType::list, body + "]}\n")));
}

void DebugServer::listTo(const std::string& address) {
  for (const auto& [who, client] : clients_) {
    if (const auto peer = who.lock(); peer && peer->address() == address) {
      sendList(*peer);
    }
  }
}

} // namespace naocal
