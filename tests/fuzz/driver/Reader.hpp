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

  /// Registers itself for the program's lifetime.
  Reader(std::string name, Read read);
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  const std::string& name() const { return name_; }
  void read(std::string_view bytes) const { read_(bytes); }

  /// All readers of this program, in no particular order.
  static const std::vector<const Reader*>& all();

private:
  std::string name_;
  Read read_;
};

} // namespace naocal
