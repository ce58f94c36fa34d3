#pragma once

#include "framework/Clock.hpp"
#include "framework/Outbox.hpp"
#include "framework/Peer.hpp"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace naocal {

class Access;
class AnyProduction;
class Thread;

/// HULKs' debug protocol: clients subscribe to productions by name and get those that were edited, one UPDATE per cycle
/// of a thread, pictures before it. All keys are listed from the start, with null until a value was sent. A client to
/// whom something is still on its way skips the cycle. Addresses that may not see the robot yet get an empty list, and
/// the whole one once they may.
class DebugServer final : public Protocol {
public:
  /// `base`: the time that timestamps [ms] count from.
  DebugServer(const std::vector<Thread*>& threads, Access& access, TimePoint base);
  ~DebugServer() override;

  const FrameFormat& format() const override;
  void opened(Peer& peer) override;
  void received(Peer& peer, std::uint8_t type, std::string body) override;
  void closed(Peer& peer) override;
  bool isTrusted(const Peer& peer) const override;

  /// The samples of pictures that somebody wants and can take now: to be encoded, by any thread, before the report is
  /// sent.
  std::vector<CycleReport::Item*> picturesToEncode(CycleReport& report) const;

  /// Sends what a cycle left to those who want it; pictures that are not encoded are left out.
  void send(const CycleReport& report);

  /// Sends the list to the clients of an address that has just become open.
  void listTo(const std::string& address);

private:
  struct Shown;
  struct Client {
    std::set<std::string, std::less<>> keys; // also those that do not exist
  };
  void subscribe(Peer& peer, const std::string& key);
  void unsubscribe(Peer& peer, const std::string& key);
  void subscribeAll(Peer& peer, const std::string& body);
  void sendList(Peer& peer) const;
  void updateWanted(const std::string& key);
  bool isReady(const Peer& peer) const;
  bool isAwaited(const std::string& key) const; // by somebody who is ready

  Access& access_;
  TimePoint base_;
  std::map<std::string, std::unique_ptr<Shown>, std::less<>> shown_; // by key
  std::map<const AnyProduction*, Shown*> byProduction_;
  std::map<Peer*, Client> clients_;
};

} // namespace naocal
