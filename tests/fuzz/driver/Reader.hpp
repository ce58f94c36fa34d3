#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// A reader of bytes from outside. Throws InputError for bytes that it refuses; any other exception is a finding. A
/// file of tests/fuzz/readers/ defines one; tests/fuzz/corpus/<name>/ holds its inputs.
class Reader {
public:
  using Read = void (*)(std::string_view bytes);

  /// Registers itself for the program's lifetime. `longest`: processor time of one read of all threads [s].
  Reader(std::string name, Read read, int longest = 2);
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  const std::string& name() const { return name_; }
  void read(std::string_view bytes) const { read_(bytes); }
  int longest() const { return longest_; }

  /// All readers of this program, in no particular order.
  static const std::vector<const Reader*>& all();

private:
  std::string name_;
  Read read_;
  int longest_;
};

} // namespace naocal
