#pragma once

#include "framework/core/Clock.hpp"
#include "framework/network/Outbox.hpp"
#include "framework/network/Peer.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace naocal {

class Access;
class AnyProduction;
class Thread;

/// HULKs' debug protocol: clients subscribe to productions by name and receive those that were edited, in one UPDATE
/// per cycle of a thread, preceded by images. LIST contains all keys from the start, with null until a value exists. A
/// client with data still in transit skips the cycle; it gets the newest value of each missed key in the next cycle in
/// which it is ready, values before images. Addresses without access get an empty list, and the full one as soon as
/// they are granted access.
class DebugServer final : public Protocol {
public:
  /// `base`: origin of the timestamps [ms].
  DebugServer(const std::vector<Thread*>& threads, Access& access, TimePoint base);
  ~DebugServer() override;

  const FrameFormat& format() const override;
  void onOpened(Peer& peer) override;
  void onReceived(Peer& peer, std::uint8_t type, std::string body) override;
  void onClosed(Peer& peer) override;
  bool isTrusted(const Peer& peer) const override;
  bool needsSecret(const std::string& address) const override;
  bool isInUse(const Peer& peer) const override; // has subscriptions
  bool mayBeSilent(const Peer& peer) const override { return isInUse(peer); }

  /// The image samples that a ready client subscribes to; the caller encodes them, on any thread, before `send`. Adds
  /// overdue images of the same thread to the report.
  std::vector<CycleReport::Item*> picturesToEncode(CycleReport& report);

  /// Sends a cycle's values to the ready subscribers and keeps them for the others. Images that are not encoded wait.
  void send(CycleReport& report);

  /// Sends the list to the clients of an address that has just been granted access.
  void sendListTo(const std::string& address);

private:
  /// State of one key.
  struct Shown {
    std::string key;
    const Thread* thread;
    AnyProduction* production;
    std::string bytes; // JSON element of UPDATE, or of LIST before the first value; for an image its frame
    TimePoint time{};  // of the newest value
    std::optional<CycleReport::Item> newest{}; // until it is encoded into `bytes`
  };
  struct Client {
    std::set<std::string, std::less<>> keys; // also unknown ones
    std::map<Shown*, TimePoint> due;         // pending keys and the time since when; ordered like the productions
  };
  void subscribe(Client& client, const std::string& key);
  void unsubscribe(Client& client, const std::string& key);
  void subscribeAll(Client& client, const std::string& body);
  void sendList(Peer& peer) const;
  void updateWanted(const std::string& key);
  bool isReady(const std::weak_ptr<Peer>& client) const; // connected, allowed, nothing in transit
  bool isAwaited(const std::string& key) const;          // by a ready client
  bool isOverdue(Shown& shown, TimePoint now) const;     // pending for a ready client for `patience` or longer
  const Thread* threadOf(const CycleReport& report) const;
  void joinMissed(CycleReport& report);
  void note(CycleReport::Item item, TimePoint now); // marks it as pending for its subscribers
  bool goes(const Shown& shown, TimePoint since, const CycleReport& report) const;
  void sendDue(Peer& peer, Client& client, const CycleReport& report);
  const std::string& bytesOf(Shown& shown) const;

  Access& access_;
  TimePoint base_;
  std::vector<Shown> shown_; // never resized: others hold pointers into it
  std::map<std::string, Shown*, std::less<>> byKey_;
  std::map<const AnyProduction*, Shown*> byProduction_;
  ByPeer<Client> clients_;
};

} // namespace naocal
