#include "server/RequestGuard.hpp"

#include <fmt/format.h>
#include <openssl/crypto.h>
#include <openssl/rand.h>
#include <stdexcept>

namespace naocal {

std::string makeToken() {
  unsigned char random[16];
  if (RAND_bytes(random, sizeof random) != 1) {
    throw std::runtime_error{"the system has no randomness for the panel's token"};
  }
  std::string token;
  for (const unsigned char byte : random) {
    token += fmt::format("{:02x}", byte);
  }
  return token;
}

RequestGuard::RequestGuard(std::string token, std::uint16_t port) : token_{std::move(token)}, port_{port} {}

bool RequestGuard::isHere(std::string_view host) const {
  return host == fmt::format("127.0.0.1:{}", port_) || host == fmt::format("localhost:{}", port_);
}

std::optional<Refusal> RequestGuard::check(const RequestInfo& asked) const {
  if (!isHere(asked.host)) {
    return Refusal{421, "The panel answers under its own address only."};
  }
  constexpr std::string_view scheme = "http://";
  if (!asked.origin.empty() && !(asked.origin.starts_with(scheme) && isHere(asked.origin.substr(scheme.size())))) {
    return Refusal{403, "Pages of other origins may not use the panel."};
  }
  if (asked.live && asked.origin.empty()) {
    return Refusal{403, "A live connection must name its origin."};
  }
  const bool isVisit =
      asked.visits && !asked.live && pathOf(asked.target).empty(); // of the page that mate-bridge opens
  if (!isVisit && !asked.fetchSite.empty() && asked.fetchSite != "same-origin" && asked.fetchSite != "none") {
    return Refusal{403, "Pages of other sites may not use the panel."};
  }
  if (asked.method != "GET") {
    return Refusal{405, "The panel answers GET only."};
  }
  const std::string_view target = asked.target;
  const std::size_t size = token_.size();
  const bool known = target.size() >= size + 2 && target.front() == '/' && target[size + 1] == '/' &&
                     CRYPTO_memcmp(target.data() + 1, token_.data(), size) == 0;
  if (!known) {
    return Refusal{404, "This address lacks the token: open the one that mate-bridge printed."};
  }
  return std::nullopt;
}

std::string_view RequestGuard::pathOf(std::string_view target) const {
  return target.substr(std::min(target.size(), token_.size() + 2));
}

std::string RequestGuard::address() const {
  return fmt::format("http://127.0.0.1:{}/{}/", port_, token_);
}

} // namespace naocal
