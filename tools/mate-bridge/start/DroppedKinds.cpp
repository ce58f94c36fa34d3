#include "start/DroppedKinds.hpp"

#include "start/DroppedFiles.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

namespace naocal {

namespace {

struct KindOfEnding {
  std::string_view ending;
  DroppedKind kind;
};

constexpr std::array<KindOfEnding, 16> kindsOfEndings{{{".json", DroppedKind::document},
                                                       {".urdf", DroppedKind::robot},
                                                       {".xacro", DroppedKind::robot}, // says how to expand it
                                                       {".csv", DroppedKind::table},
                                                       {".yaml", DroppedKind::lens},
                                                       {".yml", DroppedKind::lens},
                                                       {".xml", DroppedKind::lens},
                                                       {".cameramodel", DroppedKind::lens},
                                                       {".png", DroppedKind::picture},
                                                       {".jpg", DroppedKind::picture},
                                                       {".jpeg", DroppedKind::picture},
                                                       {".pgm", DroppedKind::otherPicture},
                                                       {".ppm", DroppedKind::otherPicture},
                                                       {".bmp", DroppedKind::otherPicture},
                                                       {".tif", DroppedKind::otherPicture},
                                                       {".tiff", DroppedKind::otherPicture}}};

constexpr std::string_view endingOfTruth = ".truth.json";

bool isOfSet(DroppedKind kind) {
  return kind != DroppedKind::table && kind != DroppedKind::lens;
}

std::vector<std::string_view> listEndings(const auto& isListed) {
  std::vector<std::string_view> endings;
  for (const auto& [ending, kind] : kindsOfEndings) {
    if (isListed(kind)) {
      endings.push_back(ending);
    }
  }
  return endings;
}

bool isAnyKind(DroppedKind) {
  return true;
}

} // namespace

std::optional<DroppedKind> droppedKindOf(const std::string& name) {
  std::string ending = std::filesystem::path{name}.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  const auto found = std::find_if(kindsOfEndings.begin(), kindsOfEndings.end(),
                                  [&](const KindOfEnding& known) { return known.ending == ending; });
  return found == kindsOfEndings.end() ? std::nullopt : std::optional{found->kind};
}

std::string droppedEndings() {
  return fmt::format("{}", fmt::join(listEndings(isAnyKind), ", "));
}

bool isDroppedTruth(const std::string& name) {
  return name.ends_with(endingOfTruth);
}

nlohmann::json droppedFilesState() {
  return {{"endings", listEndings(isAnyKind)},    {"endingsOfSet", listEndings(isOfSet)},
          {"endingOfTruth", endingOfTruth},       {"mostFiles", DroppedFiles::mostFiles},
          {"mostBytes", DroppedFiles::mostBytes}, {"expected", expectedDrop}};
}

} // namespace naocal
