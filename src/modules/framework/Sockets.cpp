#include "framework/Sockets.hpp"

#include "framework/ConfigServer.hpp"
#include "framework/DebugServer.hpp"
#include "framework/Listener.hpp"
#include "framework/Outbox.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/post.hpp>
#include <fmt/format.h>
#include <thread>
#include <unistd.h>

namespace naocal {
namespace {

/// An outbox and the descriptor by which it wakes the sockets' thread.
struct Mailbox {
  explicit Mailbox(boost::asio::io_context& context) : descriptor{context, ::dup(outbox.descriptor())} {}

  Outbox outbox;
  boost::asio::posix::stream_descriptor descriptor;

  void forward(DebugServer& server) {
    descriptor.async_wait(boost::asio::posix::stream_descriptor::wait_read, [this, &server](const auto& stopped) {
      if (!stopped) {
        std::uint64_t count = 0;
        static_cast<void>(!::read(descriptor.native_handle(), &count, sizeof count)); // rests until the next report
        sendNext(server);
      }
    });
  }

private:
  /// One report a turn: a picture that takes long keeps neither the other thread's values nor clients waiting.
  void sendNext(DebugServer& server) {
    if (const auto report = outbox.take()) {
      server.send(*report);
      boost::asio::post(descriptor.get_executor(), [this, &server] { sendNext(server); });
    } else {
      forward(server);
    }
  }
};

} // namespace

struct Sockets::Implementation {
  Implementation(const SocketSettings& settings, const std::vector<Thread*>& threads, Configuration& configuration,
                 TimePoint base, const Log& log)
      : access{settings.access}, debug{threads, access, base}, config{configuration, access, log},
        debugListener{context, debug, settings.mostClients, {.messagesPerSecond = settings.messagesPerSecond}, log},
        configListener{context, config, settings.mostClients, {.messagesPerSecond = settings.messagesPerSecond}, log} {
    access.onOpened([this](const std::string& address) { debug.listTo(address); });
    if (settings.tcp) {
      debugPort = debugListener.listenTcp(settings.access.address, settings.debugPort);
      configPort = configListener.listenTcp(settings.access.address, settings.configPort);
    }
    if (!settings.unixFolder.empty()) {
      debugListener.listenUnix(settings.unixFolder / "debug");
      configListener.listenUnix(settings.unixFolder / "config");
    }
    for (Thread* cycling : threads) {
      Mailbox& mailbox = mailboxes.emplace_back(context);
      mailbox.forward(debug);
      cycling->tell(mailbox.outbox);
    }
    thread = std::thread{[this, log] { run(log); }};
  }

  ~Implementation() {
    context.stop();
    thread.join();
  }

  void run(const Log& log) {
    for (;;) {
      try {
        context.run();
        return;
      } catch (const std::exception& error) {
        log(fmt::format("The sockets go on after an unexpected failure: {}.", error.what()));
      }
    }
  }

  Access access;
  DebugServer debug;
  ConfigServer config;
  boost::asio::io_context context{1};
  Listener debugListener, configListener;
  std::deque<Mailbox> mailboxes;
  std::uint16_t debugPort = 0, configPort = 0;
  std::thread thread;
};

Sockets::Sockets(const SocketSettings& settings, const std::vector<Thread*>& threads, Configuration& configuration,
                 TimePoint base, Log log)
    : implementation_{std::make_unique<Implementation>(settings, threads, configuration, base, log)} {}
Sockets::~Sockets() = default;

std::uint16_t Sockets::debugPort() const {
  return implementation_->debugPort;
}
std::uint16_t Sockets::configPort() const {
  return implementation_->configPort;
}

} // namespace naocal
