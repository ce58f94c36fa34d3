#include "console/OutputFiles.hpp"

#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "simulation/Simulation.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

/// JSON for a terminal: dump() leaves DEL and the control characters of UTF-8 in two bytes (U+0080 to U+009F) as they
/// are; here they are escaped as in JSON, which means the same.
std::string printableJson(const nlohmann::json& json) {
  std::string result;
  const std::string text = json.dump(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
    if (byte == 0x7f) {
      result += "\\u007f";
    } else if (byte == 0xc2 && next >= 0x80 && next < 0xa0) {
      result += fmt::format("\\u{:04x}", next);
      ++i;
    } else {
      result += text[i];
    }
  }
  return result;
}

/// Throws InputError if a file holds something else than a table whose first line is this mark.
void requireSameTable(const std::filesystem::path& file, std::string_view mark) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    return;
  }
  if (const std::string content = readFile(file); !content.empty() && !content.starts_with(std::string{mark} + "\n")) {
    throw InputError{fmt::format("{}: expected a new file or one that starts with \"{}\" to replace, found something "
                                 "else; it is left alone, name another file or remove it first",
                                 file.string(), mark)};
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

CLI::Validator replaceableTable(std::string_view mark) {
  return CLI::Validator{[mark](const std::string& file) {
                          requireSameTable(file, mark);
                          return std::string{};
                        },
                        ""};
}

void writeTable(const std::filesystem::path& file, const std::string& text) {
  requireSameTable(file, text.substr(0, text.find('\n')));
  removeAbandonedWritesOf(file);
  writeAtomically(file, text);
}

void writeJson(const nlohmann::json& json, const std::string& file) {
  if (file == "-") {
    fmt::print("{}\n", printableJson(json));
  } else {
    replaceJson(file, json);
  }
}

void writePage(const std::filesystem::path& file, const std::string& page) {
  requireSameKind(file, pageFormat);
  removeAbandonedWritesOf(file);
  writeAtomically(file, page);
}

} // namespace naocal
