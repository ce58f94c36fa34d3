#include "framework/core/Database.hpp"
#include "framework/core/Module.hpp"
#include "framework/core/Thread.hpp"
#include "framework/network/Access.hpp"
#include "framework/network/DebugServer.hpp"
#include "framework/network/Outbox.hpp"
#include "fuzz/driver/Reader.hpp"
#include "fuzz/readers/ServedClient.hpp"

#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// Produces a number.
class Counter : public Module {
public:
  Counter() : Module{"Counter"} {}
  void cycle() override { count_ = 1; }

private:
  Production<int> count_{*this, "count"};
};

/// A client of a debug server with one key.
void serveDebugClient(std::string_view bytes) {
  Thread brain{"Brain", RobotPart::head};
  brain.add<Counter>();
  const Database database{{&brain}};
  Access access{AccessSettings{}};
  DebugServer server{{&brain}, access, TimePoint{}};
  serveClient(server, bytes);
}

const Reader debugFramesReader{"debug-frames", serveDebugClient};

} // namespace
} // namespace naocal
