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

/// HULKs' debug protocol: clients subscribe to productions by name and get those that were edited, one UPDATE per cycle
/// of a thread, pictures before it. All keys are listed from the start, with null until a value was sent. A client to
/// whom something is still on its way skips the cycle; of each key that it missed it gets the newest value with the
/// next cycle that finds it ready, values before pictures. Addresses that may not see the robot yet get an empty list,
/// and the whole one once they may.
class DebugServer final : public Protocol {
public:
  /// `base`: the time that timestamps [ms] count from.
  DebugServer(const std::vector<Thread*>& threads, Access& access, TimePoint base);
  ~DebugServer() override;

  const FrameFormat& format() const override;
  void onOpened(Peer& peer) override;
  void onReceived(Peer& peer, std::uint8_t type, std::string body) override;
  void onClosed(Peer& peer) override;
  bool isTrusted(const Peer& peer) const override;

  /// The samples of pictures that somebody wants and can take now: to be encoded, by any thread, before the report is
  /// sent. Those of the same thread that somebody missed join the report.
  std::vector<CycleReport::Item*> picturesToEncode(CycleReport& report);

  /// Sends what a cycle left to those who want it and can take it now, and keeps it for those who cannot. Pictures that
  /// are not encoded wait.
  void send(CycleReport& report);

  /// Sends the list to the clients of an address that has just become open.
  void sendListTo(const std::string& address);

private:
  /// What is known of one key.
  struct Shown {
    std::string key;
    const Thread* thread;
    AnyProduction* production;
    std::string bytes;                         // an element of UPDATE, of LIST before there was one; a picture's frame
    TimePoint time{};                          // of the newest value
    std::optional<CycleReport::Item> newest{}; // while it is not turned into bytes
  };
  struct Client {
    std::set<std::string, std::less<>> keys; // also those that do not exist
    std::map<Shown*, TimePoint> due;         // what it has not got, and since when; in the order of productions
  };
  void subscribe(Client& client, const std::string& key);
  void unsubscribe(Client& client, const std::string& key);
  void subscribeAll(Client& client, const std::string& body);
  void sendList(Peer& peer) const;
  void updateWanted(const std::string& key);
  bool isReady(const std::weak_ptr<Peer>& client) const; // there, and nothing is on its way to it
  bool isAwaited(const std::string& key) const;          // by somebody who is ready
  bool isOverdue(Shown& shown, TimePoint now) const;     // for somebody who is ready
  const Thread* threadOf(const CycleReport& report) const;
  void joinMissed(CycleReport& report);
  void note(CycleReport::Item item, TimePoint now); // who is to get it
  bool goes(const Shown& shown, TimePoint since, const CycleReport& report) const;
  void sendDue(Peer& peer, Client& client, const CycleReport& report);
  const std::string& bytesOf(Shown& shown) const;

  Access& access_;
  TimePoint base_;
  std::vector<Shown> shown_; // never grows: others point into it
  std::map<std::string, Shown*, std::less<>> byKey_;
  std::map<const AnyProduction*, Shown*> byProduction_;
  ByPeer<Client> clients_;
};

} // namespace naocal
