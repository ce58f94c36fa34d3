#include "io/FileVersion.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

const std::string_view thisProgram = "naocal " NAOCAL_VERSION;

namespace {

/// "naocal 9.1.0", or "a newer naocal" if the file does not say.
std::string describeWriter(const JsonCursor& document) {
  constexpr std::size_t longest = 40; // of a plausible name and version
  const auto by = document.find("writtenBy");
  const bool isNamed = by && by->value().is_string() && !by->value().get_ref<const std::string&>().empty() &&
                       by->value().get_ref<const std::string&>().size() <= longest;
  return isNamed ? by->value().get<std::string>() : "a newer naocal";
}

} // namespace

nlohmann::json withFormat(std::string_view format, nlohmann::json content) {
  content.update({{"format", format}, {"version", 1}, {"writtenBy", thisProgram}});
  return content;
}

nlohmann::ordered_json withFormatInOrder(std::string_view format, const nlohmann::ordered_json& content, int version) {
  nlohmann::ordered_json all{{"format", format}, {"version", version}, {"writtenBy", thisProgram}};
  all.update(content);
  return all;
}

void requireVersion(const JsonCursor& document, int newest) {
  const JsonCursor version = document.at("version");
  const std::string writer = describeWriter(document); // `writtenBy` is a known key of every file
  if (const int found = version.integer(1, maxInteger); found > newest) {
    version.describeAs("", fmt::format("{} wrote the file, this is {}; update this program", writer, thisProgram))
        .refuse(newest == 1 ? "1" : fmt::format("1 to {}", newest));
  }
}

void requireFormat(const JsonCursor& document, std::string_view format, int newest) {
  document.at("format").wordIndex({format});
  requireVersion(document, newest);
}

} // namespace naocal
