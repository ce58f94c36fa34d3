#pragma once

#include <cstdint>
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

/// An unusable configuration; the message says where, what was expected and what was found.
class ConfigurationError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// The half of the robot that a configuration file belongs to; heads and bodies are exchanged separately.
enum class RobotPart { none, head, body };

/// Names that select the layers of a robot's configuration. An empty location means the default location only.
struct RobotNames {
  std::string location, head, body;
};

/// Folders of a configuration: shipped files (read only) and saved files, at the same relative paths. A single folder
/// serves as both.
struct ConfigurationFolders {
  ConfigurationFolders(std::filesystem::path one) : shipped{one}, saved{std::move(one)} {}
  /// An empty `saved` means the shipped folder.
  ConfigurationFolders(const std::filesystem::path& shippedOne, const std::filesystem::path& savedOne)
      : shipped{shippedOne}, saved{savedOne.empty() ? shippedOne : savedOne} {}
  bool areTwo() const { return shipped != saved; }

  std::filesystem::path shipped, saved;
};

/// The files that may set keys of `file`, in ascending priority; later ones replace top-level keys of earlier ones:
/// location/default/, location/default/<part>/default/, location/default/<part>/<name>/, then the same three below
/// location/<location>/. A file without a part has only the first of each three. With two folders, the saved file
/// follows each shipped file.
std::vector<std::filesystem::path> layerFiles(const ConfigurationFolders& folders, const std::string& file,
                                              RobotPart part, const RobotNames& names);

/// A configuration file merged over its layers: all keys, and the layer each comes from. Skips files that do not exist;
/// throws ConfigurationError for a broken one.
struct Overlay {
  explicit Overlay(const std::vector<std::filesystem::path>& layers);
  ~Overlay();
  Overlay(Overlay&&) noexcept;
  Overlay& operator=(Overlay&&) noexcept;

  std::unique_ptr<nlohmann::json> merged;               // an object
  std::map<std::string, std::filesystem::path> origins; // by top-level key
  std::optional<std::filesystem::path> last;            // most specific existing file
};

inline constexpr std::uintmax_t largestConfigurationFile = std::uintmax_t{64} << 20; // [bytes]

/// The bytes of a configuration file, including comments. Absent if it does not exist. Throws ConfigurationError if it
/// cannot be read, is no regular file, or is larger than `largestConfigurationFile`.
std::optional<std::string> readConfigurationText(const std::filesystem::path& file);

/// The object in one configuration file; accepts `//` and `/* */` comments. Absent if the file does not exist. Throws
/// ConfigurationError that names file, line and column of the problem.
std::optional<nlohmann::json> readConfiguration(const std::filesystem::path& file);

/// Looks up the names of a robot's head and body in id_map.json: {"idmap.nao": [{"name": .., "headid": .., "bodyid":
/// ..}]}. Matches the end of the body id, four characters or more (a V5 reports four). An unlisted head or body keeps
/// its id as its name.
RobotNames findRobotNames(const std::filesystem::path& root, std::string_view headId, std::string_view bodyId);

} // namespace naocal
