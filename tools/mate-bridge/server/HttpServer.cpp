#include "server/HttpServer.hpp"

#include "io/InputError.hpp"
#include "server/RequestGuard.hpp"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <charconv>
#include <deque>
#include <fmt/format.h>
#include <map>
#include <memory>

namespace naocal {

namespace {

/// One HTTP request: read, then answered, refused or upgraded to a WebSocket; not kept alive.
struct HttpExchange {
  explicit HttpExchange(boost::asio::ip::tcp::socket socket) : stream{std::move(socket)} {
    parser.header_limit(mostRequestHeader);
    parser.body_limit(0);
  }
  boost::beast::tcp_stream stream;
  boost::beast::flat_buffer buffer;
  boost::beast::http::request_parser<boost::beast::http::empty_body> parser;
  boost::beast::http::response<boost::beast::http::string_body> response;
};

namespace beast = boost::beast;
namespace http = boost::beast::http;
using Tcp = boost::asio::ip::tcp;

std::string_view headerOf(const http::request<http::empty_body>& request, beast::string_view name) {
  const beast::string_view value = request[name];
  return {value.data(), value.size()};
}

/// The properties of a request that the guard checks.
RequestInfo requestInfo(const HttpExchange& exchange) {
  const auto& request = exchange.parser.get();
  const beast::string_view method = request.method_string(), target = request.target();
  const bool visits =
      headerOf(request, "Sec-Fetch-Mode") == "navigate" && headerOf(request, "Sec-Fetch-Dest") == "document";
  return {{method.data(), method.size()},
          {target.data(), target.size()},
          request.count(http::field::host) == 1 ? headerOf(request, "Host") : std::string_view{}, // two: ambiguous
          headerOf(request, "Origin"),
          headerOf(request, "Sec-Fetch-Site"),
          beast::websocket::is_upgrade(request),
          visits};
}

/// Sends the response and closes the connection. A long response has more time, for a slow network.
void sendReply(const std::shared_ptr<HttpExchange>& exchange, HttpReply answer, std::chrono::milliseconds time) {
  constexpr std::size_t slowest = 100; // [bytes/ms], 100 kB/s
  exchange->stream.expires_after(time + std::chrono::milliseconds{answer.body.size() / slowest});
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
    exchange->stream.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  });
}

/// One panel's WebSocket. Never waits for a slow panel: drops images and live values; closes one that does not read
/// mandatory messages (it reconnects and gets everything).
class WebSocketSession : public std::enable_shared_from_this<WebSocketSession> {
public:
  using Closed = std::function<void()>;
  using Received = std::function<void(std::string)>;

  WebSocketSession(boost::beast::tcp_stream stream, Received received, Closed closed);

  void accept(const boost::beast::http::request<boost::beast::http::empty_body>& request, std::function<void()> opened);
  void send(const Message& message);
  void end();

private:
  void read();
  void write();

  boost::beast::websocket::stream<boost::beast::tcp_stream> socket_;
  Received received_;
  Closed closed_;
  boost::beast::flat_buffer buffer_;
  std::deque<Message> queue_; // the front is being written
  std::size_t owed_ = 0;      // queued [bytes]
  bool open_ = true;
};

WebSocketSession::WebSocketSession(boost::beast::tcp_stream stream, Received received, Closed closed)
    : socket_{std::move(stream)}, received_{std::move(received)}, closed_{std::move(closed)} {}

void WebSocketSession::accept(const boost::beast::http::request<boost::beast::http::empty_body>& request,
                              std::function<void()> opened) {
  auto& stream = boost::beast::get_lowest_layer(socket_);
  stream.expires_never();
  boost::beast::error_code gone;
  stream.socket().set_option(Tcp::no_delay{true}, gone); // no answer waits for the browser's acknowledgment
  socket_.set_option(
      boost::beast::websocket::stream_base::timeout::suggested(boost::beast::role_type::server)); // enables pings
  socket_.read_message_max(mostPanelMessage);
  socket_.async_accept(request,
                       [self = shared_from_this(), opened = std::move(opened)](boost::beast::error_code error) {
                         if (error) {
                           self->end();
                           return;
                         }
                         opened();
                         self->read();
                       });
}

void WebSocketSession::read() {
  socket_.async_read(buffer_, [self = shared_from_this()](boost::beast::error_code error, std::size_t) {
    if (error) {
      self->end();
      return;
    }
    std::string text = boost::beast::buffers_to_string(self->buffer_.data());
    self->buffer_.consume(self->buffer_.size());
    if (self->open_) {
      self->received_(std::move(text));
      self->read();
    }
  });
}

void WebSocketSession::send(const Message& message) {
  if (!open_ || (message.skippable && owed_ > mostPanelSkippable)) {
    return;
  }
  owed_ += message.bytes->size();
  if (owed_ > mostPanelPending) {
    end();
    return;
  }
  queue_.push_back(message);
  if (queue_.size() == 1) {
    write();
  }
}

void WebSocketSession::write() {
  socket_.binary(queue_.front().binary);
  socket_.async_write(boost::asio::buffer(*queue_.front().bytes),
                      [self = shared_from_this()](boost::beast::error_code error, std::size_t) {
                        if (error) {
                          self->end();
                          return;
                        }
                        self->owed_ -= self->queue_.front().bytes->size();
                        self->queue_.pop_front();
                        if (!self->queue_.empty() && self->open_) {
                          self->write();
                        }
                      });
}

void WebSocketSession::end() {
  if (open_) {
    open_ = false;
    boost::beast::get_lowest_layer(socket_).close();
    // Later: who sends to panels one after the other must not lose one meanwhile.
    boost::asio::post(socket_.get_executor(), [self = shared_from_this()] { self->closed_(); });
  }
}

} // namespace

struct HttpServer::Implementation : std::enable_shared_from_this<Implementation> {
  Implementation(boost::asio::io_context& context, std::uint16_t port, const std::string& token, ServerCallbacks given)
      : acceptor{context}, pause{context}, guard{token, port}, calls{std::move(given)} {
    try {
      const Tcp::endpoint here{boost::asio::ip::address_v4::loopback(), port};
      acceptor.open(here.protocol());
      acceptor.set_option(boost::asio::socket_base::reuse_address{true});
      acceptor.bind(here);
      acceptor.listen();
      guard = RequestGuard{token, acceptor.local_endpoint().port()};
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
      if (error) { // such as too many open files: retries after 100 ms
        self->pause.expires_after(std::chrono::milliseconds{100});
        self->pause.async_wait([self](beast::error_code stopped) {
          if (!stopped) {
            self->accept();
          }
        });
        return;
      }
      self->read(std::make_shared<HttpExchange>(std::move(socket)));
      self->accept();
    });
  }

  void read(const std::shared_ptr<HttpExchange>& exchange) {
    if (reading.size() >= mostRequests) { // idle connections must not use up the process's descriptors
      reading.front()->stream.close();
      reading.pop_front();
    }
    reading.push_back(exchange);
    exchange->stream.expires_after(calls.requestTime);
    http::async_read(exchange->stream, exchange->buffer, exchange->parser,
                     [self = shared_from_this(), exchange](beast::error_code error, std::size_t bytes) {
                       std::erase(self->reading, exchange);
                       if (!error && bytes <= mostRequestHeader) { // the parser counts from each part that arrives
                         self->answer(exchange);
                       }
                     });
  }

  void answer(const std::shared_ptr<HttpExchange>& exchange) {
    const RequestInfo asked = requestInfo(*exchange);
    if (const auto refusal = guard.check(asked)) {
      sendReply(exchange, {refusal->status, "text/plain; charset=utf-8", refusal->sentence + "\n"}, calls.requestTime);
    } else if (!asked.live) {
      sendReply(exchange, calls.file(guard.pathOf(asked.target)), calls.requestTime);
    } else if (guard.pathOf(asked.target) == "live" && panels.size() >= mostPanels) {
      sendReply(exchange,
                {503, "text/plain; charset=utf-8",
                 fmt::format("The panel is open {} times already, which is the limit.\n", mostPanels)},
                calls.requestTime);
    } else if (guard.pathOf(asked.target) == "live") {
      welcome(exchange);
    } else {
      sendReply(exchange, {404, "text/plain; charset=utf-8", "There is no live connection here.\n"}, calls.requestTime);
    }
  }

  void welcome(const std::shared_ptr<HttpExchange>& exchange) {
    const std::size_t number = next++;
    const auto self = shared_from_this();
    const auto live = std::make_shared<WebSocketSession>(
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
  RequestGuard guard;
  ServerCallbacks calls;
  std::deque<std::shared_ptr<HttpExchange>> reading; // oldest first
  std::map<std::size_t, std::shared_ptr<WebSocketSession>> panels;
  std::size_t next = 0;
};

HttpServer::HttpServer(boost::asio::io_context& context, std::uint16_t port, const std::string& token,
                       ServerCallbacks calls)
    : implementation_{std::make_shared<Implementation>(context, port, token, std::move(calls))} {
  implementation_->accept();
}

HttpServer::~HttpServer() {
  implementation_->acceptor.close();
  const auto panels = std::exchange(implementation_->panels, {});
  for (const auto& [number, live] : panels) {
    live->end();
  }
}

std::string HttpServer::address() const {
  return implementation_->guard.address();
}

void HttpServer::send(std::size_t panel, const Message& message) {
  if (const auto found = implementation_->panels.find(panel); found != implementation_->panels.end()) {
    found->second->send(message);
  }
}

void HttpServer::sendAll(const Message& message) {
  for (const auto& [number, live] : implementation_->panels) {
    live->send(message);
  }
}

std::string decodePercents(std::string_view path) {
  std::string plain;
  for (std::size_t i = 0; i < path.size(); ++i) {
    unsigned char byte = 0;
    const char* const code = path.data() + i + 1;
    if (path[i] == '%' && i + 2 < path.size() && std::from_chars(code, code + 2, byte, 16).ptr == code + 2) {
      plain += static_cast<char>(byte);
      i += 2;
    } else {
      plain += path[i];
    }
  }
  return plain;
}

} // namespace naocal
