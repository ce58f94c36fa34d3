#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace naocal {

/// What of a request says who sent it; empty where the header is missing.
struct RequestInfo {
  std::string_view method, target, host, origin, fetchSite; // fetchSite: Sec-Fetch-Site
  bool live = false;                                        // wants a WebSocket
  bool visits = false;                                      // a person's browser goes there as a whole
};

/// Why a request is not answered.
struct Refusal {
  unsigned status = 403;
  std::string sentence;
};

/// 128 random bits from the system as 32 letters: whoever knows them may use the panel.
std::string makeToken();

/// Lets only the panel's own page in: other programs' users do not know the token, other sites' pages have another
/// origin, and names that were bent to point here (DNS rebinding) are not this host's.
class RequestGuard {
public:
  /// `port`: where the panel listens on 127.0.0.1.
  RequestGuard(std::string token, std::uint16_t port);

  std::optional<Refusal> check(const RequestInfo& asked) const;

  /// The part of a target behind the token: "" for "/TOKEN/", "live" for "/TOKEN/live".
  std::string_view pathOf(std::string_view target) const;

  /// What a person opens: "http://127.0.0.1:PORT/TOKEN/".
  std::string address() const;

private:
  bool isHere(std::string_view host) const;

  std::string token_;
  std::uint16_t port_;
};

} // namespace naocal
