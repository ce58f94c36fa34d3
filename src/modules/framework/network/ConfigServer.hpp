#pragma once

#include "framework/network/Peer.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace naocal {

class Access;
class Configuration;

/// HULKs' configuration protocol: lists mounts and keys, sets and saves values. If a value cannot be set, a sentence is
/// logged and the other values of the message are still set; SET and SAVE have no replies.
///
/// Three extensions, not listed: SET {"mp": "naocal.access", "key": "secret", "value": ..} authenticates a client where
/// the server listens beyond this computer. {"mp": "naocal.configuration", "key": "undo", "value": mount} undoes a
/// mount's last save. "key": "lastWill", "value": [{"mp": .., "key": .., "value": ..}, ..] is applied when the client's
/// connection ends for any reason, except for keys that another client has set since; it stops a robot whose operator
/// loses the connection. A new last will replaces the previous one.
class ConfigServer final : public Protocol {
public:
  ConfigServer(Configuration& configuration, Access& access, Log log);
  ~ConfigServer() override;

  const FrameFormat& format() const override;
  void onOpened(Peer& peer) override;
  void onReceived(Peer& peer, std::uint8_t type, std::string body) override;
  void onClosed(Peer& peer) override;
  bool continueMessage(Peer& peer) override;
  bool isTrusted(const Peer& peer) const override;
  bool needsSecret(const std::string& address) const override;
  bool isInUse(const Peer& peer) const override;     // has left a last will
  bool mayBeSilent(const Peer& peer) const override; // MATE sends nothing more after its first requests

  static constexpr std::size_t mostSettings = 1000;  // of one message
  static constexpr std::size_t settingsPerTurn = 20; // set before other clients are served
  static constexpr std::size_t mostWillSettings = 100;

private:
  struct Setting;
  struct Client;                      // state of one connection
  Client& clientOf(const Peer& peer); // the connection must not have ended
  void set(Peer& peer, const std::string& body);
  void setOne(Peer& peer, const std::string& mount, const std::string& key, const nlohmann::json& value);
  void enter(Peer& peer, const nlohmann::json& secret);
  void forgetWills(const Peer& except, const std::string& mount, const std::string& key);
  void keepWill(const Peer& peer, const nlohmann::json& settings);
  void sendMounts(Peer& peer) const;
  void sendKeys(Peer& peer, const std::string& mount) const;
  /// Runs `action` and logs its exception; logs a refusal (once) if the client may not change anything.
  template <class Action> void change(const Peer& peer, std::string_view what, const Action& action);

  Configuration& configuration_;
  Access& access_;
  Log log_;
  ByPeer<Client> clients_;
};

} // namespace naocal
