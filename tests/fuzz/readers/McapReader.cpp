#include "recordings/mcap/McapReader.hpp"

#include "fuzz/driver/Reader.hpp"
#include "io/InputError.hpp"
#include "recordings/mcap/RosMessages.hpp"

#include <sstream>

namespace naocal {
namespace {

/// A recording, every message of which is read as each type.
void readMcap(std::string_view bytes) {
  std::istringstream stream{std::string{bytes}};
  visitMcapMessages(stream, "ride.mcap", [](const McapMessage& message) {
    const auto attempt = [&](auto parse) {
      try {
        parse(message.data, "topic");
      } catch (const InputError&) { // refused; it may be of another type
      }
    };
    attempt(parseJointState);
    attempt(parseImage);
    attempt(parseCompressedImage);
    attempt(parseCameraInfo);
    return true;
  });
}

const Reader mcapReader{"mcap", readMcap};

} // namespace
} // namespace naocal
