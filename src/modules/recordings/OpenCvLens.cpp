#include "recordings/OpenCvLens.hpp"

#include "dialects/text/YamlText.hpp"
#include "io/InputError.hpp"
#include "io/XmlDocument.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <optional>

namespace naocal {

namespace {

/// The numbers of a matrix row by row, or a number alone; none without the name.
using Lookup = std::function<std::optional<std::vector<double>>(const std::string& name)>;

[[noreturn]] void refuse(const std::string& file, const std::string& name, const std::string& expected,
                         const std::string& found) {
  throw InputError{fmt::format("{}: {}: expected {}, found {}", file, name, expected, found)};
}

/// A matrix's elements of this type, as "d" for double, have one number each.
bool isOneNumber(std::string_view type) {
  constexpr std::string_view types = "ucwsifdh";
  type.remove_prefix(type.starts_with('1') ? 1 : 0);
  return type.size() == 1 && types.find(type) != types.npos;
}

// YAML, JSON

std::vector<double> numbersOf(const YamlCursor& value) {
  if (!value.has("data")) {
    return {value.number()};
  }
  if (const std::string type = value.at("dt").text(); !isOneNumber(type)) {
    value.at("dt").refuse("a type with one number per element, as d", type);
  }
  constexpr int most = 100;
  const int rows = value.at("rows").integer(1, most), columns = value.at("cols").integer(1, most);
  return value.at("data").numbers(static_cast<std::size_t>(rows) * columns);
}

// XML

/// The words of an element, or of an element within it.
std::string wordsOf(const TiXmlElement& element, const char* child, const std::string& file) {
  const TiXmlElement* const at = child == nullptr ? &element : element.FirstChildElement(child);
  if (at == nullptr || at->GetText() == nullptr) {
    refuse(file, element.Value(), child == nullptr ? "a number" : fmt::format("<{}> with a value", child), "none");
  }
  return at->GetText();
}

std::vector<double> numbersIn(const TiXmlElement& element, const char* child, const std::string& file) {
  const std::string words = wordsOf(element, child, file);
  const auto numbers = parseXmlNumbers(words);
  if (!numbers) {
    refuse(file, element.Value(), "finite numbers", fmt::format("\"{}\"", words));
  }
  return *numbers;
}

std::vector<double> numbersOf(const TiXmlElement& element, const std::string& file) {
  if (element.FirstChildElement() == nullptr) {
    return numbersIn(element, nullptr, file);
  }
  if (const std::string type = wordsOf(element, "dt", file); !isOneNumber(type)) {
    refuse(file, element.Value(), "a type (dt) with one number per element, as d", fmt::format("\"{}\"", type));
  }
  std::vector<double> numbers = numbersIn(element, "data", file);
  double count = 1;
  for (const char* const side : {"rows", "cols"}) {
    const std::vector<double> length = numbersIn(element, side, file);
    count *= length.size() == 1 ? length[0] : 0;
  }
  if (static_cast<double>(numbers.size()) != count) {
    refuse(file, element.Value(), "rows x cols numbers", std::to_string(numbers.size()));
  }
  return numbers;
}

// both

std::vector<double> find(const Lookup& lookup, const std::vector<std::string>& names, const std::string& file) {
  for (const std::string& name : names) {
    if (const auto numbers = lookup(name)) {
      return *numbers;
    }
  }
  throw InputError{fmt::format("{}: expected {} as OpenCV writes it, found none", file, fmt::join(names, " or "))};
}

int findSide(const Lookup& lookup, const std::vector<std::string>& names, const std::string& file) {
  const std::vector<double> side = find(lookup, names, file);
  if (side.size() != 1 || !(side[0] >= 1 && side[0] <= CameraIntrinsics::mostPixels)) {
    refuse(file, names.front(), fmt::format("a picture's size of 1 to {} px", CameraIntrinsics::mostPixels),
           fmt::format("{}", fmt::join(side, ", ")));
  }
  return static_cast<int>(side[0]);
}

CameraIntrinsics readLens(const Lookup& lookup, const std::string& file) {
  CameraIntrinsics lens;
  lens.width = findSide(lookup, {"image_width", "imageWidth", "image_Width"}, file);
  lens.height = findSide(lookup, {"image_height", "imageHeight", "image_Height"}, file);
  const std::vector<double> matrix = find(lookup, {"camera_matrix", "cameraMatrix", "Camera_Matrix", "K"}, file);
  if (matrix.size() != 9) {
    refuse(file, "camera matrix", "3 x 3 numbers", std::to_string(matrix.size()));
  }
  lens.fx = matrix[0];
  lens.cx = matrix[2];
  lens.fy = matrix[4];
  lens.cy = matrix[5];
  setDistortion(
      find(lookup, {"distortion_coefficients", "dist_coeffs", "distCoeffs", "Distortion_Coefficients", "D"}, file),
      file, lens);
  return lens;
}

CameraIntrinsics readYamlLens(std::string text, const std::string& file) {
  if (text.starts_with('%')) {
    text[0] = '#'; // "%YAML:1.0" of OpenCV is no directive of YAML, which has a space
  }
  const YamlCursor all{text, file};
  const auto lookup = [&](const std::string& name) {
    return all.has(name) ? std::optional{numbersOf(all.at(name))} : std::nullopt;
  };
  return readLens(lookup, file);
}

CameraIntrinsics readXmlLens(const std::string& text, const std::string& file) {
  const TiXmlDocument document = parseXml(text, file, "a file of OpenCV's FileStorage");
  const TiXmlElement* const storage = document.FirstChildElement("opencv_storage");
  if (storage == nullptr) {
    throw InputError{fmt::format("{}: expected the element <opencv_storage>, found none", file)};
  }
  const auto lookup = [&](const std::string& name) {
    const TiXmlElement* const element = storage->FirstChildElement(name.c_str());
    return element == nullptr ? std::nullopt : std::optional{numbersOf(*element, file)};
  };
  return readLens(lookup, file);
}

} // namespace

bool isOpenCvStorage(const std::string& text) {
  return text.starts_with("%YAML:1") || text.find("<opencv_storage") != text.npos ||
         text.find("opencv-matrix") != text.npos;
}

CameraIntrinsics readOpenCvLens(const std::string& text, const std::string& file) {
  return text.find("<opencv_storage") != text.npos ? readXmlLens(text, file) : readYamlLens(text, file);
}

void setDistortion(const std::vector<double>& coefficients, const std::string& file, CameraIntrinsics& lens) {
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    if (i < lens.distortion.size()) {
      lens.distortion[i] = coefficients[i];
    } else if (coefficients[i] != 0) {
      throw InputError{
          fmt::format("{}: expected distortion by k1, k2, p1, p2, k3 only, found coefficient {} that is not 0: "
                      "calibrate with 5 coefficients",
                      file, i + 1)};
    }
  }
}

} // namespace naocal
