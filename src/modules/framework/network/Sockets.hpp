#pragma once

#include "framework/configuration/ConfigurationLayers.hpp"
#include "framework/core/Clock.hpp"
#include "framework/network/Access.hpp"
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

/// Where and to whom the robot's sockets are open.
struct SocketSettings {
  AccessSettings access;
  bool tcp = true;
  std::uint16_t debugPort = 12441, configPort = 12442; // HULKs' numbers; 0: any that is free
  std::filesystem::path unixFolder;                    // of the UNIX sockets `debug` and `config`; empty: none
  std::size_t maxClients = 16;                         // of each server
  double messagesPerSecond = 1000;                     // of each client
};

/// Reads the settings from sdk.json (as shipped and as saved; keys as HULKs': network.basePort,
/// network.enableDebugTCPTransport, local.unixSocketDirectory, to which the head's name is added) and access.json.
/// Throws ConfigurationError.
SocketSettings readSocketSettings(const ConfigurationFolders& configuration, const std::string& headName);

/// Both servers on a thread of their own, over TCP and UNIX sockets. The threads' cycles only hand over copies of what
/// clients want to see.
class SocketServers {
public:
  /// Starts to listen. The threads must be wired and not run yet; the configuration must outlive it, and the threads
  /// must have ended before it. `base`: what timestamps count from. Throws ConfigurationError where it cannot listen.
  SocketServers(const SocketSettings& settings, const std::vector<Thread*>& threads, Configuration& configuration,
                TimePoint base, Log log);
  ~SocketServers();
  SocketServers(const SocketServers&) = delete;
  SocketServers& operator=(const SocketServers&) = delete;

  std::uint16_t debugPort() const;
  std::uint16_t configPort() const;

  /// Where clients find them: the end of a sentence.
  std::string addressText() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace naocal
