#include "framework/network/Sockets.hpp"

#include "framework/configuration/ConfigurationLayers.hpp"
#include "framework/network/BoundedLog.hpp"
#include "framework/network/ConfigServer.hpp"
#include "framework/network/DebugServer.hpp"
#include "framework/network/Listener.hpp"
#include "framework/network/Outbox.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <thread>
#include <unistd.h>

namespace naocal {
namespace {

/// An outbox, and the descriptor that wakes the sockets' thread.
struct Mailbox {
  Mailbox(boost::asio::io_context& context, DebugServer& debugServer, boost::asio::thread_pool& encoders)
      : server{debugServer}, encoder{encoders}, descriptor{context, ::dup(outbox.descriptor())} {}

  void forward() {
    descriptor.async_wait(boost::asio::posix::stream_descriptor::wait_read, [this](const auto& stopped) {
      if (!stopped) {
        std::uint64_t count = 0;
        static_cast<void>(!::read(descriptor.native_handle(), &count, sizeof count)); // resets the counter
        sendNext();
      }
    });
  }

  DebugServer& server;
  boost::asio::thread_pool& encoder;
  Outbox outbox;
  boost::asio::posix::stream_descriptor descriptor;

private:
  /// Sends one report per turn. A separate thread encodes its images, so that the values of other threads and clients
  /// do not wait.
  void sendNext() {
    const std::shared_ptr<CycleReport> report = outbox.take();
    if (!report) {
      return forward();
    }
    const auto send = [this, report] {
      boost::asio::post(descriptor.get_executor(), [this] { sendNext(); }); // continues even if `send` throws
      server.send(*report);
    };
    const std::vector<CycleReport::Item*> pictures = server.picturesToEncode(*report);
    if (pictures.empty()) {
      return send();
    }
    boost::asio::post(encoder, [this, pictures, send] {
      std::exception_ptr failure;
      try {
        for (CycleReport::Item* item : pictures) {
          const auto sample = std::move(item->sample); // not retried after a failure
          item->picture = sample->image();
        }
      } catch (...) {
        failure = std::current_exception();
      }
      boost::asio::post(descriptor.get_executor(), [send, failure] {
        send();
        if (failure) {
          std::rethrow_exception(failure); // logged in `run`
        }
      });
    });
  }
};

ClientLimits debugLimits(const SocketSettings& settings) {
  return {
      .messagesPerSecond = settings.messagesPerSecond, .firstMessage = settings.firstMessage, .rest = settings.rest};
}

ClientLimits configLimits(const SocketSettings& settings) {
  ClientLimits limits = debugLimits(settings);
  limits.maxBodyBytes = 1 << 20;
  limits.unacknowledgedTimeout = std::chrono::seconds{6};
  return limits;
}

} // namespace

SocketSettings readSocketSettings(const ConfigurationFolders& configuration, const std::string& headName) {
  const Overlay sdk{layerFiles(configuration, "sdk.json", RobotPart::none, {})};
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

struct SocketServers::Implementation {
  Implementation(const SocketSettings& settings, const std::vector<Thread*>& threads, Configuration& configuration,
                 TimePoint base, Log unbounded)
      : bounded{std::move(unbounded)}, access{settings.access}, debug{threads, access, base}, config{configuration,
                                                                                                     access, log},
        debugListener{context, debug, {settings.maxClients, settings.keptPlaces}, debugLimits(settings), log},
        configListener{context, config, {settings.maxClients, settings.keptPlaces}, configLimits(settings), log} {
    access.onOpened([this](const std::string& address) { debug.sendListTo(address); });
    if (settings.tcp) {
      debugPort = debugListener.listenTcp(settings.access.address, settings.debugPort);
      configPort = configListener.listenTcp(settings.access.address, settings.configPort);
    }
    if (!settings.unixFolder.empty()) {
      debugListener.listenUnix(settings.unixFolder / "debug");
      configListener.listenUnix(settings.unixFolder / "config");
      unixFolder = settings.unixFolder;
    }
    for (Thread* cycling : threads) {
      Mailbox& mailbox = mailboxes.emplace_back(context, debug, encoder);
      mailbox.forward();
      cycling->setListener(mailbox.outbox);
    }
    boost::asio::post(encoder, runInBackground);
    thread = std::thread{[this] { run(); }};
  }

  ~Implementation() {
    context.stop();
    thread.join();
    encoder.stop();
    encoder.join();
  }

  void run() {
    runInBackground();
    for (;;) {
      try {
        context.run();
        return;
      } catch (const std::exception& error) {
        log(fmt::format("The sockets go on after an unexpected failure: {}.", error.what()));
      }
    }
  }

  BoundedLog bounded; // shared by all that the sockets' thread runs
  const Log log = [this](std::string_view sentence) { bounded(sentence); };
  Access access;
  DebugServer debug;
  ConfigServer config;
  boost::asio::io_context context{1};
  boost::asio::thread_pool encoder{1}; // encodes images
  Listener debugListener, configListener;
  std::deque<Mailbox> mailboxes;
  std::uint16_t debugPort = 0, configPort = 0; // 0: no TCP
  std::filesystem::path unixFolder;
  std::thread thread;
};

SocketServers::SocketServers(const SocketSettings& settings, const std::vector<Thread*>& threads,
                             Configuration& configuration, TimePoint base, Log log)
    : implementation_{std::make_unique<Implementation>(settings, threads, configuration, base, std::move(log))} {}
SocketServers::~SocketServers() = default;

std::uint16_t SocketServers::debugPort() const {
  return implementation_->debugPort;
}
std::uint16_t SocketServers::configPort() const {
  return implementation_->configPort;
}

std::string SocketServers::addressText() const {
  std::string result;
  if (implementation_->debugPort != 0) {
    result += fmt::format("; debug socket on port {}, configuration on port {}", debugPort(), configPort());
  }
  if (!implementation_->unixFolder.empty()) {
    result += fmt::format("; UNIX sockets in {}", implementation_->unixFolder.string());
  }
  return result;
}

} // namespace naocal
