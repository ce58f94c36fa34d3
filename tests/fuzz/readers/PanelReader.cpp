#include "Panel.hpp"
#include "fuzz/driver/Reader.hpp"
#include "fuzz/readers/PageMessages.hpp"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <csignal>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

namespace naocal {
namespace {

using Json = nlohmann::json;
namespace websocket = boost::beast::websocket;

/// A bridge without captures and robots, and a connected page.
class Page {
public:
  Page() {
    std::signal(SIGINT, SIG_DFL); // the panel waits for it; a user who ends the fuzzer means the fuzzer
    std::signal(SIGTERM, SIG_DFL);
    sigset_t alarm{}; // libFuzzer's clock, which would interrupt reads; the panel's thread takes it
    sigaddset(&alarm, SIGALRM);
    pthread_sigmask(SIG_BLOCK, &alarm, nullptr);
    const std::string address = panel_.address(), host = address.substr(7, address.find('/', 7) - 7);
    boost::asio::connect(socket_.next_layer(),
                         boost::asio::ip::tcp::resolver{context_}.resolve("127.0.0.1", host.substr(10)));
    socket_.next_layer().set_option(boost::asio::ip::tcp::no_delay{true});
    socket_.set_option(websocket::stream_base::decorator(
        [host](websocket::request_type& request) { request.set("Origin", "http://" + host); }));
    socket_.handshake(host, address.substr(7 + host.size()) + "live");
    socket_.binary(true); // bytes that are no UTF-8 arrive as well
  }
  ~Page() {
    panel_.stop();
    thread_.join();
  }

  void send(const std::string& message) { socket_.write(boost::asio::buffer(message)); }

  /// Waits until the bridge has handled all messages.
  void finish() {
    const Json last{{"do", "stand"}, {"angles", Json::array()}, {"number", "last " + std::to_string(++number_)}};
    send(last.dump());
    for (Json answer = Json::object(); answer.value("number", Json()) != last["number"];) {
      boost::beast::flat_buffer buffer;
      socket_.read(buffer);
      answer = Json::parse(boost::beast::buffers_to_string(buffer.data()));
    }
  }

private:
  Panel panel_{PanelOptions{}};
  std::thread thread_{[this] { panel_.run(); }};
  boost::asio::io_context context_;
  websocket::stream<boost::asio::ip::tcp::socket> socket_{context_};
  int number_ = 0;
};

/// Whether a message may have effects outside the bridge: on files, other programs or the network.
bool reachesOut(const Json& message) {
  static const std::set<Json> verbs{"run",     "connect",    "open",       "compare",     "importChoose",
                                    "openRun", "findRobots", "startRobot", "importWrite", "sample"};
  return message.is_object() && verbs.contains(message.value("do", Json()));
}

/// Every line is a message of a page to a bridge without captures.
void handleMessages(std::string_view bytes) {
  static Page page;
  for (const auto& [line, content] : pageMessages(bytes)) {
    if (!reachesOut(content)) {
      page.send(line);
    }
  }
  page.finish();
}

const Reader panelReader{"panel", handleMessages};

} // namespace
} // namespace naocal
