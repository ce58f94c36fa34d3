#pragma once

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

class RequestGuard;

/// What a path is answered with.
struct HttpReply {
  unsigned status = 200;
  std::string type, body;
};

/// What goes to a panel over its WebSocket.
struct Message {
  std::shared_ptr<const std::string> bytes;
  bool binary = false;
  bool skippable = false; // newer ones follow: whoever is slow does without
};
inline Message makeMessage(std::string bytes, bool binary = false, bool skippable = false) {
  return {std::make_shared<const std::string>(std::move(bytes)), binary, skippable};
}

/// What the server calls, all on the thread that runs the context. Panels are numbered as they come.
struct ServerCallbacks {
  std::function<HttpReply(std::string_view path)> file; // path: behind the token
  std::function<void(std::size_t panel)> opened, closed;
  std::function<void(std::size_t panel, std::string text)> received;
};

/// Serves the page and its live connections on 127.0.0.1, to those only whom the guard lets in.
class HttpServer {
public:
  /// Listens; port 0 takes any that is free. Throws InputError when it cannot.
  HttpServer(boost::asio::io_context& context, std::uint16_t port, const std::string& token, ServerCallbacks calls);
  ~HttpServer();

  /// What a person opens.
  std::string address() const;

  void send(std::size_t panel, const Message& message);
  void sendAll(const Message& message);

private:
  struct Implementation;
  std::shared_ptr<Implementation> implementation_;
};

/// An address' path with its %20 as letters; what is no such code stays as it is.
std::string decodePercents(std::string_view path);

} // namespace naocal
