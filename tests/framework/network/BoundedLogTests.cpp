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

TEST_CASE("a client's noise fills no log") {
  // Proves the number of sentences at its boundary, the note that follows, the refill, and that another client's are
  // written.
  WatchedLog watched;
  for (int i = 0; i < 1000; ++i) {
    watched.log("Client 10.1.24.7: noise; the connection was closed.");
  }
  REQUIRE(watched.sentences.size() == std::size_t(BoundedLog::burst) + 1);
  CHECK(watched.sentences[BoundedLog::burst - 1] == "Client 10.1.24.7: noise; the connection was closed.");
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
  // Proves it for a thousand addresses: beyond the limit they share the sentences of one.
  WatchedLog watched;
  for (int i = 0; i < 1000; ++i) {
    watched.log(fmt::format("Client 10.1.{}.{}: noise.", i / 256, i % 256));
  }
  CHECK(watched.sentences.size() == BoundedLog::mostSubjects + BoundedLog::burst + 1);
  CHECK(watched.sentences.back().starts_with("Further clients: further sentences"));
}

TEST_CASE("a sentence of the log is one short line") {
  // Proves that control characters are escaped and long sentences are cut, at the boundary.
  WatchedLog watched;
  watched.log("Client a: \x1b]0;title\x07\n");
  CHECK(watched.sentences.back() == "Client a: \\x1b]0;title\\x07\\x0a");
  watched.log(std::string(BoundedLog::longestSentence, 'x'));
  CHECK(watched.sentences.back() == std::string(BoundedLog::longestSentence, 'x'));
  watched.log(std::string(BoundedLog::longestSentence + 1, 'x'));
  CHECK(watched.sentences.back() == std::string(BoundedLog::longestSentence, 'x') + "...");
}

} // namespace naocal
