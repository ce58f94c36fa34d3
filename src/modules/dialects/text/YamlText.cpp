#include "dialects/text/YamlText.hpp"

#include "io/InputError.hpp"

#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

constexpr std::size_t largestText = 1 << 20; // [bytes]; camera files have a few hundred

} // namespace

YamlCursor::YamlCursor(const std::string& text, std::string file) : file_{std::move(file)} {
  if (text.size() > largestText) {
    throw InputError{fmt::format("{}: expected a camera's file, found {} bytes", file_, text.size())};
  }
  try {
    node_.reset(YAML::Load(text));
  } catch (const YAML::Exception& error) {
    throw InputError{fmt::format("{}: line {}, column {}: expected valid YAML, found an error: {}", file_,
                                 error.mark.line + 1, error.mark.column + 1, error.msg)};
  }
  if (!node_.IsMap()) {
    refuse("keys and values", found());
  }
}

bool YamlCursor::has(const std::string& key) const {
  return node_.IsMap() && static_cast<const YAML::Node&>(node_)[key].IsDefined();
}

YamlCursor YamlCursor::at(const std::string& key) const {
  if (!has(key)) {
    refuse(fmt::format("the key {}", key), "none");
  }
  return {static_cast<const YAML::Node&>(node_)[key], file_, path_.empty() ? key : path_ + "." + key};
}

std::vector<YamlCursor> YamlCursor::at(std::span<const char* const> keys) const {
  std::vector<YamlCursor> all;
  for (const char* const key : keys) {
    all.push_back(at(key));
  }
  return all;
}

std::vector<std::pair<std::string, YamlCursor>> YamlCursor::members() const {
  if (!node_.IsMap()) {
    refuse("keys and values", found());
  }
  std::vector<std::pair<std::string, YamlCursor>> all;
  for (const auto& member : node_) {
    const std::string key = member.first.IsScalar() ? member.first.Scalar() : "?";
    all.emplace_back(key, YamlCursor{member.second, file_, path_.empty() ? key : path_ + "." + key});
  }
  return all;
}

std::vector<YamlCursor> YamlCursor::elements() const {
  if (!node_.IsSequence()) {
    refuse("a list", found());
  }
  std::vector<YamlCursor> all;
  for (std::size_t i = 0; i < node_.size(); ++i) {
    all.push_back({node_[i], file_, fmt::format("{}[{}]", path_, i)});
  }
  return all;
}

std::string YamlCursor::text() const {
  if (!node_.IsScalar()) {
    refuse("a text", found());
  }
  return node_.Scalar();
}

int YamlCursor::integer(int lowest, int highest) const {
  const double value = number();
  if (value != std::floor(value) || value < lowest || value > highest) {
    refuse(fmt::format("a whole number from {} to {}", lowest, highest), found());
  }
  return static_cast<int>(value);
}

double YamlCursor::number() const {
  double value = 0;
  if (!node_.IsScalar() || !YAML::convert<double>::decode(node_, value) || !std::isfinite(value)) {
    refuse("a number", found());
  }
  return value;
}

std::vector<double> YamlCursor::numbers(std::size_t count) const {
  std::vector<double> all;
  for (const YamlCursor& element : elements()) {
    all.push_back(element.number());
  }
  if (all.size() != count) {
    refuse(fmt::format("{} numbers", count), std::to_string(all.size()));
  }
  return all;
}

void YamlCursor::refuse(const std::string& expected, const std::string& found) const {
  const int line = std::max(node_.Mark().line, 0) + 1;
  throw InputError{fmt::format("{}: line {}: {}expected {}, found {}", file_, line, path_.empty() ? "" : path_ + ": ",
                               expected, found)};
}

std::string YamlCursor::found() const {
  return node_.IsScalar()     ? fmt::format("\"{}\"", node_.Scalar())
         : node_.IsSequence() ? "a list"
         : node_.IsMap()      ? "keys and values"
                              : "nothing";
}

} // namespace naocal
