#include "framework/configuration/ConfigurationLayers.hpp"

#include "protocol/BoundedJson.hpp"

#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using nlohmann::json;

/// Checks that a name is a single path component; throws ConfigurationError otherwise.
std::string folderName(const std::string& name, std::string_view what) {
  if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos) {
    throw ConfigurationError{
        fmt::format("the robot's {} is called \"{}\"; expected a name that can be a folder's", what, name)};
  }
  return name;
}

} // namespace

std::vector<std::filesystem::path> layerFiles(const ConfigurationFolders& folders, const std::string& file,
                                              RobotPart part, const RobotNames& names) {
  std::vector<std::filesystem::path> layers;
  const auto addOne = [&](const std::filesystem::path& path) {
    layers.push_back(folders.shipped / path);
    if (folders.areTwo()) {
      layers.push_back(folders.saved / path);
    }
  };
  const auto add = [&](const std::string& location) {
    const auto folder = std::filesystem::path{"location"} / location;
    addOne(folder / file);
    if (part != RobotPart::none) {
      const bool isHead = part == RobotPart::head;
      const auto half = folder / (isHead ? "head" : "body");
      addOne(half / "default" / file);
      addOne(half / folderName(isHead ? names.head : names.body, isHead ? "head" : "body") / file);
    }
  };
  add("default");
  if (!names.location.empty() && names.location != "default") {
    add(folderName(names.location, "location"));
  }
  return layers;
}

Overlay::Overlay(const std::vector<std::filesystem::path>& layers) : merged{std::make_unique<json>(json::object())} {
  for (const auto& layer : layers) {
    const auto content = readConfiguration(layer);
    if (!content) {
      continue;
    }
    last = layer;
    for (const auto& [key, value] : content->items()) {
      (*merged)[key] = value;
      origins[key] = layer;
    }
  }
}
Overlay::~Overlay() = default;
Overlay::Overlay(Overlay&&) noexcept = default;
Overlay& Overlay::operator=(Overlay&&) noexcept = default;

std::optional<std::string> readConfigurationText(const std::filesystem::path& file) {
  std::error_code failed;
  const auto status = std::filesystem::status(file, failed);
  if (status.type() == std::filesystem::file_type::not_found) {
    return std::nullopt;
  }
  if (!failed && !std::filesystem::is_regular_file(status)) { // would wait for a pipe's writer
    throw ConfigurationError{fmt::format("{}: expected a file, found a folder, pipe or device", file.string())};
  }
  std::string text;
  const std::uintmax_t size = failed ? 0 : std::filesystem::file_size(file, failed);
  if (!failed && size > largestConfigurationFile) {
    throw ConfigurationError{fmt::format("{}: expected at most {} bytes in a configuration file, found {}",
                                         file.string(), largestConfigurationFile, size)};
  }
  std::ifstream stream{file, std::ios::binary};
  text.resize(static_cast<std::size_t>(failed ? 0 : size));
  if (failed || !stream.read(text.data(), std::streamsize(text.size()))) {
    throw ConfigurationError{fmt::format("{}: cannot be read; check its permissions", file.string())};
  }
  return text;
}

std::optional<json> readConfiguration(const std::filesystem::path& file) {
  const auto text = readConfigurationText(file);
  if (!text) {
    return std::nullopt;
  }
  json content;
  try {
    (void)json(*text).dump(); // comments too: kept parts of a file are written again
  } catch (const json::exception&) {
    throw ConfigurationError{
        fmt::format("{}: expected text in UTF-8, found other bytes; save it as UTF-8", file.string())};
  }
  try {
    content = parseBoundedJson(*text, true);
  } catch (const json::exception& error) {
    throw ConfigurationError{
        fmt::format("{}: expected valid JSON, found a {}", file.string(), parseErrorReason(error))};
  }
  if (!content.is_object()) {
    throw ConfigurationError{fmt::format("{}: expected an object with keys at its top level", file.string())};
  }
  return content;
}

RobotNames findRobotNames(const std::filesystem::path& root, std::string_view headId, std::string_view bodyId) {
  const auto file = root / "location" / "default" / "id_map.json";
  RobotNames names{"", std::string{headId}, std::string{bodyId}};
  const auto map = readConfiguration(file);
  if (!map) {
    return names;
  }
  try {
    for (const json& robot : map->at("idmap.nao")) {
      const auto name = robot.at("name").get<std::string>();
      if (robot.at("headid").get_ref<const std::string&>() == headId) {
        names.head = name;
      }
      const auto& body = robot.at("bodyid").get_ref<const std::string&>();
      if (body == bodyId || (bodyId.size() >= 4 && body.ends_with(bodyId)) ||
          (body.size() >= 4 && bodyId.ends_with(body))) {
        names.body = name;
      }
    }
  } catch (const json::exception&) {
    throw ConfigurationError{fmt::format("{}: expected {{\"idmap.nao\": [{{\"name\": .., \"headid\": .., \"bodyid\": "
                                         "..}}]}} with texts, found something else",
                                         file.string())};
  }
  return names;
}

} // namespace naocal
