#include "server/RequestGuard.hpp"

#include <catch2/catch.hpp>

using namespace naocal;

namespace {

const std::string token = "0123456789abcdef0123456789abcdef";
const RequestGuard guard{token, 8123};

/// Request of the page's own script.
RequestInfo own() {
  return {
      "GET", "/0123456789abcdef0123456789abcdef/live", "127.0.0.1:8123", "http://127.0.0.1:8123", "same-origin", true,
      false};
}
unsigned refused(const RequestInfo& asked) {
  const auto refusal = guard.check(asked);
  return refusal ? refusal->status : 200;
}

} // namespace

TEST_CASE("the panel's own page is let in") {
  // Proves that page and live connection are accepted, with both names of this computer. That browsers send these
  // headers is not tested.
  CHECK(refused(own()) == 200);
  CHECK(guard.pathOf(own().target) == "live");
  RequestInfo page{"GET", "/0123456789abcdef0123456789abcdef/", "localhost:8123", "", "none", false, true};
  CHECK(refused(page) == 200);
  CHECK(guard.pathOf(page.target).empty());
}

TEST_CASE("pages of other origins and sites are refused") {
  // Proves that pages of other origins are refused even with the token, live or not, and without an Origin header too.
  for (const char* const origin : {"http://evil.example", "https://127.0.0.1:8123", "http://127.0.0.1:8124", "null",
                                   "http://127.0.0.1:8123.evil.example", "http://localhost"}) {
    RequestInfo asked = own();
    asked.origin = origin;
    CHECK(refused(asked) == 403);
    asked.live = false;
    CHECK(refused(asked) == 403);
  }
  for (const char* const site : {"cross-site", "same-site"}) {
    RequestInfo asked = own();
    asked.fetchSite = site;
    CHECK(refused(asked) == 403);
  }
  RequestInfo silent = own();
  silent.origin = silent.fetchSite = "";
  CHECK(refused(silent) == 403);
}

TEST_CASE("a person's browser may be led to the page, and to nothing else") {
  // Proves that another page with the token may navigate the window to the panel (as does the private file that
  // mate-bridge opens), but may not load its resources or embed it.
  RequestInfo visit{"GET", "/0123456789abcdef0123456789abcdef/", "127.0.0.1:8123", "", "cross-site", false, true};
  CHECK(refused(visit) == 200);
  visit.visits = false;
  CHECK(refused(visit) == 403);
  visit = {"GET", "/0123456789abcdef0123456789abcdef/panel.js", "127.0.0.1:8123", "", "cross-site", false, true};
  CHECK(refused(visit) == 403);
  visit = {"GET", "/0123456789abcdef0123456789abcdee/", "127.0.0.1:8123", "", "cross-site", false, true};
  CHECK(refused(visit) == 404);
}

TEST_CASE("a name that was bent to point here is refused") {
  // Proves that DNS rebinding fails: the browser sends the attacker's host name.
  for (const char* const host : {"evil.example:8123", "127.0.0.1", "127.0.0.1:80", "", "127.0.0.1:8123@evil.example"}) {
    RequestInfo asked = own();
    asked.host = host;
    CHECK(refused(asked) == 421);
  }
}

TEST_CASE("without the whole token there is nothing to find") {
  // Proves that shorter, longer and wrong tokens are refused. Constant time is not tested.
  for (const char* const target : {"/", "", "/live", "/0123456789abcdef0123456789abcde/live",
                                   "/0123456789abcdef0123456789abcdee/live", "/0123456789abcdef0123456789abcdef",
                                   "/0123456789abcdef0123456789abcdef0/live", "//0123456789abcdef0123456789abcdef/"}) {
    RequestInfo asked = own();
    asked.target = target;
    CHECK(refused(asked) == 404);
  }
}

TEST_CASE("only reading is allowed over HTTP") {
  // Proves that forms of other pages cannot post.
  RequestInfo asked = own();
  asked.live = false;
  asked.method = "POST";
  CHECK(refused(asked) == 405);
}

TEST_CASE("tokens differ and have 128 bits") {
  // Proves length and difference. Randomness relies on the system.
  CHECK(makeToken().size() == 32);
  CHECK(makeToken() != makeToken());
}
