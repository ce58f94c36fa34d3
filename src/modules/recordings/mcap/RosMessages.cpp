#include "recordings/mcap/RosMessages.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fastcdr/Cdr.h>
#include <fastcdr/exceptions/Exception.h>
#include <fmt/format.h>
#include <map>

namespace naocal {

namespace {

struct RosHeader {
  std::chrono::nanoseconds stamp{};
  std::string frame;
};

/// The fields of a serialised message, in their order.
class CdrFields {
public:
  explicit CdrFields(std::string_view data)
      : data_{data}, buffer_{data_.data(), data_.size()}, cdr_{buffer_, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN,
                                                               eprosima::fastcdr::Cdr::DDS_CDR} {
    cdr_.read_encapsulation();
  }

  template <typename T> T read() {
    T value{};
    cdr_ >> value;
    return value;
  }

  RosHeader readHeader() {
    const auto seconds = read<std::int32_t>();
    const auto nanoseconds = read<std::uint32_t>();
    return {std::chrono::seconds{seconds} + std::chrono::nanoseconds{nanoseconds}, read<std::string>()};
  }

private:
  std::string data_; // the library's buffers are not constant
  eprosima::fastcdr::FastBuffer buffer_;
  eprosima::fastcdr::Cdr cdr_;
};

/// Calls `parse` with the message's fields; what the library refuses becomes a sentence.
template <typename Parse> auto parseFields(std::string_view data, const std::string& where, const Parse& parse) {
  try {
    CdrFields fields{data};
    return parse(fields);
  } catch (const eprosima::fastcdr::exception::Exception&) {
    throw InputError{
        fmt::format("{}: expected a whole message in CDR, found {} bytes that end too early", where, data.size())};
  } catch (const std::length_error&) {
    throw InputError{fmt::format("{}: expected a message in CDR, found a list with an impossible length", where)};
  }
}

/// Layout of a picture's rows.
struct PixelLayout {
  std::size_t bytes;                // of a pixel
  std::array<std::size_t, 3> parts; // bytes of red, green and blue; of a grey or luma byte: three times the same
};

const std::map<std::string, PixelLayout, std::less<>>& pixelLayouts() {
  static const std::map<std::string, PixelLayout, std::less<>> layouts{
      {"mono8", {1, {0, 0, 0}}}, {"8UC1", {1, {0, 0, 0}}},  {"rgb8", {3, {0, 1, 2}}},   {"8UC3", {3, {2, 1, 0}}},
      {"bgr8", {3, {2, 1, 0}}},  {"rgba8", {4, {0, 1, 2}}}, {"bgra8", {4, {2, 1, 0}}},  {"yuv422_yuy2", {2, {0, 0, 0}}},
      {"yuyv", {2, {0, 0, 0}}},  {"uyvy", {2, {1, 1, 1}}},  {"yuv422", {2, {1, 1, 1}}},
  };
  return layouts;
}

GreyPicture greyOf(const std::vector<std::uint8_t>& data, const PixelLayout& layout, PictureSize size,
                   std::size_t step) {
  GreyPicture picture{size.width, size.height, {}};
  picture.pixels.reserve(std::size_t(size.width) * std::size_t(size.height));
  for (std::size_t row = 0; row < std::size_t(size.height); ++row) {
    const std::uint8_t* pixel = data.data() + row * step;
    for (int column = 0; column < size.width; ++column, pixel += layout.bytes) {
      const std::array<std::uint8_t, 3> rgb{pixel[layout.parts[0]], pixel[layout.parts[1]], pixel[layout.parts[2]]};
      picture.pixels.push_back(rgb[0] == rgb[1] && rgb[1] == rgb[2] ? rgb[0] : luma(rgb.data()));
    }
  }
  return picture;
}

constexpr std::uint32_t longestSide = 16'384; // [px]

} // namespace

RosJointState parseJointState(std::string_view data, const std::string& where) {
  return parseFields(data, where, [&](CdrFields& fields) {
    RosJointState state;
    state.stamp = fields.readHeader().stamp;
    state.names = fields.read<std::vector<std::string>>();
    state.positions = fields.read<std::vector<double>>();
    if (state.positions.size() != state.names.size()) {
      throw InputError{fmt::format("{}: expected a position for each of {} joints, found {}", where, state.names.size(),
                                   state.positions.size())};
    }
    return state;
  });
}

RosImage parseImage(std::string_view data, const std::string& where) {
  return parseFields(data, where, [&](CdrFields& fields) {
    const RosHeader header = fields.readHeader();
    const auto height = fields.read<std::uint32_t>(), width = fields.read<std::uint32_t>();
    const auto encoding = fields.read<std::string>();
    fields.read<std::uint8_t>(); // byte order of wider pixels
    const auto step = fields.read<std::uint32_t>();
    const auto pixels = fields.read<std::vector<std::uint8_t>>();
    const auto layout = pixelLayouts().find(encoding);
    if (layout == pixelLayouts().end()) {
      throw InputError{fmt::format("{}: expected pixels as mono8, rgb8, bgr8, rgba8, bgra8, yuv422_yuy2 or uyvy, "
                                   "found \"{}\"",
                                   where, printableText(encoding, 40))};
    }
    const bool isSize = width > 0 && height > 0 && width <= longestSide && height <= longestSide;
    if (!isSize || step < width * layout->second.bytes || pixels.size() < std::size_t(step) * height) {
      throw InputError{fmt::format("{}: expected {} x {} pixels in rows of {} bytes, found {} bytes", where, width,
                                   height, step, pixels.size())};
    }
    const PictureSize size{static_cast<int>(width), static_cast<int>(height)};
    return RosImage{header.stamp, header.frame, greyOf(pixels, layout->second, size, step)};
  });
}

RosImage parseCompressedImage(std::string_view data, const std::string& where) {
  return parseFields(data, where, [&](CdrFields& fields) {
    const RosHeader header = fields.readHeader();
    fields.read<std::string>(); // the format's name, which drivers write in various ways
    const auto bytes = fields.read<std::vector<std::uint8_t>>();
    RosImage image{header.stamp, header.frame, std::string{bytes.begin(), bytes.end()}};
    imageSize(std::get<std::string>(image.content), where); // PNG or JPEG
    return image;
  });
}

RosCameraLens parseCameraInfo(std::string_view data, const std::string& where) {
  return parseFields(data, where, [&](CdrFields& fields) {
    const RosHeader header = fields.readHeader();
    const auto height = fields.read<std::uint32_t>(), width = fields.read<std::uint32_t>();
    const auto model = fields.read<std::string>();
    const auto distortion = fields.read<std::vector<double>>();
    const auto matrix = fields.read<std::array<double, 9>>();
    CameraIntrinsics lens;
    lens.width = static_cast<int>(std::min(width, longestSide));
    lens.height = static_cast<int>(std::min(height, longestSide));
    const bool isPlumbBob = model == "plumb_bob" || (model.empty() && distortion.empty());
    if (!isPlumbBob || distortion.size() > lens.distortion.size()) {
      throw InputError{fmt::format("{}: expected the lens model plumb_bob with at most 5 coefficients, found \"{}\" "
                                   "with {}",
                                   where, printableText(model, 40), distortion.size())};
    }
    std::copy(distortion.begin(), distortion.end(), lens.distortion.begin());
    lens.fx = matrix[0];
    lens.cx = matrix[2];
    lens.fy = matrix[4];
    lens.cy = matrix[5];
    const auto isFinite = [](double number) { return std::isfinite(number); };
    if (width == 0 || height == 0 || !(lens.fx > 0 && lens.fy > 0) ||
        !std::all_of(matrix.begin(), matrix.end(), isFinite) ||
        !std::all_of(distortion.begin(), distortion.end(), isFinite)) {
      throw InputError{fmt::format("{}: expected a calibrated camera, found {} x {} px, fx {}, fy {}", where, width,
                                   height, lens.fx, lens.fy)};
    }
    return RosCameraLens{header.frame, lens};
  });
}

std::chrono::nanoseconds parseStamp(std::string_view data, const std::string& where) {
  return parseFields(data, where, [](CdrFields& fields) { return fields.readHeader().stamp; });
}

} // namespace naocal
