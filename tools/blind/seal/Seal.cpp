#include "seal/Seal.hpp"

#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <openssl/sha.h>
#include <stdexcept>
#include <unistd.h>

namespace blind {

namespace {

std::string sha256(const std::string& bytes) {
  std::string digest(SHA256_DIGEST_LENGTH, '\0');
  SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
         reinterpret_cast<unsigned char*>(digest.data()));
  return digest;
}

} // namespace

std::string seal(const std::string& text, const std::string& key) {
  std::string result = text;
  std::string stream;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t within = i % SHA256_DIGEST_LENGTH;
    if (within == 0) {
      stream = sha256(fmt::format("{} {}", key, i / SHA256_DIGEST_LENGTH));
    }
    result[i] = static_cast<char>(text[i] ^ stream[within]);
  }
  return result;
}

std::string sha256Hex(const std::string& bytes) {
  std::string hex;
  for (const char byte : sha256(bytes)) {
    hex += fmt::format("{:02x}", static_cast<unsigned char>(byte));
  }
  return hex;
}

std::string readFile(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  if (!stream) {
    throw std::runtime_error{fmt::format("{}: expected a readable file, found none", file.string())};
  }
  return {std::istreambuf_iterator<char>{stream}, {}};
}

void writeFile(const std::filesystem::path& file, const std::string& content) {
  if (file.has_parent_path()) {
    std::filesystem::create_directories(file.parent_path());
  }
  // unique name: parallel writers write the same key
  const std::filesystem::path temporary = fmt::format("{}.{}.part", file.string(), getpid());
  {
    std::ofstream stream{temporary, std::ios::binary};
    stream << content;
    stream.flush();
    if (!stream) {
      throw std::runtime_error{fmt::format("{}: cannot be written", temporary.string())};
    }
  }
  std::filesystem::rename(temporary, file);
}

} // namespace blind
