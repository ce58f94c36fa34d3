#include "server/HttpServer.hpp"

#include "server/RequestGuard.hpp"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/field.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <catch2/catch.hpp>
#include <chrono>
#include <deque>
#include <fmt/format.h>
#include <future>
#include <semaphore>
#include <thread>
#include <vector>

using namespace naocal;
using Tcp = boost::asio::ip::tcp;
using Catch::Contains;

namespace {

/// A server that serves "the page" at its address.
struct Serving {
  explicit Serving(std::chrono::milliseconds requestTime = longestRequest)
      : server{context, 0, makeToken(), callbacks(requestTime)}, thread{[this] { context.run(); }} {}
  ~Serving() {
    context.stop();
    thread.join();
  }

  /// The server's reply to these bytes, until it closes or has sent `enough`.
  std::string answer(const std::string& request, const std::string& enough = "no end") const {
    const std::string address = server.address();
    const std::string port = address.substr(17, address.find('/', 17) - 17);
    boost::asio::io_context own;
    Tcp::socket socket{own};
    boost::asio::connect(socket, Tcp::resolver{own}.resolve("127.0.0.1", port));
    boost::asio::write(socket, boost::asio::buffer(request));
    std::string bytes;
    boost::system::error_code error;
    for (char byte = 0;
         bytes.find(enough) == std::string::npos && socket.read_some(boost::asio::buffer(&byte, 1), error) > 0;) {
      bytes += byte;
    }
    return bytes;
  }
  std::string host() const { return server.address().substr(7, server.address().find('/', 7) - 7); }
  std::string path() const { return server.address().substr(7 + host().size()); }
  std::string upgrade(const std::string& origin) const {
    return fmt::format("GET {}live HTTP/1.1\r\nHost: {}\r\nOrigin: {}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                       "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n",
                       path(), host(), origin);
  }

  ServerCallbacks callbacks(std::chrono::milliseconds requestTime) {
    return {[](std::string_view path) {
              return path.empty() ? HttpReply{200, "text/html", "the page"} : HttpReply{404, "text/plain", "nothing"};
            },
            [this](std::size_t) { opened.release(); }, [this](std::size_t) { closed.release(); },
            [this](std::size_t, const std::string& text) {
              received = text.size();
              told.release();
            },
            requestTime};
  }

  std::counting_semaphore<1000> opened{0}, closed{0}, told{0}; // panels, messages
  std::atomic<std::size_t> received = 0;                       // [bytes] of the last message
  boost::asio::io_context context;
  HttpServer server;
  std::thread thread;
};

/// An open panel's live connection.
struct LivePanel {
  explicit LivePanel(Serving& serving) : live{own} {
    const std::string host = serving.host();
    auto& socket = boost::beast::get_lowest_layer(live).socket();
    boost::asio::connect(socket, Tcp::resolver{own}.resolve("127.0.0.1", host.substr(host.find(':') + 1)));
    live.set_option(boost::beast::websocket::stream_base::decorator(
        [&](auto& request) { request.set(boost::beast::http::field::origin, "http://" + host); }));
    live.handshake(host, serving.path() + "live");
    serving.opened.acquire();
  }
  boost::asio::io_context own;
  boost::beast::websocket::stream<boost::beast::tcp_stream> live;
};

} // namespace

TEST_CASE("the page is served with a policy that lets nothing from elsewhere in") {
  // Proves status, body and security headers; their effect is tested in a browser.
  const Serving serving;
  const std::string answer =
      serving.answer(fmt::format("GET {} HTTP/1.1\r\nHost: {}\r\n\r\n", serving.path(), serving.host()));
  CHECK_THAT(answer, Contains("200 OK") && Contains("the page"));
  CHECK_THAT(answer, Contains("default-src 'none'") && Contains("frame-ancestors 'none'") && Contains("nosniff") &&
                         Contains("Cross-Origin-Resource-Policy: same-origin") && Contains("no-referrer"));
  CHECK_THAT(serving.answer(fmt::format("GET / HTTP/1.1\r\nHost: {}\r\n\r\n", serving.host())), Contains("404"));
  CHECK_THAT(serving.answer(fmt::format("GET {} HTTP/1.1\r\nHost: evil.example\r\n\r\n", serving.path())),
             Contains("421"));
}

TEST_CASE("a live connection is refused to other origins") {
  // Proves it at the socket, with the correct token: 101 switches protocols, 403 refuses.
  const Serving serving;
  CHECK_THAT(serving.answer(serving.upgrade("http://" + serving.host()), "\r\n\r\n"),
             Contains("101 Switching Protocols"));
  CHECK_THAT(serving.answer(serving.upgrade("http://evil.example")), Contains("403") && !Contains("101"));
  CHECK_THAT(serving.answer(serving.upgrade("null")), Contains("403"));
}

TEST_CASE("a request with two hosts is refused") {
  // Proves it for the right host twice and for another one beside it: servers disagree about which one counts.
  const Serving serving;
  for (const std::string& other : {serving.host(), std::string{"evil.example"}}) {
    CHECK_THAT(serving.answer(fmt::format("GET {} HTTP/1.1\r\nHost: {}\r\nHost: {}\r\n\r\n", serving.path(),
                                          serving.host(), other)),
               Contains("421"));
  }
}

TEST_CASE("idle connections keep nobody from the page") {
  // Proves it at the boundary: as many idle connections as are read at once stay open, and a request that follows is
  // answered at the cost of the oldest one.
  const Serving serving;
  boost::asio::io_context own;
  const std::string port = serving.host().substr(serving.host().find(':') + 1);
  std::deque<Tcp::socket> idle;
  for (std::size_t i = 0; i < mostRequests; ++i) {
    boost::asio::connect(idle.emplace_back(own), Tcp::resolver{own}.resolve("127.0.0.1", port));
  }
  const std::string page = fmt::format("GET {} HTTP/1.1\r\nHost: {}\r\n\r\n", serving.path(), serving.host());
  boost::asio::write(idle.back(), boost::asio::buffer(page)); // all are accepted once it is answered
  char byte = 0;
  CHECK(boost::asio::read(idle.back(), boost::asio::buffer(&byte, 1)) == 1);
  boost::asio::connect(idle.emplace_back(own), Tcp::resolver{own}.resolve("127.0.0.1", port));
  idle.front().non_blocking(true);
  boost::system::error_code error;
  CHECK(idle.front().read_some(boost::asio::buffer(&byte, 1), error) == 0);
  CHECK(error == boost::asio::error::would_block);
  CHECK_THAT(serving.answer(page), Contains("the page"));
  idle.front().non_blocking(false);
  CHECK(idle.front().read_some(boost::asio::buffer(&byte, 1), error) == 0);
  CHECK(error == boost::asio::error::eof);
}

TEST_CASE("a panel can be open a limited number of times") {
  // Proves the boundary: the last connection that is allowed is upgraded, the next one told why not.
  const Serving serving;
  boost::asio::io_context own;
  const std::string port = serving.host().substr(serving.host().find(':') + 1);
  std::deque<Tcp::socket> open;
  for (std::size_t i = 0; i < mostPanels; ++i) {
    boost::asio::connect(open.emplace_back(own), Tcp::resolver{own}.resolve("127.0.0.1", port));
    boost::asio::write(open.back(), boost::asio::buffer(serving.upgrade("http://" + serving.host())));
    std::string start(12, ' ');
    boost::asio::read(open.back(), boost::asio::buffer(start));
    CHECK(start == "HTTP/1.1 101");
  }
  CHECK_THAT(serving.answer(serving.upgrade("http://" + serving.host())),
             Contains("503") && Contains("open 16 times already"));
}

TEST_CASE("a request's header has a limited size") {
  // Proves the boundary: the largest header is answered, one of a byte more is not.
  const Serving serving;
  const std::string start = fmt::format("GET {} HTTP/1.1\r\nHost: {}\r\nX: ", serving.path(), serving.host());
  const auto sized = [&](std::size_t bytes) { return start + std::string(bytes - start.size() - 4, 'x') + "\r\n\r\n"; };
  CHECK_THAT(serving.answer(sized(mostRequestHeader)), Contains("200 OK"));
  CHECK_THAT(serving.answer(sized(mostRequestHeader + 1)), !Contains("200 OK"));
}

TEST_CASE("a request that takes too long is closed") {
  // Proves with a short limit that an unfinished request is closed after that time and not before.
  const std::chrono::milliseconds most{200};
  const Serving serving{most};
  const auto begin = std::chrono::steady_clock::now();
  CHECK(serving.answer("GET / HTTP/1.1\r\n").empty());
  CHECK(std::chrono::steady_clock::now() - begin >= most);
}

TEST_CASE("a panel's message has a limited size") {
  // Proves the boundary: the largest message arrives, one of a byte more closes the panel.
  Serving serving;
  LivePanel panel{serving};
  panel.live.write(boost::asio::buffer(std::string(mostPanelMessage, 'x')));
  serving.told.acquire();
  CHECK(serving.received == mostPanelMessage);
  boost::system::error_code error;
  panel.live.write(boost::asio::buffer(std::string(mostPanelMessage + 1, 'x')), error);
  boost::beast::flat_buffer answer;
  panel.live.read(answer, error);
  CHECK(error.failed());
  CHECK(panel.live.reason().code == boost::beast::websocket::close_code::too_big);
  boost::beast::get_lowest_layer(panel.live).close();
  serving.closed.acquire();
  CHECK_FALSE(serving.told.try_acquire());
}

TEST_CASE("what is queued for a panel that does not read is bounded") {
  // Proves that pictures are left out once more than their limit is queued, that other messages are kept up to theirs,
  // and that a byte more closes the panel. The messages share their bytes.
  Serving serving;
  LivePanel panel{serving};
  const Message quarter = makeMessage(std::string(mostPanelPending / 4, 'x'), true);
  const Message picture = makeMessage(std::string(mostPanelPending / 4, 'p'), true, true);
  const auto send = [&](const std::vector<Message>& messages) {
    std::promise<void> sent;
    boost::asio::post(serving.context, [&] {
      for (const Message& message : messages) {
        serving.server.sendAll(message);
      }
      sent.set_value();
    });
    sent.get_future().wait();
  };
  send({quarter, picture, quarter, picture, quarter, quarter}); // the system takes no whole one of them
  CHECK_FALSE(serving.closed.try_acquire());
  send({makeMessage("x")});
  CHECK(serving.closed.try_acquire_for(std::chrono::seconds{10})); // its reader ends later
}

TEST_CASE("what is no HTTP is closed without harm") {
  // Proves it for random bytes and an oversized header; the server then serves the next request.
  const Serving serving;
  CHECK(serving.answer(std::string(100, '\xff') + "\r\n\r\n").find("200") == std::string::npos);
  CHECK(serving.answer("GET / HTTP/1.1\r\nX: " + std::string(20000, 'x')).find("200") == std::string::npos);
  CHECK_THAT(serving.answer(fmt::format("GET {} HTTP/1.1\r\nHost: {}\r\n\r\n", serving.path(), serving.host())),
             Contains("200"));
}

TEST_CASE("codes in an address are letters again") {
  // Proves it for spaces and umlauts in the encoding of browsers, and that invalid codes are unchanged.
  CHECK(decodePercents("a%20robot/%C3%BCbung/3") == "a robot/\u00fcbung/3");
  CHECK(decodePercents("100%/%zz%4") == "100%/%zz%4");
}
