#include "TemporaryFolder.hpp"
#include "framework/configuration/Configuration.hpp"
#include "framework/network/Access.hpp"
#include "framework/network/ConfigServer.hpp"
#include "fuzz/driver/Reader.hpp"
#include "fuzz/readers/ServedClient.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// A folder with the file of one mount.
std::filesystem::path makeConfiguration(const std::filesystem::path& folder) {
  const auto location = folder / "location" / "default";
  std::filesystem::create_directories(location);
  std::ofstream{location / "Cam.json"} << R"({"factor": 0.5, "list": [1, {"deep": 2}], "a.b": {"c": true}})";
  return folder;
}

/// A client of a configuration server with one mount; nothing is written.
void serveConfigClient(std::string_view bytes) {
  static const TemporaryFolder folder;
  static const std::filesystem::path root = makeConfiguration(folder.path());
  Configuration configuration{root, RobotNames{"", "Ada", "Bob"},
                              [](const std::filesystem::path&, std::string_view) {}};
  configuration.mount("Brain.Cam", "Cam.json", RobotPart::none);
  Access access{AccessSettings{}};
  ConfigServer server{configuration, access, [](std::string_view) {}};
  serveClient(server, bytes);
}

const Reader configFramesReader{"config-frames", serveConfigClient};

} // namespace
} // namespace naocal
