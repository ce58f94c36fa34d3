#pragma once

#include "Guard.hpp"
#include "Server.hpp"

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <memory>

/// Heavy (Boost.Beast): included by Exchange.cpp and Server.cpp only.
namespace naocal {

/// One request of a browser: read, and answered, refused or made live; then it ends.
struct Exchange {
  explicit Exchange(boost::asio::ip::tcp::socket socket) : stream{std::move(socket)} {
    parser.header_limit(16 << 10);
    parser.body_limit(0);
  }
  boost::beast::tcp_stream stream;
  boost::beast::flat_buffer buffer;
  boost::beast::http::request_parser<boost::beast::http::empty_body> parser;
  boost::beast::http::response<boost::beast::http::string_body> response;
};

/// What the guard must know of a request that was read.
Asked askedBy(const Exchange& exchange);

/// Sends the answer and ends the exchange.
void reply(const std::shared_ptr<Exchange>& exchange, Answer answer);

} // namespace naocal
