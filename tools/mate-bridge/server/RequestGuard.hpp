#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace naocal {

/// Properties of a request that identify its sender; empty if the header is missing.
struct RequestInfo {
  std::string_view method, target, host, origin, fetchSite; // fetchSite: Sec-Fetch-Site
  bool live = false;                                        // WebSocket upgrade
  bool visits = false;                                      // top-level navigation of a browser
};

/// Status and reason of a refused request.
struct Refusal {
  unsigned status = 403;
  std::string sentence;
};

/// 128 random bits from the system as 32 hexadecimal digits; grants access to the panel.
std::string makeToken();

/// Admits only the panel's own page: other users do not know the token, pages of other sites have another origin, and
/// DNS rebinding uses another host name.
class RequestGuard {
public:
  /// `port`: the panel's port on 127.0.0.1.
  RequestGuard(std::string token, std::uint16_t port);

  std::optional<Refusal> check(const RequestInfo& asked) const;

  /// The part of a target after the token: "" for "/TOKEN/", "live" for "/TOKEN/live".
  std::string_view pathOf(std::string_view target) const;

  /// URL of the panel: "http://127.0.0.1:PORT/TOKEN/".
  std::string address() const;

private:
  bool isHere(std::string_view host) const;

  std::string token_;
  std::uint16_t port_;
};

} // namespace naocal
