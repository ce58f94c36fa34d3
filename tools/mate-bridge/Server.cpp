#include "Server.hpp"

#include "Exchange.hpp"
#include "Live.hpp"

#include "io/InputError.hpp"

#include <boost/asio/steady_timer.hpp>
#include <boost/beast/http/read.hpp>
#include <fmt/format.h>
#include <map>

namespace naocal {

namespace beast = boost::beast;
namespace http = boost::beast::http;
using Tcp = boost::asio::ip::tcp;

struct Server::Implementation : std::enable_shared_from_this<Implementation> {
  Implementation(boost::asio::io_context& context, std::uint16_t port, const std::string& token, ServerCalls given)
      : acceptor{context}, pause{context}, guard{token, port}, calls{std::move(given)} {
    try {
      const Tcp::endpoint here{boost::asio::ip::address_v4::loopback(), port};
      acceptor.open(here.protocol());
      acceptor.set_option(boost::asio::socket_base::reuse_address{true});
      acceptor.bind(here);
      acceptor.listen();
      guard = Guard{token, acceptor.local_endpoint().port()};
    } catch (const boost::system::system_error& error) {
      throw InputError{fmt::format("cannot listen on 127.0.0.1:{}: {}; choose another port, or 0 for any", port,
                                   error.code().message())};
    }
  }

  void accept() {
    acceptor.async_accept([self = shared_from_this()](beast::error_code error, Tcp::socket socket) {
      if (error == boost::asio::error::operation_aborted || !self->acceptor.is_open()) {
        return;
      }
      if (error) { // such as too many open files: others may end meanwhile
        self->pause.expires_after(std::chrono::milliseconds{100});
        self->pause.async_wait([self](beast::error_code stopped) {
          if (!stopped) {
            self->accept();
          }
        });
        return;
      }
      self->read(std::make_shared<Exchange>(std::move(socket)));
      self->accept();
    });
  }

  void read(const std::shared_ptr<Exchange>& exchange) {
    exchange->stream.expires_after(std::chrono::seconds{30});
    http::async_read(exchange->stream, exchange->buffer, exchange->parser,
                     [self = shared_from_this(), exchange](beast::error_code error, std::size_t) {
                       if (!error) {
                         self->answer(exchange);
                       }
                     });
  }

  void answer(const std::shared_ptr<Exchange>& exchange) {
    const Asked asked = askedBy(*exchange);
    if (const auto refusal = guard.refusal(asked)) {
      reply(exchange, {refusal->status, "text/plain; charset=utf-8", refusal->sentence + "\n"});
    } else if (!asked.live) {
      reply(exchange, calls.file(guard.pathOf(asked.target)));
    } else if (guard.pathOf(asked.target) == "live") {
      welcome(exchange);
    } else {
      reply(exchange, {404, "text/plain; charset=utf-8", "There is no live connection here.\n"});
    }
  }

  void welcome(const std::shared_ptr<Exchange>& exchange) {
    const std::size_t number = next++;
    const auto self = shared_from_this();
    const auto live = std::make_shared<Live>(
        std::move(exchange->stream),
        [self, number](std::string text) { self->calls.received(number, std::move(text)); },
        [self, number] {
          if (self->panels.erase(number) > 0) {
            self->calls.closed(number);
          }
        });
    live->accept(exchange->parser.get(), [self, number, live] {
      self->panels[number] = live;
      self->calls.opened(number);
    });
  }

  Tcp::acceptor acceptor;
  boost::asio::steady_timer pause;
  Guard guard;
  ServerCalls calls;
  std::map<std::size_t, std::shared_ptr<Live>> panels;
  std::size_t next = 0;
};

Server::Server(boost::asio::io_context& context, std::uint16_t port, const std::string& token, ServerCalls calls)
    : implementation_{std::make_shared<Implementation>(context, port, token, std::move(calls))} {
  implementation_->accept();
}

Server::~Server() {
  implementation_->acceptor.close();
  const auto panels = std::exchange(implementation_->panels, {});
  for (const auto& [number, live] : panels) {
    live->end();
  }
}

std::string Server::address() const {
  return implementation_->guard.address();
}

void Server::send(std::size_t panel, const Message& message) {
  if (const auto found = implementation_->panels.find(panel); found != implementation_->panels.end()) {
    const auto live = found->second;
    live->send(message);
  }
}

void Server::sendAll(const Message& message) {
  const auto panels = implementation_->panels; // who cannot keep up ends, and leaves the list
  for (const auto& [number, live] : panels) {
    live->send(message);
  }
}

} // namespace naocal
