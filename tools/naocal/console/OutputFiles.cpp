#include "console/OutputFiles.hpp"

#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "print/PdfDocument.hpp"
#include "simulation/Simulation.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

/// Throws InputError if a file holds something else than a PDF of this creator.
void requireSamePdf(const std::filesystem::path& file, std::string_view creator) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    return;
  }
  if (const std::string content = readFile(file); !content.empty() && !isPdfOf(content, creator)) {
    throw InputError{
        fmt::format("{}: expected a new file or a PDF of \"{}\" to replace, found something else; it is left "
                    "alone, name another file or remove it first",
                    file.string(), creator)};
  }
}

} // namespace

CLI::Validator replaceableFile(std::string format) {
  return CLI::Validator{[format = std::move(format)](const std::string& file) {
                          if (file != "-") {
                            requireSameKind(file, format);
                          }
                          return std::string{};
                        },
                        ""};
}

void requireReplaceableSet(const std::filesystem::path& folder) {
  if (std::filesystem::exists(folder / "captures.json") &&
      !readCaptureSet(folder, BadCapturePolicy::skip).set.bodyId.starts_with(syntheticIdPrefix)) {
    throw InputError{
        fmt::format("{}: expected a simulated set or none, found another robot's captures; they are left alone, "
                    "name another folder",
                    folder.string())};
  }
  removeAbandonedWritesOf(folder / "captures.json");
  removeAbandonedWrites(folder / "images");
}

CLI::Validator replaceablePdf(std::string_view creator) {
  return CLI::Validator{[creator](const std::string& file) {
                          requireSamePdf(file, creator);
                          return std::string{};
                        },
                        ""};
}

void writeJson(const nlohmann::json& json, const std::string& file) {
  if (file == "-") {
    fmt::print("{}\n", json.dump(1));
  } else {
    replaceJson(file, json);
  }
}

void writePdf(const std::filesystem::path& file, const std::string& pdf, std::string_view creator) {
  requireSamePdf(file, creator);
  writeAtomically(file, pdf);
}

void writePage(const std::filesystem::path& file, const std::string& page) {
  requireSameKind(file, pageFormat);
  removeAbandonedWritesOf(file);
  writeAtomically(file, page);
}

} // namespace naocal
