#pragma once

#include "framework/Peer.hpp"

#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>

namespace naocal {

class Access;
class Configuration;

/// HULKs' configuration protocol: mounts, their keys, setting and saving. A value that cannot be set is a logged
/// sentence and the others of its message are set; there are no replies to SET and SAVE.
///
/// Two mounts are ours and not listed: SET {"mp": "naocal.access", "key": "secret", "value": ..} shows that a client
/// may change the robot where it listens beyond this computer; {"mp": "naocal.configuration", "key": "undo", "value":
/// mount} undoes a mount's last save.
class ConfigServer final : public Protocol {
public:
  ConfigServer(Configuration& configuration, Access& access, Log log);

  const FrameFormat& format() const override;
  void opened(Peer&) override {}
  void received(Peer& peer, std::uint8_t type, std::string body) override;
  void closed(Peer& peer) override;

private:
  void set(Peer& peer, const std::string& body);
  void setOne(Peer& peer, const std::string& mount, const std::string& key, const nlohmann::json& value);
  void enter(Peer& peer, const nlohmann::json& secret);
  void sendMounts(Peer& peer) const;
  void sendKeys(Peer& peer, const std::string& mount) const;
  /// Does it and logs what it throws, and a refusal to who may not.
  template <class Action> void change(const Peer& peer, std::string_view what, const Action& action) const;

  Configuration& configuration_;
  Access& access_;
  Log log_;
  std::set<const Peer*> entered_;
};

} // namespace naocal
