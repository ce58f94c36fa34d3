#include "recordings/CameraModelFile.hpp"

#include "TemporaryFolder.hpp"
#include "fuzz/driver/Reader.hpp"

#include <fstream>

namespace naocal {
namespace {

void readAsCameraModel(std::string_view bytes) {
  static const TemporaryFolder folder;
  const auto file = folder.path() / "lens.yaml";
  std::ofstream{file, std::ios::binary | std::ios::trunc}.write(bytes.data(), std::streamsize(bytes.size()));
  readCameraModel(file);
}

const Reader cameraModelReader{"camera-model", readAsCameraModel};

} // namespace
} // namespace naocal
