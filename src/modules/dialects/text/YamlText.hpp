#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>
#include <yaml-cpp/yaml.h>

namespace naocal {

/// A place in a YAML document, with its line, for messages (InputError) with file, line, expected and found.
class YamlCursor {
public:
  /// The top level of a text; `file` stands for it in messages. Throws InputError for invalid syntax.
  YamlCursor(const std::string& text, std::string file);

  bool has(const std::string& key) const;
  YamlCursor at(const std::string& key) const;                         // throws without the key
  std::vector<YamlCursor> at(std::span<const char* const> keys) const; // in this order
  std::vector<std::pair<std::string, YamlCursor>> members() const;
  std::vector<YamlCursor> elements() const;

  /// Where the value's text begins [bytes].
  std::size_t position() const { return static_cast<std::size_t>(std::max(node_.Mark().pos, 0)); }

  std::string text() const;
  int integer(int lowest, int highest) const;
  double number() const; // finite
  /// A list of numbers; throws unless it has `count`.
  std::vector<double> numbers(std::size_t count) const;

  [[noreturn]] void refuse(const std::string& expected, const std::string& found) const;

private:
  YamlCursor(YAML::Node node, std::string file, std::string path)
      : node_{std::move(node)}, file_{std::move(file)}, path_{std::move(path)} {}
  std::string found() const;

  YAML::Node node_;
  std::string file_, path_;
};

} // namespace naocal
