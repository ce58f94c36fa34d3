#include "captures/Files.hpp"
#include "captures/InputError.hpp"
#include "captures/JsonPlace.hpp"
#include "captures/JsonText.hpp"
#include "model/DrawingReader.hpp"
#include "model/Robot.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

/// The file's own content, known to be a drawing.
nlohmann::json document(const std::filesystem::path& file) {
  nlohmann::json document = parseJson(fileContent(file), file.string());
  const JsonPlace top{document, file.string()};
  top.at("format").oneOf({"naocal-drawing"});
  top.at("version").integer(1, 1);
  return document;
}

/// "V4", "V5", "V6": the models whose drawings lie in a folder.
std::vector<std::string> models(const std::filesystem::path& drawings) {
  std::vector<std::string> names;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator{drawings, unreadable}) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".json" && name.starts_with("Nao")) {
      names.push_back(name.substr(3));
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

} // namespace

Robot loadRobot(const std::filesystem::path& drawing) {
  const nlohmann::json own = document(drawing);
  const JsonPlace top{own, drawing.string()};
  const auto base = top.find("base");
  if (!base) {
    return readDrawing(top);
  }
  nlohmann::json merged = document(drawing.parent_path() / base->text());
  if (merged.contains("base")) {
    base->refuse("a drawing that has no base of its own");
  }
  merged.merge_patch(own);
  return readDrawing(JsonPlace{merged, fmt::format("{} (with its base {})", drawing.string(), base->text())});
}

Robot loadRobot(const std::filesystem::path& configuration, std::string_view model) {
  const auto drawings = configuration / "drawings";
  const auto drawing = drawings / fmt::format("Nao{}.json", model);
  if (!std::filesystem::exists(drawing)) {
    const std::vector<std::string> known = models(drawings);
    throw InputError{
        known.empty()
            ? fmt::format("{}: expected drawings of robots, found none; set NAOCAL_CONFIGURATION to the "
                          "configuration's folder",
                          drawings.string())
            : fmt::format("{}: expected a drawing of one of the robots {{{}}}, found none of \"{}\"; name one "
                          "of them, or set NAOCAL_CONFIGURATION to the configuration's folder",
                          drawings.string(), fmt::join(known, ", "), model)};
  }
  return loadRobot(drawing);
}

} // namespace naocal
