#pragma once

#include "dialects/text/YamlText.hpp"

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

namespace naocal {

enum class InPlaceSyntax { yaml, json5 };

/// A file of another program whose values are replaced in place: every other byte of it stays.
///
/// JSON5 is read as what YAML calls flow: bare keys, single quotes and commas at ends are allowed there, too. Its
/// comments are passed over. A bare key needs a space behind its colon, as everybody writes it.
class InPlaceText {
public:
  /// `file` stands for the text in messages. Throws InputError for invalid syntax, with line and column.
  InPlaceText(std::string text, const std::string& file, InPlaceSyntax syntax);

  const YamlCursor& top() const { return top_; }

  /// Writes `written` in place of a number or text. Throws InputError for one that spans lines or has escapes.
  void replace(const YamlCursor& value, const std::string& written);

  /// Writes three numbers in place of three values, each as `print` forms it.
  void replace(const std::vector<YamlCursor>& values, const Eigen::Vector3d& numbers, std::string (*print)(double));

  /// The text with all replacements.
  std::string edited() const;

private:
  struct Replacement {
    std::size_t length;
    std::string written;
  };

  std::string text_;
  YamlCursor top_;
  std::map<std::size_t, Replacement> replacements_; // by place [bytes]
};

} // namespace naocal
