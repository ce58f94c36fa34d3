#include "io/Files.hpp"

#include "io/InputError.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <openssl/evp.h>
#include <random>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace naocal {
namespace {

[[noreturn]] void refuseWriting(const std::filesystem::path& file, const std::string& reason) {
  throw InputError{fmt::format("{}: cannot be written: {}; choose another place", file.string(), reason)};
}

/// RAII file descriptor; failures are reported in `errno`.
class Descriptor {
public:
  Descriptor(const std::filesystem::path& file, int flags) : number_{::open(file.c_str(), flags | O_CLOEXEC, 0666)} {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool isOpen() const { return number_ >= 0; }
  bool sync() const { return ::fsync(number_) == 0; }
  bool allow(mode_t permissions) const { return ::fchmod(number_, permissions) == 0; }

  bool write(std::string_view content) const {
    while (!content.empty()) {
      const ssize_t count = ::write(number_, content.data(), content.size());
      if (count < 0 && errno != EINTR) {
        return false;
      }
      content.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
    }
    return true;
  }

  bool close() {
    const int number = std::exchange(number_, -1);
    return number < 0 || ::close(number) == 0;
  }

private:
  int number_;
};

} // namespace

std::string readFile(const std::filesystem::path& file) {
  std::error_code ignored;
  const bool folder = std::filesystem::is_directory(file, ignored);
  errno = 0;
  const std::ifstream stream{file, std::ios::binary};
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream.is_open() || content.bad() || folder) {
    const int reason = errno;
    throw InputError{folder ? fmt::format("{}: expected a file, found a folder; check the path", file.string())
                     : reason == ENOENT ? fmt::format("{}: no such file; check the path", file.string())
                                        : fmt::format("{}: cannot be read: {}; check the path and its permissions",
                                                      file.string(), std::strerror(reason))};
  }
  return std::move(content).str();
}

void writeAtomically(const std::filesystem::path& file, std::string_view content) {
  std::error_code ignored; // follows symbolic links: replaces their target
  const auto target = std::filesystem::weakly_canonical(std::filesystem::absolute(file, ignored), ignored);
  struct stat existing {};
  const bool exists = ::stat(target.c_str(), &existing) == 0;
  if (exists && S_ISDIR(existing.st_mode)) {
    refuseWriting(file, "it is a folder");
  }
  if (exists && !S_ISREG(existing.st_mode)) { // pipes and devices have no content to replace
    if (const Descriptor device{target, O_WRONLY}; !device.isOpen() || !device.write(content)) {
      refuseWriting(file, std::strerror(errno));
    }
    return;
  }
  const auto folder = target.parent_path();
  const auto temporary = folder / fmt::format(".{}.{:x}.part", target.filename().string(), std::random_device{}());
  Descriptor part{temporary, O_WRONLY | O_CREAT | O_EXCL};
  if (!part.isOpen()) {
    refuseWriting(file, std::strerror(errno));
  }
  const bool replaced = (!exists || part.allow(existing.st_mode & 07777)) && part.write(content) && part.sync() &&
                        part.close() && ::rename(temporary.c_str(), target.c_str()) == 0;
  if (!replaced) {
    const std::string reason = std::strerror(errno);
    ::unlink(temporary.c_str());
    refuseWriting(file, reason);
  }
  if (const Descriptor directory{folder, O_RDONLY | O_DIRECTORY}; directory.isOpen()) {
    directory.sync(); // makes the new name durable; without it the file is still complete
  }
}

std::string sha256(std::string_view content) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  if (EVP_Digest(content.data(), content.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error{"OpenSSL offers no SHA-256"};
  }
  std::string text;
  for (unsigned int i = 0; i < size; ++i) {
    text += fmt::format("{:02x}", digest[i]);
  }
  return text;
}

TemporaryDirectory::TemporaryDirectory(const std::filesystem::path& parent) {
  std::string name = (parent / "naocal-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw InputError{"no temporary folder could be made; is the disk full?"};
  }
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

} // namespace naocal
