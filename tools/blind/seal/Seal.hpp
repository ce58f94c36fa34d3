#pragma once

#include <filesystem>
#include <string>

namespace blind {

/// Truths are sealed until answers are written: the text XOR SHA-256(key, 0), SHA-256(key, 1), ... Whoever wants to
/// read them can (the key lies beside them), but nobody can change one unnoticed: the sealed bytes' SHA-256 is
/// published before any answer is written.
std::string seal(const std::string& text, const std::string& key);
inline std::string unseal(const std::string& bytes, const std::string& key) {
  return seal(bytes, key);
}

std::string sha256Hex(const std::string& bytes);

std::string readFile(const std::filesystem::path& file);                       // throws when it cannot
void writeFile(const std::filesystem::path& file, const std::string& content); // whole or not at all

} // namespace blind
