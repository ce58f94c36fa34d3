#include "OpenedSets.hpp"

#include "captures/CaptureSetFile.hpp"
#include "captures/Files.hpp"
#include "captures/InputError.hpp"
#include "captures/JsonPlace.hpp"
#include "captures/JsonText.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

void addSet(const std::string& folder, OpenedSets& opened) {
  CaptureSet set = readCaptureSet(folder, BadCaptures::refuse).set;
  if (!opened.folders.emplace(set.name, folder).second) {
    throw InputError{fmt::format("two sets are called \"{}\"; rename the folder of one", set.name)};
  }
  opened.inputs.sets.push_back(std::filesystem::weakly_canonical(folder).string());
  opened.inputs.sha256.push_back(sha256(fileContent(std::filesystem::path{folder} / "captures.json")));
  opened.sets.push_back(std::move(set));
}

/// A set as a result names it: as it is written, else beside the result.
std::string folderOf(const std::string& written, const std::filesystem::path& result) {
  const std::filesystem::path beside =
      result.parent_path() / std::filesystem::path{written}.lexically_normal().filename();
  for (const std::filesystem::path& folder : {std::filesystem::path{written}, beside}) {
    if (std::filesystem::exists(folder / "captures.json")) {
      return folder.string();
    }
  }
  throw InputError{
      fmt::format("{}: the capture set {} that it was made from is not there any more, nor is {}; open the "
                  "captures themselves",
                  result.string(), written, beside.string())};
}

void addResult(const std::string& file, OpenedSets& opened) {
  const nlohmann::json document = parseJson(fileContent(file), file);
  const JsonPlace result{document, file};
  if (const std::string format = result.at("format").text(); format != "naocal-result") {
    result.at("format").refuse("\"naocal-result\": mate-bridge opens capture sets and results");
  }
  const StoredResult stored = readResult(file);
  opened.terms = stored.terms;
  opened.definitions = stored.definitions;
  for (const JsonPlace& set : result.at("inputs").at("sets").elements()) {
    addSet(folderOf(set.text(), file), opened);
  }
}

} // namespace

OpenedSets openSets(const std::vector<std::string>& paths) {
  OpenedSets opened;
  for (const std::string& path : paths) {
    if (std::filesystem::is_directory(path) || !path.ends_with(".json")) {
      addSet(path, opened);
    } else if (paths.size() > 1) {
      throw InputError{fmt::format("{}: a result is opened by itself, with the sets that it was made from", path)};
    } else {
      addResult(path, opened);
    }
  }
  if (opened.sets.empty()) {
    throw InputError{"expected a folder with captures.json or a result; found none"};
  }
  opened.robot = loadRobot(configurationDirectory(), opened.sets.front().model);
  return opened;
}

} // namespace naocal
