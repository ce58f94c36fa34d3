#include "TemporaryFolder.hpp"
#include "fuzz/driver/Reader.hpp"
#include "fuzz/readers/SocketInput.hpp"
#include "hardware/nao/LolaMessages.hpp"
#include "hardware/nao/LolaStream.hpp"

#include <stdexcept>
#include <sys/un.h>

namespace naocal {
namespace {

/// A listening UNIX socket in place of the hardware service's.
class Service {
public:
  Service() : socket_{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)} {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path().string().copy(address.sun_path, sizeof address.sun_path - 1);
    if (::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        ::listen(socket_, 8) != 0) {
      throw std::runtime_error{"the system gives no socket"};
    }
  }
  std::filesystem::path path() const { return folder_.path() / "robocup"; }
  int accept() const { return ::accept4(socket_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC); }

private:
  TemporaryFolder folder_;
  int socket_;
};

void parse(std::span<const std::uint8_t> message) {
  const auto state = parseLolaState(message);
  if (const auto* problem = std::get_if<std::string>(&state); problem && problem->empty()) {
    throw std::logic_error{"a state is refused without a reason"};
  }
}

/// The input as one message, and as a stream of them.
void readStates(std::string_view bytes) {
  static const Service service;
  parse({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  LolaStream stream{service.path()};
  stream.receive(TimePoint{}); // connects
  SocketInput robot{service.accept(), bytes};
  do {
    robot.exchange();
    if (const auto* received = stream.receive(TimePoint{})) {
      parse(received->message);
    }
  } while (stream.isConnected());
}

const Reader lolaReader{"lola", readStates};

} // namespace
} // namespace naocal
