#pragma once

#include "framework/network/Peer.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace naocal {

class Access;
class Configuration;

/// HULKs' configuration protocol: mounts, their keys, setting and saving. A value that cannot be set is a logged
/// sentence and the others of its message are set; there are no replies to SET and SAVE.
///
/// Three settings are ours and not listed: SET {"mp": "naocal.access", "key": "secret", "value": ..} shows that a
/// client may change the robot where it listens beyond this computer; {"mp": "naocal.configuration", "key": "undo",
/// "value": mount} undoes a mount's last save; "key": "lastWill", "value": [{"mp": .., "key": .., "value": ..}, ..] is
/// set when the client's connection ends, however it does, unless another client has set that key since: who starts a
/// robot thus has it stop when nobody can stop it any more. A new last will replaces the one before.
class ConfigServer final : public Protocol {
public:
  ConfigServer(Configuration& configuration, Access& access, Log log);
  ~ConfigServer() override;

  const FrameFormat& format() const override;
  void onOpened(Peer& peer) override;
  void onReceived(Peer& peer, std::uint8_t type, std::string body) override;
  void onClosed(Peer& peer) override;
  bool isTrusted(const Peer& peer) const override;

private:
  struct Setting;
  struct Client;                      // what is known of one
  Client& clientOf(const Peer& peer); // that has not left
  void set(Peer& peer, const std::string& body);
  void setOne(Peer& peer, const std::string& mount, const std::string& key, const nlohmann::json& value);
  void enter(Peer& peer, const nlohmann::json& secret);
  void forgetWills(const Peer& except, const std::string& mount, const std::string& key);
  void keepWill(const Peer& peer, const nlohmann::json& settings);
  void sendMounts(Peer& peer) const;
  void sendKeys(Peer& peer, const std::string& mount) const;
  /// Does it and logs what it throws, and a refusal to who may not.
  template <class Action> void change(const Peer& peer, std::string_view what, const Action& action);

  Configuration& configuration_;
  Access& access_;
  Log log_;
  ByPeer<Client> clients_;
};

} // namespace naocal
