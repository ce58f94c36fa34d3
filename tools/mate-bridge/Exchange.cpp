#include "Exchange.hpp"

#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

namespace naocal {

namespace beast = boost::beast;
namespace http = boost::beast::http;

namespace {

std::string_view headerOf(const http::request<http::empty_body>& request, beast::string_view name) {
  const beast::string_view value = request[name];
  return {value.data(), value.size()};
}

} // namespace

Asked askedBy(const Exchange& exchange) {
  const auto& request = exchange.parser.get();
  const beast::string_view method = request.method_string(), target = request.target();
  const bool visits =
      headerOf(request, "Sec-Fetch-Mode") == "navigate" && headerOf(request, "Sec-Fetch-Dest") == "document";
  return {{method.data(), method.size()},
          {target.data(), target.size()},
          headerOf(request, "Host"),
          headerOf(request, "Origin"),
          headerOf(request, "Sec-Fetch-Site"),
          beast::websocket::is_upgrade(request),
          visits};
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
    exchange->stream.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  });
}

} // namespace naocal
