// What goes to the debug server's clients, and what waits for those that are busy.
#include "framework/Access.hpp"
#include "framework/BoundedJson.hpp"
#include "framework/DebugServer.hpp"
#include "framework/Frames.hpp"
#include "framework/Production.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace naocal {

namespace {

/// A picture that is renewed all the time goes with the values of its own cycle, to which desktops pair it by time; one
/// that a client has waited for so long goes with any.
constexpr std::chrono::seconds patience{1};

} // namespace

bool DebugServer::isReady(const std::weak_ptr<Peer>& client) const {
  const auto peer = client.lock();
  return peer && !peer->busy() && access_.isOpen(peer->address());
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
    if (item.production->isPicture()) {
      byProduction_.at(item.production)->newest.reset();
    }
  }
  for (Shown& shown : shown_) {
    if (shown.thread == thread && shown.production->isPicture() && shown.newest && !shown.newest->picture &&
        isOverdue(shown, report.time)) {
      report.items.push_back(*std::exchange(shown.newest, std::nullopt));
    }
  }
}

std::vector<CycleReport::Item*> DebugServer::picturesToEncode(CycleReport& report) {
  joinMissed(report);
  std::vector<CycleReport::Item*> result;
  for (CycleReport::Item& item : report.items) {
    if (item.production->isPicture() && isAwaited(byProduction_.at(item.production)->key)) {
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
  if (!shown.production->isPicture()) {
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
      shown.bytes = debugFrame(DebugType::image,
                               imageBody(timestamp, picture->width, picture->height, shown.key, picture->bytes));
    } else {
      nlohmann::json value;
      item->sample->json(value);
      shown.bytes = line({{"key", shown.key}, {"timestamp", timestamp}, {"value", std::move(value)}});
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
    if (shown->production->isPicture()) {
      pictures += bytesOf(*shown);
    } else {
      values += (values.empty() ? "" : ",") + bytesOf(*shown);
    }
    return true;
  });
  const std::string update = values.empty() ? "" : debugFrame(DebugType::update, "[" + values + "]");
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
