#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace naocal {

/// A configuration that cannot be used: one sentence that says where, what was expected and what was found.
class ConfigurationError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Which half of the robot a file of the configuration belongs to; heads and bodies are exchanged separately.
enum class RobotPart { none, head, body };

/// What selects the layers of a robot's configuration. An empty location is none beside the default.
struct RobotNames {
  std::string location, head, body;
};

/// Where a configuration lies: what was shipped, and what robots save, at the same paths below another folder, so that
/// what was shipped is only read. One folder alone is both.
struct ConfigurationFolders {
  ConfigurationFolders(std::filesystem::path one) : shipped{one}, saved{std::move(one)} {}
  /// An empty `saved` is the shipped one.
  ConfigurationFolders(const std::filesystem::path& shippedOne, const std::filesystem::path& savedOne)
      : shipped{shippedOne}, saved{savedOne.empty() ? shippedOne : savedOne} {}
  bool areTwo() const { return shipped != saved; }

  std::filesystem::path shipped, saved;
};

/// The files that may hold `file`'s keys, in the order in which later ones replace top-level keys of earlier ones:
/// location/default/, location/default/<part>/default/, location/default/<part>/<name>/, then the same three below
/// location/<location>/. A file of no part has only the first of each three. Each as it was shipped, then as it was
/// saved, where these are two.
std::vector<std::filesystem::path> layerFiles(const ConfigurationFolders& folders, const std::string& file,
                                              RobotPart part, const RobotNames& names);

/// A file as its robot sees it: all keys, and for each the layer that it comes from. Files that do not exist are
/// skipped. Throws ConfigurationError for one that is broken.
struct Overlay {
  explicit Overlay(const std::vector<std::filesystem::path>& layers);
  ~Overlay();
  Overlay(Overlay&&) noexcept;
  Overlay& operator=(Overlay&&) noexcept;

  std::unique_ptr<nlohmann::json> merged;               // an object
  std::map<std::string, std::filesystem::path> origins; // by top-level key
  std::optional<std::filesystem::path> last;            // the most specific file that exists
};

/// The object in one file of the configuration; `//` and `/* */` comments are accepted. Absent: there is no such file.
/// Throws ConfigurationError that names file, line and column of what is wrong.
std::optional<nlohmann::json> readConfiguration(const std::filesystem::path& file);

/// The names of a robot's head and body in id_map.json: {"idmap.nao": [{"name": .., "headid": .., "bodyid": ..}]}. The
/// body's last characters are enough (a V5 tells four). Whoever is not listed is called by its id.
RobotNames findRobotNames(const std::filesystem::path& root, std::string_view headId, std::string_view bodyId);

} // namespace naocal
