#include "fuzz/driver/Reader.hpp"
#include "fuzz/readers/SocketInput.hpp"
#include "server/HttpServer.hpp"

#include <arpa/inet.h>
#include <boost/asio/io_context.hpp>
#include <fcntl.h>
#include <netinet/in.h>
#include <stdexcept>
#include <sys/socket.h>

namespace naocal {
namespace {

/// A server with a page, and its address split into host and path.
struct Server {
  boost::asio::io_context context;
  HttpServer server{context,
                    0,
                    "00112233445566778899aabbccddeeff",
                    {[](std::string_view asked) {
                       return HttpReply{200, "text/plain", decodePercents(asked)};
                     },
                     [](std::size_t) {}, [](std::size_t) {}, [](std::size_t, const std::string&) {}}};
  std::string host = server.address().substr(7, server.address().find('/', 7) - 7);
  std::string path = server.address().substr(7 + host.size());

  int connect() const {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(std::stoi(host.substr(host.find(':') + 1))));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const linger reset{1, 0}; // closed sockets keep no port, which millions of reads would use up
    ::setsockopt(socket, SOL_SOCKET, SO_LINGER, &reset, sizeof reset);
    if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
      throw std::runtime_error{"the server cannot be connected to"};
    }
    return socket;
  }
};

std::string replaced(std::string text, std::string_view word, const std::string& by) {
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + by.size())) {
    text.replace(at, word.size(), by);
  }
  return text;
}

/// A browser's bytes; {host} and {path} stand for the panel's address. Bytes behind the first head go out after the
/// server has had its turn, as frames of a WebSocket do.
void serveBrowser(std::string_view bytes) {
  static Server bridge;
  const std::string all = replaced(replaced(std::string{bytes}, "{host}", bridge.host), "{path}", bridge.path);
  const std::size_t head = all.find("\r\n\r\n");
  const std::size_t first = head == all.npos ? all.size() : head + 4;
  const int socket = bridge.connect();
  ::send(socket, all.data(), first, MSG_NOSIGNAL);
  const auto turn = [] {
    bridge.context.restart();
    while (bridge.context.poll() > 0) {
    }
  };
  turn();
  SocketInput browser{socket, std::string_view{all}.substr(first)};
  ::fcntl(socket, F_SETFL, O_NONBLOCK);
  for (int turns = 0; turns < 1000 && browser.exchange(); ++turns) {
    turn();
  }
}

const Reader httpReader{"http", serveBrowser};

} // namespace
} // namespace naocal
