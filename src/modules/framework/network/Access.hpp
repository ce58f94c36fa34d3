#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace naocal {

/// Network access to the robot: access.json. The file is not mounted, so clients cannot read the secret.
struct AccessSettings {
  std::string address = "127.0.0.1"; // listening address; 127.0.0.1: this computer only; 0.0.0.0: all interfaces
  std::string secret;                // required from clients when listening beyond this computer
  bool trustedNetwork = false;       // no secret needed, as on HULKs' robots (plain MATE)

  bool listensWide() const;
};

/// Reads location/default/access.json; defaults if it does not exist. Throws ConfigurationError for a broken file, and
/// for an address beyond this computer with neither a secret nor `trustedNetwork`.
AccessSettings readAccess(const std::filesystem::path& configuration);

/// Access control by client address. Clients on UNIX sockets, and all clients of a server that listens on this computer
/// only, may do everything. Otherwise a config connection needs the secret; its address may then read debug data until
/// the last config connection that has sent the secret ends.
class Access {
public:
  explicit Access(AccessSettings settings) : settings_{std::move(settings)} {}

  bool needsSecret(const std::string& address) const;
  bool isOpen(const std::string& address) const; // needs no secret, or the secret was sent

  /// Opens an address if the secret is right; the connection must call `leave` when it ends. False: wrong secret.
  bool enter(const std::string& address, std::string_view secret);
  void leave(const std::string& address);

  /// Sets the callback for an address that has just been opened.
  void onOpened(std::function<void(const std::string& address)> opened) { opened_ = std::move(opened); }

private:
  AccessSettings settings_;
  std::map<std::string, int> entered_; // number of connections that have sent the secret, by address
  std::function<void(const std::string&)> opened_;
};

} // namespace naocal
