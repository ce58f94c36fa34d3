#include "console/PdfFiles.hpp"

#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "print/PdfDocument.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

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

CLI::Validator replaceablePdf(std::string_view creator) {
  return CLI::Validator{[creator](const std::string& file) {
                          requireSamePdf(file, creator);
                          return std::string{};
                        },
                        ""};
}

void writePdf(const std::filesystem::path& file, const std::string& pdf, std::string_view creator) {
  requireSamePdf(file, creator);
  writeAtomically(file, pdf);
}

} // namespace naocal
