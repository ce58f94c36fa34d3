#include "framework/network/BoundedLog.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace naocal {
namespace {

/// A bounded log, its sentences and its clock.
struct WatchedLog {
  std::vector<std::string> sentences;
  TimePoint now = TimePoint{} + std::chrono::hours{1};
  BoundedLog log{[this](std::string_view sentence) { sentences.emplace_back(sentence); }, [this] { return now; }};
};

} // namespace

TEST_CASE("a client's noise is logged once per cause") {
  // Proves that details, and what was found, make no new cause, that another cause and another client do, and that the
  // cause is told again after an hour, with the number of those left out; at the boundary.
  WatchedLog watched;
  for (int i = 0; i < 1000; ++i) {
    watched.log(fmt::format("Client 10.1.24.7: expected a request, found message type {}; closed.", i));
    watched.log(fmt::format("Client 10.1.24.7: refused without the secret: setting key: {} of Noise.", i));
  }
  CHECK(watched.sentences ==
        std::vector<std::string>{"Client 10.1.24.7: expected a request, found message type 0; closed.",
                                 "Client 10.1.24.7: refused without the secret: setting key: 0 of Noise."});
  watched.log("Client 10.1.24.7: expected a key, found none.");
  CHECK(watched.sentences.back() == "Client 10.1.24.7: expected a key, found none.");
  watched.log("Client 10.1.24.8: expected a key, found none.");
  CHECK(watched.sentences.back() == "Client 10.1.24.8: expected a key, found none.");
  watched.now += BoundedLog::repeat - std::chrono::milliseconds{1};
  watched.log("Client 10.1.24.7: expected a request, found nothing.");
  CHECK(watched.sentences.size() == 4);
  watched.now += std::chrono::milliseconds{1};
  watched.log("Client 10.1.24.7: expected a request, found nothing.");
  REQUIRE(watched.sentences.size() == 5);
  CHECK(watched.sentences.back() == "Client 10.1.24.7: expected a request, found nothing. (1000 like it were left out "
                                    "since the last one.)");
}

TEST_CASE("a client's many causes fill no log") {
  // Proves the number of causes at its boundary, the note that follows, the refill, and that another client's are
  // written.
  WatchedLog watched;
  for (int i = 0; i < 1000; ++i) {
    watched.log(fmt::format("Client 10.1.24.7: noise {}; the connection was closed.", i));
  }
  REQUIRE(watched.sentences.size() == std::size_t(BoundedLog::burst) + 1);
  CHECK(watched.sentences[BoundedLog::burst - 1] == "Client 10.1.24.7: noise 19; the connection was closed.");
  CHECK(watched.sentences.back() == "Client 10.1.24.7: further sentences about it are left out, but for one a minute.");
  watched.log("Client 10.1.24.8: other noise.");
  CHECK(watched.sentences.back() == "Client 10.1.24.8: other noise.");
  watched.now += BoundedLog::refill - std::chrono::milliseconds{1};
  watched.log("Client 10.1.24.7: too early.");
  CHECK(watched.sentences.back() == "Client 10.1.24.8: other noise.");
  watched.now += std::chrono::milliseconds{1};
  watched.log("Client 10.1.24.7: a minute later.");
  watched.log("Client 10.1.24.7: at once again.");
  CHECK(watched.sentences.back() == "Client 10.1.24.7: a minute later.");
}

TEST_CASE("clients of many addresses fill neither log nor memory") {
  // Proves it for a thousand addresses: beyond the limit they share the sentences of one, at its boundary.
  for (const bool isAlike : {true, false}) {
    CAPTURE(isAlike);
    WatchedLog watched;
    for (int i = 0; i < 1000; ++i) {
      watched.log(fmt::format("Client 10.1.{}.{}: noise{}.", i / 256, i % 256, isAlike ? "" : std::to_string(i)));
    }
    CHECK(watched.sentences.size() == BoundedLog::mostSubjects + (isAlike ? 1 : BoundedLog::burst + 1));
    CHECK(watched.sentences.back().starts_with(isAlike ? "Client 10.1.0.100: noise"
                                                       : "Further clients: further sentences"));
  }
}

TEST_CASE("a sentence of the log is one short line") {
  // Proves that control characters are escaped and long sentences are cut, at the boundary.
  WatchedLog watched;
  watched.log("Client a: \x1b]0;title\x07\n");
  CHECK(watched.sentences.back() == "Client a: \\x1b]0;title\\x07\\x0a");
  watched.log(std::string(BoundedLog::longestSentence, 'x'));
  CHECK(watched.sentences.back() == std::string(BoundedLog::longestSentence, 'x'));
  watched.log(std::string(BoundedLog::longestSentence + 1, 'y'));
  CHECK(watched.sentences.back() == std::string(BoundedLog::longestSentence, 'y') + "...");
}

} // namespace naocal
