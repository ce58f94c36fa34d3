#include "io/GreyImage.hpp"

#include "io/Files.hpp"
#include "io/InputError.hpp"

#include <csetjmp>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <png.h>
#include <turbojpeg.h>

namespace naocal {

namespace {

using TurboJpeg = std::unique_ptr<void, decltype(&tjDestroy)>;

bool isPossible(std::int64_t width, std::int64_t height) {
  constexpr std::int64_t most = 1 << 26; // pixels
  return width > 0 && height > 0 && width <= most && height <= most && width * height <= most;
}

/// Reads a PNG's header into `image`; false if it is none or impossible.
bool beginPng(std::string_view content, png_image& image) {
  image.version = PNG_IMAGE_VERSION;
  return png_image_begin_read_from_memory(&image, content.data(), content.size()) != 0 &&
         isPossible(image.width, image.height);
}

using PngFreed = std::unique_ptr<png_image, decltype(&png_image_free)>;

std::optional<PictureSize> pngSize(std::string_view content) {
  png_image image{};
  const PngFreed freed{&image, png_image_free};
  return beginPng(content, image)
             ? std::optional{PictureSize{static_cast<int>(image.width), static_cast<int>(image.height)}}
             : std::nullopt;
}

std::optional<PictureSize> jpegSize(const TurboJpeg& turbo, std::string_view content) {
  PictureSize size{};
  int subsampling = 0, colours = 0;
  const bool read = tjDecompressHeader3(turbo.get(), reinterpret_cast<const unsigned char*>(content.data()),
                                        content.size(), &size.width, &size.height, &subsampling, &colours) == 0;
  return read && isPossible(size.width, size.height) ? std::optional{size} : std::nullopt;
}

std::optional<GreyPicture> decodePng(std::string_view content) {
  png_image image{};
  const PngFreed freed{&image, png_image_free};
  if (!beginPng(content, image)) {
    return std::nullopt;
  }
  const bool coloured = (image.format & (PNG_FORMAT_FLAG_COLOR | PNG_FORMAT_FLAG_COLORMAP)) != 0;
  image.format = coloured ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
  image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB; // treats 16-bit levels as nonlinear, too
  GreyPicture result{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  result.pixels.resize(PNG_IMAGE_SIZE(image));
  const png_color white{255, 255, 255};
  if (png_image_finish_read(&image, &white, result.pixels.data(), 0, nullptr) == 0) {
    return std::nullopt;
  }
  if (coloured) {
    const std::size_t pixels = result.pixels.size() / 3;
    for (std::size_t i = 0; i < pixels; ++i) {
      result.pixels[i] = luma(&result.pixels[3 * i]);
    }
    result.pixels.resize(pixels);
  }
  return result;
}

std::optional<GreyPicture> decodeJpeg(std::string_view content) {
  const TurboJpeg turbo{tjInitDecompress(), tjDestroy};
  const auto* bytes = reinterpret_cast<const unsigned char*>(content.data());
  const auto size = jpegSize(turbo, content);
  if (!size) {
    return std::nullopt;
  }
  GreyPicture result{size->width, size->height, {}};
  result.pixels.resize(std::size_t(result.width) * std::size_t(result.height));
  // libjpeg only warns about a truncated file and fills the rest with grey
  return tjDecompress2(turbo.get(), bytes, content.size(), result.pixels.data(), result.width, 0, result.height,
                       TJPF_GRAY, TJFLAG_STOPONWARNING | TJFLAG_ACCURATEDCT) == 0
             ? std::optional{std::move(result)}
             : std::nullopt;
}

bool isPng(std::string_view content) {
  return content.starts_with("\x89PNG");
}

[[noreturn]] void refusePicture(const std::string& name) {
  throw InputError{fmt::format("{}: expected a whole picture (.png or .jpg), but it could not be read as one", name)};
}

/// Low-level PNG encoder: three times faster on noisy pictures than libpng's simplified interface. False if libpng
/// failed (longjmp).
bool encodeAsPng(const GreyPicture& picture, std::string& content) {
  png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = writer == nullptr ? nullptr : png_create_info_struct(writer);
  if (info == nullptr) { // no memory
    png_destroy_write_struct(&writer, nullptr);
    return false;
  }
  if (setjmp(png_jmpbuf(writer)) != 0) {
    png_destroy_write_struct(&writer, &info);
    return false;
  }
  const auto append = [](png_structp self, png_bytep bytes, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(self))->append(reinterpret_cast<const char*>(bytes), count);
  };
  png_set_write_fn(writer, &content, append, nullptr);
  png_set_IHDR(writer, info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height), 8,
               PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_filter(writer, 0, PNG_FILTER_SUB);
  png_set_compression_level(writer, 1);
  png_set_compression_strategy(writer, 3); // run-length encoding only (Z_RLE)
  png_write_info(writer, info);
  for (int row = 0; row < picture.height; ++row) {
    png_write_row(writer, &picture.pixels[std::size_t(row) * std::size_t(picture.width)]);
  }
  png_write_end(writer, info);
  png_destroy_write_struct(&writer, &info);
  return true;
}

} // namespace

PictureSize imageSize(std::string_view content, const std::string& name) {
  const auto size = isPng(content) ? pngSize(content) : jpegSize({tjInitDecompress(), tjDestroy}, content);
  if (!size) {
    refusePicture(name);
  }
  return *size;
}

GreyPicture decodeImage(std::string_view content, const std::string& name,
                        const std::optional<PictureSize>& described) {
  if (described) {
    if (const PictureSize size = imageSize(content, name); size != *described) {
      throw InputError{fmt::format("{}: the picture has {} x {} pixels, but its camera is described with {} x {}", name,
                                   size.width, size.height, described->width, described->height)};
    }
  }
  auto picture = isPng(content) ? decodePng(content) : decodeJpeg(content);
  if (!picture) {
    refusePicture(name);
  }
  return *std::move(picture);
}

GreyPicture readImage(const std::filesystem::path& file, const std::optional<PictureSize>& described) {
  if (!std::filesystem::exists(file)) {
    throw InputError{fmt::format("{}: a picture was expected, but there is no such file", file.string())};
  }
  return decodeImage(readFile(file), file.string(), described);
}

std::string encodePng(const GreyPicture& picture) {
  std::string content;
  if (!isPossible(picture.width, picture.height) || !encodeAsPng(picture, content)) {
    throw InputError{fmt::format("a picture of {} x {} pixels was expected to become a PNG, but it cannot",
                                 picture.width, picture.height)};
  }
  return content;
}

std::string encodeJpeg(std::span<const std::uint8_t> pixels, int width, int height, int quality) {
  const TurboJpeg turbo{tjInitCompress(), tjDestroy};
  const bool coloured = pixels.size() > std::size_t(width) * std::size_t(height);
  const int subsampling = coloured ? TJSAMP_420 : TJSAMP_GRAY;
  unsigned long size = tjBufSize(width, height, subsampling);
  std::string content(size, '\0');
  auto* bytes = reinterpret_cast<unsigned char*>(content.data());
  if (tjCompress2(turbo.get(), pixels.data(), width, 0, height, coloured ? TJPF_RGB : TJPF_GRAY, &bytes, &size,
                  subsampling, quality, TJFLAG_NOREALLOC | TJFLAG_ACCURATEDCT) != 0) {
    throw InputError{fmt::format("a picture of {} x {} pixels cannot become a JPEG: {}", width, height,
                                 tjGetErrorStr2(turbo.get()))};
  }
  content.resize(size);
  return content;
}

void writeImage(const GreyPicture& picture, const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending != ".png" && ending != ".jpg") {
    throw InputError{
        fmt::format("{}: expected a picture's name that ends with .png or .jpg, found '{}'", file.string(), ending)};
  }
  writeAtomically(file, ending == ".png" ? encodePng(picture)
                                         : encodeJpeg(picture.pixels, picture.width, picture.height, 95));
}

} // namespace naocal
