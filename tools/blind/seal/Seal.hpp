#pragma once

#include <filesystem>
#include <string>

namespace blind {

/// Seals a truth until the answers are written: text XOR SHA-256(key, 0), SHA-256(key, 1), ... Not secret (the key is
/// stored beside it) but tamper-evident: the SHA-256 of the sealed bytes is published before any answer is written.
std::string seal(const std::string& text, const std::string& key);
inline std::string unseal(const std::string& bytes, const std::string& key) {
  return seal(bytes, key);
}

/// Lower-case hexadecimal SHA-256.
std::string sha256Hex(const std::string& bytes);

std::string readFile(const std::filesystem::path& file);                       // throws if unreadable
void writeFile(const std::filesystem::path& file, const std::string& content); // atomic

} // namespace blind
