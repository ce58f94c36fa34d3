#pragma once

#include "Skipped.hpp"
#include "TemporaryFolder.hpp"
#include "io/Files.hpp"
#include "io/GreyImage.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <optional>
#include <string>

namespace naocal {

/// A page of a PDF as a picture, drawn by Poppler's pdftoppm, which shares no code with naocal; skips the test where it
/// is not installed. `page` counts from 1.
inline std::optional<GreyPicture> drawPage(const std::string& pdf, int page, int dotsPerInch) {
  if (std::system("command -v pdftoppm > /dev/null 2>&1") != 0) {
    skip("pdftoppm (package poppler-utils) is not installed");
    return std::nullopt;
  }
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "page.pdf").string(), picture = (folder.path() / "page").string();
  writeAtomically(file, pdf);
  const std::string command =
      fmt::format("pdftoppm -gray -png -r {} -f {} -l {} -singlefile {} {}", dotsPerInch, page, page, file, picture);
  if (std::system(command.c_str()) != 0) {
    return std::nullopt;
  }
  return readImage(picture + ".png");
}

} // namespace naocal
