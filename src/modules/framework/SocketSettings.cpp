#include "framework/ConfigurationLayers.hpp"
#include "framework/Errors.hpp"
#include "framework/Sockets.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

SocketSettings readSocketSettings(const ConfigurationFolders& configuration, const std::string& headName) {
  const Overlay sdk{layersOf(configuration, "sdk.json", Part::none, {})};
  const nlohmann::json& keys = *sdk.merged;
  const auto refuse = [&](const char* key, const char* expected) {
    throw ConfigurationError{fmt::format("{}: {}: expected {}", sdk.origins.at(key).string(), key, expected)};
  };
  SocketSettings settings;
  settings.access = readAccess(configuration.shipped);
  if (const auto port = keys.find("network.basePort"); port != keys.end()) {
    if (!port->is_number_integer() || *port < 1 || *port > 65533) {
      refuse("network.basePort", "a port number from 1 to 65533");
    }
    settings.debugPort = static_cast<std::uint16_t>(port->get<int>() + 1);
    settings.configPort = static_cast<std::uint16_t>(port->get<int>() + 2);
  }
  if (const auto tcp = keys.find("network.enableDebugTCPTransport"); tcp != keys.end()) {
    if (!tcp->is_boolean()) {
      refuse("network.enableDebugTCPTransport", "true or false");
    }
    settings.tcp = *tcp;
  }
  if (const auto folder = keys.find("local.unixSocketDirectory"); folder != keys.end()) {
    if (!folder->is_string()) {
      refuse("local.unixSocketDirectory", "the path of a folder, empty for no UNIX sockets");
    }
    if (const auto& path = folder->get_ref<const std::string&>(); !path.empty()) {
      settings.unixFolder = std::filesystem::path{path} / headName;
    }
  }
  return settings;
}

} // namespace naocal
