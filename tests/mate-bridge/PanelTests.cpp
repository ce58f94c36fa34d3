#include "Panel.hpp"

#include "protocol/JointOrder.hpp"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <thread>

using namespace naocal;
using Json = nlohmann::json;
using Catch::Contains;

namespace {

namespace websocket = boost::beast::websocket;

/// A bridge without captures and robots, and a connected page.
class Page {
public:
  Page() {
    const std::string address = panel_.address(), host = address.substr(7, address.find('/', 7) - 7);
    boost::asio::connect(socket_.next_layer(),
                         boost::asio::ip::tcp::resolver{context_}.resolve("127.0.0.1", host.substr(10)));
    socket_.set_option(websocket::stream_base::decorator(
        [host](websocket::request_type& request) { request.set("Origin", "http://" + host); }));
    socket_.handshake(host, address.substr(7 + host.size()) + "live");
  }
  ~Page() {
    panel_.stop();
    thread_.join();
  }

  /// Messages of the bridge in reply to a request, up to the reply to the next one.
  std::vector<Json> answers(const std::string& request) {
    const Json next{{"do", "stand"}, {"angles", Json::array()}, {"number", ++number_}};
    socket_.write(boost::asio::buffer(request));
    socket_.write(boost::asio::buffer(next.dump()));
    std::vector<Json> said;
    for (;;) {
      boost::beast::flat_buffer buffer;
      socket_.read(buffer);
      Json one = Json::parse(boost::beast::buffers_to_string(buffer.data()));
      if (one["kind"] == "stand" && one["number"] == number_) {
        return said;
      }
      said.push_back(std::move(one));
    }
  }
  /// The refusal's sentence; empty if the request was accepted.
  std::string refusal(const Json& request) { return refusalOf(request.dump()); }
  std::string refusalOf(const std::string& request) {
    for (const Json& one : answers(request)) {
      if (one["kind"] == "refused") {
        return one["sentence"];
      }
    }
    return "";
  }

private:
  Panel panel_{PanelOptions{}};
  std::thread thread_{[this] { panel_.run(); }};
  boost::asio::io_context context_;
  websocket::stream<boost::asio::ip::tcp::socket> socket_{context_};
  int number_ = 0;
};

} // namespace

TEST_CASE("what a page asks for goes by its verb, and what the bridge does not know is refused in words") {
  // Proves the refusals of unknown verbs, of verbs that need captures, and of malformed requests; the bridge keeps
  // replying.
  Page page;
  CHECK(page.refusal({{"do", "dance"}}) == "the bridge does not know how to do \"dance\"");
  for (const char* const verb : {"check", "add", "drop", "goTo", "define", "propose", "compare", "make"}) {
    CHECK(page.refusal({{"do", verb}}) == std::string{"the bridge does not know how to do \""} + verb + "\"");
  }
  for (const char* const request : {"{", "[]", "{}", R"({"do": 3})", R"({"do": "connect"})", R"({"do": "run"})"}) {
    CHECK_THAT(page.refusalOf(request), Contains("the bridge did not understand the panel"));
  }
  CHECK_THAT(page.refusal({{"do", "run"}, {"words", {"rm", "-r"}}}), Contains("expected one of naocal's commands"));
  CHECK_THAT(page.refusal({{"do", "connect"}, {"robot", "a b"}}), Contains("expected a robot's name"));
  CHECK_THAT(page.refusal({{"do", "importWrite"}}), Contains("expected a dropped table or URDF, found none"));
  CHECK_THAT(page.refusal({{"do", "importChoose"}, {"choices", {{"robot", "a.urdf"}}}}), Contains("found none"));
  CHECK(page.refusal({{"do", "importEnd"}}).empty());
  const std::vector<Json> ended = page.answers(R"({"do": "endRun"})");
  REQUIRE(ended.size() == 1);
  CHECK(ended[0]["kind"] == "errand");
}

TEST_CASE("a page that comes is told the order of joints") {
  // Proves that the first message lists the joints in the order of the robot's lists.
  Page page;
  const Json hello = page.answers(R"({"do": "dance"})").front();
  CHECK(hello["kind"] == "hello");
  REQUIRE(hello["joints"].size() == jointCount);
  CHECK(hello["joints"][*jointIndex("RKneePitch")] == "RKneePitch");
}

TEST_CASE("how a robot would stand is drawn for the angles that are given") {
  // Proves that the reply has the request's number and the outline of these angles.
  Page page;
  const std::vector<Json> said = page.answers(R"({"do": "stand", "angles": {"HeadYaw": 0.5}, "number": -3})");
  REQUIRE_FALSE(said.empty());
  CHECK(said.back()["number"] == -3);
  CHECK(said.back()["carries"] == "both");
}

TEST_CASE("what a page takes back of a robot that has gone is no mistake") {
  // Proves that cancelling a subscription of a disconnected robot is silent, and that other requests are refused.
  Page page;
  for (const char* const verb : {"unsubscribe", "unwatch"}) {
    CHECK(page.refusal({{"do", verb}, {"robot", "gone"}, {"key", "Brain.count"}}).empty());
  }
  for (const char* const verb : {"disconnect", "watch", "subscribe", "keys", "set", "save"}) {
    CHECK(page.refusal({{"do", verb}, {"robot", "gone"}}) ==
          std::string{"there is no robot gone to "} + verb + "; connect to it first");
  }
}
