#include "framework/network/Access.hpp"

#include "framework/configuration/ConfigurationLayers.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// Constant-time comparison: its duration does not depend on the position of the first difference.
bool equal(std::string_view sent, std::string_view secret) {
  unsigned difference = sent.size() == secret.size() ? 0 : 1;
  for (std::size_t i = 0; i < sent.size() && !secret.empty(); ++i) {
    difference |= static_cast<unsigned char>(sent[i]) ^ static_cast<unsigned char>(secret[i % secret.size()]);
  }
  return difference == 0 && !secret.empty();
}

} // namespace

bool AccessSettings::listensWide() const {
  return !address.starts_with("127.") && address != "::1";
}

AccessSettings readAccess(const std::filesystem::path& configuration) {
  const auto file = configuration / "location" / "default" / "access.json";
  AccessSettings settings;
  if (const auto content = readConfiguration(file)) {
    for (const auto& [key, value] : content->items()) {
      if (key == "address" && value.is_string()) {
        settings.address = value;
      } else if (key == "secret" && value.is_string()) {
        settings.secret = value;
      } else if (key == "trustedNetwork" && value.is_boolean()) {
        settings.trustedNetwork = value;
      } else {
        throw ConfigurationError{
            fmt::format("{}: {}: expected only address and secret (texts) and trustedNetwork (true "
                        "or false)",
                        file.string(), key)};
      }
    }
  }
  if (settings.listensWide() && settings.secret.empty() && !settings.trustedNetwork) {
    throw ConfigurationError{fmt::format("{}: listening on {} lets others reach the robot; give a secret, or set "
                                         "trustedNetwork to true if everybody there may move it",
                                         file.string(), settings.address)};
  }
  return settings;
}

bool Access::needsSecret(const std::string& address) const {
  return !address.empty() && !settings_.trustedNetwork && settings_.listensWide();
}

bool Access::isOpen(const std::string& address) const {
  return !needsSecret(address) || entered_.contains(address);
}

bool Access::enter(const std::string& address, std::string_view secret) {
  if (!equal(secret, settings_.secret)) {
    return false;
  }
  if (++entered_[address] == 1 && opened_) {
    opened_(address);
  }
  return true;
}

void Access::leave(const std::string& address) {
  if (const auto entry = entered_.find(address); entry != entered_.end() && --entry->second == 0) {
    entered_.erase(entry);
  }
}

} // namespace naocal
