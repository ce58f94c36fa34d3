#include "framework/WrittenTogether.hpp"

#include "framework/ConfigurationLayers.hpp"
#include "framework/Errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

void writeTogether(const std::filesystem::path& journal, const std::vector<FileContent>& files,
                   const FileWriter& writer) {
  if (files.empty()) {
    return;
  }
  nlohmann::json noted = {{"files", nlohmann::json::array()}};
  for (const FileContent& one : files) {
    noted["files"].push_back({{"file", one.file.string()}, {"content", one.content}});
    std::filesystem::create_directories(one.file.parent_path());
  }
  writer(journal, noted.dump());
  for (const FileContent& one : files) {
    writer(one.file, one.content);
  }
  std::filesystem::remove(journal);
}

void finishWriting(const std::filesystem::path& journal, const FileWriter& writer) {
  const auto noted = readConfiguration(journal);
  if (!noted) {
    return;
  }
  try {
    for (const nlohmann::json& one : noted->at("files")) {
      writer(one.at("file").get<std::string>(), one.at("content").get_ref<const std::string&>());
    }
  } catch (const nlohmann::json::exception&) {
    throw ConfigurationError{fmt::format("{}: expected files and their content, which a save that was cut off left "
                                         "behind, found something else; remove it",
                                         journal.string())};
  }
  std::filesystem::remove(journal);
}

} // namespace naocal
