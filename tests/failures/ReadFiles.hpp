#pragma once

#include "TemporaryFolder.hpp"
#include "calibration/result/ResultFile.hpp"
#include "data/CaptureSetFile.hpp"
#include "data/GoodSet.hpp"
#include "diagnosis/Session.hpp"
#include "io/Files.hpp"
#include "io/GreyImage.hpp"

#include <functional>
#include <nlohmann/json.hpp>

namespace naocal {

/// Small files of all formats in a temporary folder, and what reads them. A read returns a text that tells what was
/// read: the same whenever it succeeds.
struct ReadFiles {
  struct Named {
    std::string name;
    std::function<std::string()> read;
  };

  ReadFiles() {
    writeAtomically(folder.path() / "captures.json", goodSet().dump());
    const std::filesystem::path corpus = std::filesystem::path{NAOCAL_SOURCE_DIR} / "tests/fuzz/corpus";
    std::filesystem::copy_file(corpus / "result/seed-solved", folder.path() / "result.json");
    std::filesystem::copy_file(corpus / "session/seed-three-models", folder.path() / "session.json");
    std::filesystem::copy_file(corpus / "picture/seed-grey.png", folder.path() / "grey.png");
    std::filesystem::copy_file(corpus / "picture/seed-grey.jpg", folder.path() / "grey.jpg");
    std::filesystem::create_directories(folder.path() / "copy");
  }

  /// Checks that what was written of the set's copy is whole, or absent.
  bool isCopyWhole() const {
    const auto copy = folder.path() / "copy/captures.json";
    return !std::filesystem::exists(copy) || readFile(copy) == formatCaptureSet(readCaptureSet(folder.path()).set);
  }

  TemporaryFolder folder;
  std::vector<Named> all{
      {"capture set", [this] { return std::to_string(readCaptureSet(folder.path()).set.captures.size()); }},
      {"copied capture set",
       [this] {
         writeCaptureSet(readCaptureSet(folder.path()).set, folder.path() / "copy");
         return std::string{"copied"};
       }},
      {"result", [this] { return std::to_string(readResult(folder.path() / "result.json").values.size()); }},
      {"session", [this] { return std::to_string(readSession(folder.path() / "session.json").ladder.size()); }},
      {"PNG", [this] { return std::to_string(readImage(folder.path() / "grey.png").pixels.size()); }},
      {"JPEG", [this] { return std::to_string(readImage(folder.path() / "grey.jpg").pixels.size()); }}};
};

} // namespace naocal
