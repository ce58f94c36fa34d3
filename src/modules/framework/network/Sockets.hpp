#pragma once

#include "framework/configuration/ConfigurationLayers.hpp"
#include "framework/core/Clock.hpp"
#include "framework/network/Access.hpp"
#include "framework/network/ClientLimits.hpp"
#include "framework/network/Peer.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace naocal {

class Configuration;
class Thread;

/// Addresses, ports and limits of the robot's sockets.
struct SocketSettings {
  AccessSettings access;
  bool tcp = true;
  std::uint16_t debugPort = 12441, configPort = 12442; // HULKs' ports; 0: any free one
  std::filesystem::path unixFolder;                    // folder of the UNIX sockets `debug` and `config`; empty: none
  std::size_t maxClients = 16;                         // per server
  double messagesPerSecond = 1000;                     // per client
  std::size_t keptPlaces = 4;                          // per server, beyond `maxClients` (Listener)
  std::chrono::milliseconds firstMessage = ClientLimits{}.firstMessage, rest = ClientLimits{}.rest;
};

/// Reads sdk.json (shipped and saved layers; HULKs' keys: network.basePort, network.enableDebugTCPTransport,
/// local.unixSocketDirectory, to which the head's name is appended) and access.json. Throws ConfigurationError.
SocketSettings readSocketSettings(const ConfigurationFolders& configuration, const std::string& headName);

/// Debug and config server on their own thread, over TCP and UNIX sockets. The cycles of the other threads only copy
/// subscribed values.
class SocketServers {
public:
  /// Starts to listen. The caller guarantees that the threads are wired and not started, that the configuration
  /// outlives this object, and that the threads end before it. `base`: origin of timestamps. Throws ConfigurationError
  /// if it cannot listen.
  SocketServers(const SocketSettings& settings, const std::vector<Thread*>& threads, Configuration& configuration,
                TimePoint base, Log log);
  ~SocketServers();
  SocketServers(const SocketServers&) = delete;
  SocketServers& operator=(const SocketServers&) = delete;

  std::uint16_t debugPort() const;
  std::uint16_t configPort() const;

  /// Ports and UNIX socket folder, formatted as the end of a sentence.
  std::string addressText() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace naocal
