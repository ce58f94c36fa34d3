#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace boost::asio {
class io_context;
}

namespace naocal {

/// The response to a request.
struct HttpReply {
  unsigned status = 200;
  std::string type, body;
};

/// A WebSocket message to a panel.
struct Message {
  std::shared_ptr<const std::string> bytes;
  bool binary = false;
  bool skippable = false; // newer ones follow: slow clients may miss it
};
inline Message makeMessage(std::string bytes, bool binary = false, bool skippable = false) {
  return {std::make_shared<const std::string>(std::move(bytes)), binary, skippable};
}

inline constexpr std::chrono::seconds longestRequest{10}; // from the connection to the end of the response

/// Callbacks of the server, on the context's thread, and its limit in time. Panels are numbered in order of connection.
struct ServerCallbacks {
  std::function<HttpReply(std::string_view path)> file; // path: the part after the token
  std::function<void(std::size_t panel)> opened, closed;
  std::function<void(std::size_t panel, std::string text)> received;
  std::chrono::milliseconds requestTime = longestRequest; // a slower request is closed
};

inline constexpr std::size_t mostRequests = 128;           // read at once; beyond, the oldest one is closed
inline constexpr std::size_t mostRequestHeader = 16 << 10; // [bytes] of a request, which has no body
inline constexpr std::size_t mostPanels = 16;              // live connections; beyond, status 503
inline constexpr std::size_t mostPanelMessage = 1 << 20;   // [bytes] of a message from a panel
inline constexpr std::size_t mostPanelSkippable = 2 << 20; // [bytes] queued for a panel; beyond, images are left out
inline constexpr std::size_t mostPanelPending = 256 << 20; // [bytes] queued for a panel; beyond, it is closed

/// Serves the page and its WebSockets on 127.0.0.1; RequestGuard filters requests.
class HttpServer {
public:
  /// Listens; port 0 takes any free one. Throws InputError on failure.
  HttpServer(boost::asio::io_context& context, std::uint16_t port, const std::string& token, ServerCallbacks calls);
  ~HttpServer();

  /// URL of the panel.
  std::string address() const;

  void send(std::size_t panel, const Message& message);
  void sendAll(const Message& message);

private:
  struct Implementation;
  std::shared_ptr<Implementation> implementation_;
};

/// Decodes percent-encoding (%20) in a path; invalid codes are kept.
std::string decodePercents(std::string_view path);

} // namespace naocal
