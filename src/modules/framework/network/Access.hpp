#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace naocal {

/// Who may reach the robot over the network: access.json. The file is not mounted, so no client can read its secret.
struct AccessSettings {
  std::string address = "127.0.0.1"; // to listen on: only this computer; 0.0.0.0: everybody who reaches it
  std::string secret;                // that clients must send where it listens wider
  bool trustedNetwork = false;       // everybody may do everything, as HULKs' robots allow (plain MATE)

  bool listensWide() const;
};

/// Reads location/default/access.json; the defaults where there is none. Throws ConfigurationError for a broken file,
/// and when it would listen wide with neither a secret nor `trustedNetwork`.
AccessSettings readAccess(const std::filesystem::path& configuration);

/// Which clients may do what. Clients on UNIX sockets and of a server that listens on this computer only may do
/// everything. Where it listens wider, a config connection may once it has sent the secret, and an address may look
/// once one of its config connections has, until the last such connection ends.
class Access {
public:
  explicit Access(AccessSettings settings) : settings_{std::move(settings)} {}

  bool needsSecret(const std::string& address) const;
  bool isOpen(const std::string& address) const; // needs none, or was opened

  /// Opens an address for as long as the connection that asks lasts, which then calls `leave`. False: wrong secret.
  bool enter(const std::string& address, std::string_view secret);
  void leave(const std::string& address);

  /// Called with an address that has just become open.
  void onOpened(std::function<void(const std::string& address)> opened) { opened_ = std::move(opened); }

private:
  AccessSettings settings_;
  std::map<std::string, int> entered_; // connections that have sent the secret, by address
  std::function<void(const std::string&)> opened_;
};

} // namespace naocal
