#include "Server.hpp"

#include "Guard.hpp"
#include "Live.hpp"

#include "captures/InputError.hpp"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <fmt/format.h>
#include <map>

namespace naocal {

namespace beast = boost::beast;
namespace http = boost::beast::http;
using Tcp = boost::asio::ip::tcp;

namespace {

/// One request of a browser: read, and answered, refused or made live; then it ends.
struct Exchange {
  explicit Exchange(Tcp::socket socket) : stream{std::move(socket)} {
    parser.header_limit(16 << 10);
    parser.body_limit(0);
  }
  beast::tcp_stream stream;
  beast::flat_buffer buffer;
  http::request_parser<http::empty_body> parser;
  http::response<http::string_body> response;
};

std::string_view headerOf(const http::request<http::empty_body>& request, beast::string_view name) {
  const beast::string_view value = request[name];
  return {value.data(), value.size()};
}

Asked askedBy(const http::request<http::empty_body>& request) {
  const beast::string_view method = request.method_string(), target = request.target();
  return {{method.data(), method.size()}, {target.data(), target.size()},      headerOf(request, "Host"),
          headerOf(request, "Origin"),    headerOf(request, "Sec-Fetch-Site"), beast::websocket::is_upgrade(request)};
}

void reply(const std::shared_ptr<Exchange>& exchange, Answer answer) {
  auto& response = exchange->response;
  response.result(answer.status);
  response.set(http::field::content_type, answer.type);
  response.set(http::field::cache_control, "no-store");
  response.set("Content-Security-Policy",
               "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; "
               "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'");
  response.set("X-Content-Type-Options", "nosniff");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  response.set("Cross-Origin-Opener-Policy", "same-origin");
  response.body() = std::move(answer.body);
  response.keep_alive(false);
  response.prepare_payload();
  http::async_write(exchange->stream, response, [exchange](beast::error_code, std::size_t) {
    beast::error_code ignored;
    exchange->stream.socket().shutdown(Tcp::socket::shutdown_send, ignored);
  });
}

} // namespace

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
    const auto& request = exchange->parser.get();
    const Asked asked = askedBy(request);
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
