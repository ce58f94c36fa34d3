#include "framework/network/DebugServer.hpp"

#include "framework/core/Module.hpp"
#include "framework/network/Access.hpp"
#include "protocol/BoundedJson.hpp"
#include "protocol/Frames.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace naocal {
namespace {

using nlohmann::json;

/// An image is sent with the values of its own cycle, because desktops pair them by time; after this time pending, it
/// is sent with any cycle.
constexpr std::chrono::seconds patience{1};

constexpr std::size_t mostKeys = 1000; // per client
constexpr std::size_t longestKey = 256;

} // namespace

DebugServer::DebugServer(const std::vector<Thread*>& threads, Access& access, TimePoint base)
    : access_{access}, base_{base} {
  for (const Thread* thread : threads) {
    for (AnyProduction* production : thread->productions()) {
      if (!production->isDisplayable()) {
        continue;
      }
      const std::string key = thread->name() + "." + production->name();
      const json unknown = {{"key", key}, {"timestamp", 0}, {"value", nullptr}};
      shown_.push_back({key, thread, production, production->isImage() ? "" : jsonLine(unknown)});
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

void DebugServer::onOpened(Peer& peer) {
  clients_[peer.weak_from_this()];
}

void DebugServer::onClosed(Peer& peer) {
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

bool DebugServer::needsSecret(const std::string& address) const {
  return !access_.isOpen(address);
}

bool DebugServer::isInUse(const Peer& peer) const {
  const auto client = clients_.find(peer.weak_from_this());
  return isTrusted(peer) && client != clients_.end() && !client->second.keys.empty();
}

void DebugServer::onReceived(Peer& peer, std::uint8_t type, std::string body) {
  const auto client = clients_.find(peer.weak_from_this());
  if (client == clients_.end()) {
    return; // the connection has ended
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
    const json request = parseBoundedJson(body);
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
      body += shown->production->isImage() ? json{{"key", key}, {"isImage", true}}.dump() : shown->bytes;
    }
  }
  peer.send(std::make_shared<const std::string>(encodeDebugFrame(DebugType::list, body + "]}\n")));
}

void DebugServer::sendListTo(const std::string& address) {
  for (const auto& [who, client] : clients_) {
    if (const auto peer = who.lock(); peer && peer->address() == address) {
      sendList(*peer);
    }
  }
}

bool DebugServer::isReady(const std::weak_ptr<Peer>& client) const {
  const auto peer = client.lock();
  return peer && !peer->isBusy() && access_.isOpen(peer->address());
}

const Thread* DebugServer::threadOf(const CycleReport& report) const {
  return byProduction_.at(report.items.front().production)->thread;
}

bool DebugServer::isAwaited(const std::string& key) const {
  return std::any_of(clients_.begin(), clients_.end(),
                     [&](const auto& client) { return client.second.keys.contains(key) && isReady(client.first); });
}

bool DebugServer::isOverdue(Shown& shown, TimePoint now) const {
  return std::any_of(clients_.begin(), clients_.end(), [&](const auto& client) {
    const auto due = client.second.due.find(&shown);
    return due != client.second.due.end() && now - due->second >= patience && isReady(client.first);
  });
}

void DebugServer::joinMissed(CycleReport& report) {
  const Thread* thread = threadOf(report);
  for (const CycleReport::Item& item : report.items) {
    if (item.production->isImage()) {
      byProduction_.at(item.production)->newest.reset();
    }
  }
  for (Shown& shown : shown_) {
    if (shown.thread == thread && shown.production->isImage() && shown.newest && !shown.newest->picture &&
        isOverdue(shown, report.time)) {
      report.items.push_back(*std::exchange(shown.newest, std::nullopt));
    }
  }
}

std::vector<CycleReport::Item*> DebugServer::picturesToEncode(CycleReport& report) {
  joinMissed(report);
  std::vector<CycleReport::Item*> result;
  for (CycleReport::Item& item : report.items) {
    if (item.production->isImage() && isAwaited(byProduction_.at(item.production)->key)) {
      result.push_back(&item);
    }
  }
  return result;
}

void DebugServer::note(CycleReport::Item item, TimePoint now) {
  Shown& shown = *byProduction_.at(item.production);
  const bool failed = !item.sample && !item.picture;
  shown.time = item.time;
  shown.newest = std::move(item);
  for (auto& [who, client] : clients_) {
    if (failed) {
      client.due.erase(&shown);
    } else if (const auto peer = who.lock();
               peer && client.keys.contains(shown.key) && access_.isOpen(peer->address())) {
      client.due.try_emplace(&shown, now);
    }
  }
}

bool DebugServer::goes(const Shown& shown, TimePoint since, const CycleReport& report) const {
  if (!shown.production->isImage()) {
    return true;
  }
  const bool encoded = !shown.newest || shown.newest->picture;
  return encoded && shown.thread == threadOf(report) && (shown.time == report.time || report.time - since >= patience);
}

const std::string& DebugServer::bytesOf(Shown& shown) const {
  if (const auto item = std::exchange(shown.newest, std::nullopt)) {
    const auto age = std::chrono::duration_cast<std::chrono::milliseconds>(item->time - base_).count();
    const auto timestamp = static_cast<std::uint64_t>(std::max<decltype(age)>(age, 0));
    if (const auto& picture = item->picture) {
      shown.bytes = encodeDebugFrame(
          DebugType::image, encodeImageBody({timestamp, picture->width, picture->height, shown.key, picture->bytes}));
    } else {
      nlohmann::json value;
      item->sample->json(value);
      shown.bytes = jsonLine({{"key", shown.key}, {"timestamp", timestamp}, {"value", std::move(value)}});
    }
  }
  return shown.bytes;
}

void DebugServer::sendDue(Peer& peer, Client& client, const CycleReport& report) {
  const bool missedSome =
      std::any_of(client.due.begin(), client.due.end(), [&](const auto& entry) { return entry.second != report.time; });
  std::string pictures, values;
  std::erase_if(client.due, [&](const auto& entry) {
    const auto& [shown, since] = entry;
    if (!goes(*shown, since, report)) {
      return false;
    }
    if (shown->production->isImage()) {
      pictures += bytesOf(*shown);
    } else {
      values += (values.empty() ? "" : ",") + bytesOf(*shown);
    }
    return true;
  });
  const std::string update = values.empty() ? "" : encodeDebugFrame(DebugType::update, "[" + values + "]");
  if (std::string bytes = missedSome ? update + pictures : pictures + update; !bytes.empty()) {
    peer.send(std::make_shared<const std::string>(std::move(bytes)));
  }
}

void DebugServer::send(CycleReport& report) {
  for (CycleReport::Item& item : report.items) {
    note(std::move(item), report.time);
  }
  for (auto& [who, client] : clients_) {
    if (isReady(who)) {
      sendDue(*who.lock(), client, report);
    }
  }
}

} // namespace naocal
