#include "diagnosis/Session.hpp"
#include "fuzz/driver/MemoryFile.hpp"
#include "fuzz/driver/Reader.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace naocal {
namespace {

/// A session. What is accepted is written and read again.
void readSessionText(std::string_view bytes) {
  const Session session = readSession(MemoryFile{bytes}.path());
  const std::string written = sessionJson(session).dump();
  if (sessionJson(readSession(MemoryFile{written}.path())).dump() != written) {
    throw std::logic_error{"a session that was written and read is another one"};
  }
}

const Reader sessionReader{"session", readSessionText};

} // namespace
} // namespace naocal
