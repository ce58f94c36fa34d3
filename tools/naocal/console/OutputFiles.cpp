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

/// The format of a file's content, or a description of it.
std::string kindOf(const std::string& content) {
  const std::string mark = "<script type=\"application/json\" id=\"data\">"; // in every report page
  if (content.starts_with("<!doctype html>")) {
    return content.find(mark) != std::string::npos ? std::string{pageFormat} : "another page";
  }
  const auto json = nlohmann::json::parse(content, nullptr, false);
  if (json.is_discarded()) {
    return "something that is not JSON";
  }
  const bool isNamed = json.is_object() && json.contains("format") && json["format"].is_string();
  return isNamed ? json["format"].get<std::string>() : "JSON of an unknown format";
}

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

void requireSameKind(const std::filesystem::path& file, std::string_view format) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    return;
  }
  const std::string content = readFile(file);
  if (const std::string kind = content.empty() ? std::string{format} : kindOf(content); kind != format) {
    throw InputError{fmt::format("{}: expected a new file or one with {} to replace, found {}; it is left alone, name "
                                 "another file or remove it first",
                                 file.string(), format, kind)};
  }
}

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

CLI::Validator replaceableTable(std::string_view mark) {
  return CLI::Validator{[mark](const std::string& file) {
                          requireSameTable(file, mark);
                          return std::string{};
                        },
                        ""};
}

void writeTable(const std::filesystem::path& file, const std::string& table) {
  requireSameTable(file, table.substr(0, table.find('\n')));
  removeAbandonedWritesOf(file);
  writeAtomically(file, table);
}

void writeJson(const nlohmann::json& json, const std::string& file) {
  if (file == "-") {
    fmt::print("{}\n", json.dump(1));
  } else {
    requireSameKind(file, json.at("format").get_ref<const std::string&>());
    removeAbandonedWritesOf(file);
    writeAtomically(file, json.dump(1) + "\n");
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
