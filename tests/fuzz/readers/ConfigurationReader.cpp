#include "TemporaryFolder.hpp"
#include "framework/configuration/Configuration.hpp"
#include "fuzz/driver/Reader.hpp"

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// Cuts off and returns the part before the next line "----".
std::string_view takePart(std::string_view& rest) {
  constexpr std::string_view divider = "\n----\n";
  const std::size_t end = rest.find(divider);
  const std::string_view part = rest.substr(0, end);
  rest.remove_prefix(end == rest.npos ? rest.size() : end + divider.size());
  return part;
}

/// The input's parts: the file for all robots, the one for this body, id_map.json, and a path, which is set to null.
void readLayers(std::string_view bytes) {
  static const TemporaryFolder folder;
  const auto location = folder.path() / "location" / "default";
  std::filesystem::create_directories(location / "body" / "Bob");
  for (const std::string_view file : {"Cam.json", "body/Bob/Cam.json", "id_map.json"}) {
    const std::string_view part = takePart(bytes);
    std::ofstream{location / file, std::ios::binary | std::ios::trunc}.write(part.data(), std::streamsize(part.size()));
  }
  try {
    findRobotNames(folder.path(), "head", "body");
    Configuration configuration{folder.path(), RobotNames{"", "Ada", "Bob"},
                                [](const std::filesystem::path&, std::string_view) {}};
    configuration.mount("Brain.Cam", "Cam.json", RobotPart::body);
    configuration.set("Brain.Cam", bytes, nullptr);
    configuration.save();
  } catch (const ConfigurationError&) { // refused
  }
}

const Reader configurationReader{"configuration", readLayers};

} // namespace
} // namespace naocal
