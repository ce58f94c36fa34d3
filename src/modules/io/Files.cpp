#include "io/Files.hpp"

#include "io/Folders.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <memory>
#include <new>
#include <openssl/evp.h>
#include <random>
#include <sys/file.h>
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
  int number() const { return number_; }
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

[[noreturn]] void refuseReading(const std::filesystem::path& file, int reason) {
  throw InputError{reason == ENOENT ? fmt::format("{}: no such file; check the path", file.string())
                                    : fmt::format("{}: cannot be read: {}; check the path and its permissions",
                                                  file.string(), std::strerror(reason))};
}

/// Throws InputError unless it is a regular file of at most `most` bytes.
void requireReadable(const std::filesystem::path& file, const struct stat& status, std::uintmax_t most) {
  if (S_ISDIR(status.st_mode)) {
    throw InputError{fmt::format("{}: expected a file, found a folder; check the path", file.string())};
  }
  if (!S_ISREG(status.st_mode)) {
    throw InputError{fmt::format("{}: expected a file, found a {}; copy its content into a file first", file.string(),
                                 S_ISFIFO(status.st_mode)   ? "pipe"
                                 : S_ISSOCK(status.st_mode) ? "socket"
                                                            : "device")};
  }
  if (static_cast<std::uintmax_t>(status.st_size) > most) {
    throw InputError{
        fmt::format("{}: expected at most {} bytes in a file, found {}", file.string(), most, status.st_size)};
  }
}

/// Appends all bytes up to `most`; files of the system (/proc) tell no size before. Returns errno, 0 on success.
int appendContent(int number, std::uintmax_t most, std::string& content) {
  constexpr std::size_t step = 1 << 16;
  for (;;) {
    const std::size_t size = content.size();
    content.resize(size + step);
    const ssize_t count = ::read(number, content.data() + size, step);
    const int reason = errno;
    content.resize(size + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count < 0 && reason != EINTR) {
      return reason;
    }
    if (count == 0) {
      return 0;
    }
    if (content.size() > most) {
      return EFBIG;
    }
  }
}

constexpr std::string_view partEnd = ".part";

/// The temporary file that replaces `target`; locked while it is written, so that abandoned ones can be told.
struct PartFile {
  std::filesystem::path path;
  std::unique_ptr<Descriptor> descriptor; // not open on failure (`errno`)
};

PartFile createPart(const std::filesystem::path& target) {
  for (;;) {
    PartFile part;
    part.path =
        target.parent_path() / fmt::format(".{}.{:x}{}", target.filename().string(), std::random_device{}(), partEnd);
    part.descriptor = std::make_unique<Descriptor>(part.path, O_WRONLY | O_CREAT | O_EXCL);
    struct stat status {};
    const int number = part.descriptor->number();
    const bool removed = part.descriptor->isOpen() && ::flock(number, LOCK_EX) == 0 && ::fstat(number, &status) == 0 &&
                         status.st_nlink == 0; // another process took it for abandoned before it was locked
    if (!removed) {
      return part;
    }
  }
}

/// Whether the name is that of a temporary file: ".<file>.<hexadecimal>.part".
bool isPartName(const std::string& name) {
  const std::size_t end = name.size() - std::min(name.size(), partEnd.size());
  const std::size_t dot = name.rfind('.', end == 0 ? 0 : end - 1);
  return name.starts_with('.') && name.ends_with(partEnd) && dot != std::string::npos && dot > 1 && dot + 1 < end &&
         name.find_first_not_of("0123456789abcdef", dot + 1) == end;
}

void removeIfAbandoned(const std::filesystem::path& part) {
  const Descriptor descriptor{part, O_RDONLY | O_NOFOLLOW | O_NONBLOCK};
  struct stat status {};
  if (descriptor.isOpen() && ::fstat(descriptor.number(), &status) == 0 && S_ISREG(status.st_mode) &&
      ::flock(descriptor.number(), LOCK_EX | LOCK_NB) == 0) {
    ::unlink(part.c_str());
  }
}

} // namespace

std::string readFile(const std::filesystem::path& file, std::uintmax_t most) {
  const Descriptor descriptor{file, O_RDONLY | O_NONBLOCK}; // opening a pipe does not wait for its writer
  struct stat status {};
  if (!descriptor.isOpen() || ::fstat(descriptor.number(), &status) != 0) {
    refuseReading(file, errno);
  }
  requireReadable(file, status, most);
  std::string content;
  int reason = 0;
  try {
    content.reserve(static_cast<std::size_t>(status.st_size) + 1);
    reason = appendContent(descriptor.number(), most, content);
  } catch (const std::bad_alloc&) {
    content = {};
    throw InputError{fmt::format("{}: its {} bytes do not fit into the memory that is left; end other programs or "
                                 "name a smaller file",
                                 file.string(), status.st_size)};
  }
  if (reason != 0) {
    refuseReading(file, reason);
  }
  return content;
}

std::optional<std::filesystem::path> fileInside(const std::filesystem::path& folder,
                                                const std::filesystem::path& inside) {
  if (inside.empty() || inside.is_absolute()) {
    return std::nullopt;
  }
  std::error_code failed;
  const auto whole = std::filesystem::weakly_canonical(std::filesystem::absolute(folder, failed), failed);
  const auto file = failed ? whole : std::filesystem::weakly_canonical(whole / inside, failed);
  const auto relative = file.lexically_relative(whole);
  if (failed || relative.empty() || relative == "." || *relative.begin() == "..") {
    return std::nullopt;
  }
  return file;
}

void writeAtomically(const std::filesystem::path& file, std::string_view content) {
  std::error_code ignored; // follows symbolic links: replaces their target
  const auto target = std::filesystem::weakly_canonical(std::filesystem::absolute(file, ignored), ignored);
  struct stat existing {};
  const bool exists = ::stat(target.c_str(), &existing) == 0;
  if (exists && S_ISDIR(existing.st_mode)) {
    refuseWriting(file, "it is a folder");
  }
  if (exists && !S_ISREG(existing.st_mode)) {               // pipes and devices have no content to replace
    const Descriptor device{target, O_WRONLY | O_NONBLOCK}; // opening a pipe does not wait for its reader
    if (!device.isOpen() && errno == ENXIO) {
      refuseWriting(file, "it is a pipe that nobody reads");
    }
    if (!device.isOpen() || ::fcntl(device.number(), F_SETFL, 0) != 0 || !device.write(content)) {
      refuseWriting(file, std::strerror(errno));
    }
    return;
  }
  const auto folder = target.parent_path();
  const auto [temporary, descriptor] = createPart(target);
  Descriptor& part = *descriptor;
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
  syncFolder(folder); // without it the file is still complete
}

void removeAbandonedWrites(const std::filesystem::path& folder) {
  using Iterator = std::filesystem::recursive_directory_iterator;
  std::error_code failed;
  for (Iterator at{folder, std::filesystem::directory_options::skip_permission_denied, failed}, end;
       !failed && at != end; at.increment(failed)) {
    if (isPartName(at->path().filename().string())) {
      removeIfAbandoned(at->path());
    }
  }
}

void removeAbandonedWritesOf(const std::filesystem::path& file) {
  std::error_code failed;
  const auto target = std::filesystem::weakly_canonical(std::filesystem::absolute(file, failed), failed);
  const std::string start = "." + target.filename().string() + ".";
  for (std::filesystem::directory_iterator at{target.parent_path(), failed}, end; !failed && at != end;
       at.increment(failed)) {
    const std::string name = at->path().filename().string();
    if (name.starts_with(start) && isPartName(name)) {
      removeIfAbandoned(at->path());
    }
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
