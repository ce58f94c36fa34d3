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

class Guard;

/// What a path is answered with.
struct Answer {
  unsigned status = 200;
  std::string type, body;
};

/// What goes to a panel over its WebSocket.
struct Message {
  std::shared_ptr<const std::string> bytes;
  bool binary = false;
  bool skippable = false; // newer ones follow: whoever is slow does without
};
inline Message message(std::string bytes, bool binary = false, bool skippable = false) {
  return {std::make_shared<const std::string>(std::move(bytes)), binary, skippable};
}

/// What the server calls, all on the thread that runs the context. Panels are numbered as they come.
struct ServerCalls {
  std::function<Answer(std::string_view path)> file; // path: behind the token
  std::function<void(std::size_t panel)> opened, closed;
  std::function<void(std::size_t panel, std::string text)> received;
};

/// Serves the page and its live connections on 127.0.0.1, to those only whom the guard lets in.
class Server {
public:
  /// Listens; port 0 takes any that is free. Throws InputError when it cannot.
  Server(boost::asio::io_context& context, std::uint16_t port, const std::string& token, ServerCalls calls);
  ~Server();

  /// What a person opens.
  std::string address() const;

  void send(std::size_t panel, const Message& message);
  void sendAll(const Message& message);

private:
  struct Implementation;
  std::shared_ptr<Implementation> implementation_;
};

} // namespace naocal
