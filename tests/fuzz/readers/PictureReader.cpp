#include "fuzz/driver/Reader.hpp"
#include "io/GreyImage.hpp"

#include <stdexcept>

namespace naocal {
namespace {

/// A PNG or JPEG: the size of its header is that of what is decoded.
void readPicture(std::string_view bytes) {
  const PictureSize size = imageSize(bytes, "picture");
  const GreyPicture picture = decodeImage(bytes, "picture");
  if (!(size == PictureSize{picture.width, picture.height}) ||
      picture.pixels.size() != std::size_t(size.width) * std::size_t(size.height)) {
    throw std::logic_error{"a picture has another size than its header says"};
  }
}

const Reader pictureReader{"picture", readPicture};

} // namespace
} // namespace naocal
