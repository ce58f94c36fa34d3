#include "analysis/Dataset.hpp"

#include "data/CaptureSetFile.hpp"
#include "data/SetSearch.hpp"
#include "detect/BoardDetector.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "robot/RobotOfSet.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>

namespace naocal {

namespace {

/// Whether a folder holds a capture set; false if it cannot be accessed (the reader then reports the problem).
bool isSet(const std::filesystem::path& folder) {
  std::error_code ignored;
  return std::filesystem::exists(folder / "captures.json", ignored);
}

/// Reads a set; detects corners in images without detections. Throws InputError.
void addSet(const std::string& folder, Dataset& opened) {
  CaptureSet set = readCaptureSet(folder, BadCapturePolicy::refuse).set;
  if (std::any_of(set.captures.begin(), set.captures.end(), [](const Capture& one) { return !one.corners; })) {
    detectInSet(set, folder, std::max(1U, std::thread::hardware_concurrency()),
                [](std::size_t, std::size_t) { return true; });
  }
  if (!opened.folders.emplace(set.name, folder).second) {
    throw InputError{fmt::format("two sets are called \"{}\"; rename the folder of one", set.name)};
  }
  opened.inputs.add(folder);
  opened.sets.push_back(std::move(set));
}

/// Whether the path is a folder; false if it cannot be accessed.
bool isDirectory(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

/// How a document uses its sets: fits them anew, or continues with what it knows of them.
enum class InputUse { fitsAnew, continues };

/// Finds the folder of a document's set; one that has changed serves for a new fit. Throws MissingCaptures.
std::string findFolder(const NamedSet& set, const SetSearch& search, InputUse use, Dataset& opened) {
  const SoughtSet sought = findSet(set, search);
  const auto& folder = sought.folder || use == InputUse::continues ? sought.folder : sought.changed;
  if (!folder) {
    throw MissingCaptures{sought.sentence};
  }
  if (!sought.sentence.empty()) {
    opened.moved.push_back(sought.sentence);
  }
  return folder->string();
}

/// Adds a set, or all sets in a folder, as in a robot's recording. Throws InputError.
void addFolder(const std::string& folder, Dataset& opened) {
  std::vector<std::string> sets;
  if (!isSet(folder) && isDirectory(folder)) {
    std::error_code unreadable;
    for (const auto& entry : std::filesystem::directory_iterator{folder, unreadable}) {
      if (isDirectory(entry.path()) && isSet(entry.path())) {
        sets.push_back(entry.path().string());
      }
    }
    std::sort(sets.begin(), sets.end());
  }
  if (sets.empty()) {
    sets.push_back(folder); // the reader reports the problem
  }
  for (const std::string& set : sets) {
    addSet(set, opened);
  }
}

bool isDocument(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) || (!isDirectory(path) && path.ends_with(".json"));
}

/// Adds the sets that a document refers to. Throws MissingCaptures.
void addInputs(const JsonCursor& inputs, const SetSearch& search, InputUse use, Dataset& opened) {
  const std::vector<std::string> places = inputs.at("sets").texts();
  const auto told = inputs.find("sha256");
  const auto sums = told ? told->elements() : std::vector<JsonCursor>{};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool hasSum = i < sums.size() && sums[i].value() != "";
    addSet(findFolder({places[i], hasSum ? sums[i].text() : ""}, search, use, opened), opened);
  }
  if (const auto setUps = inputs.find("setUps")) {
    opened.inputs.setUps = setUps->texts();
  }
}

/// Adds a diagnosis: the suggested effects, and its sets unless sets are given.
void addDiagnosis(const JsonCursor& diagnosis, const SetSearch& search, bool setsAreNamed, Dataset& opened) {
  for (const JsonCursor& label : diagnosis.at("suggested").elements()) {
    opened.with.push_back(label.text());
  }
  if (!setsAreNamed) {
    if (!diagnosis.find("inputs")) {
      throw InputError{fmt::format("{}: this diagnosis does not say of which captures it is; name them behind it",
                                   search.document.string())};
    }
    addInputs(diagnosis.at("inputs"), search, InputUse::fitsAnew, opened);
  }
}

void takeModel(const std::string& resultFile, Dataset& opened) {
  const StoredResult stored = readResult(resultFile);
  opened.result = resultFile;
  opened.terms = stored.terms;
  opened.definitions = stored.definitions;
}

void addResult(const JsonCursor& result, const SetSearch& search, Dataset& opened) {
  takeModel(search.document.string(), opened);
  addInputs(result.at("inputs"), search, InputUse::fitsAnew, opened);
}

/// The solved round of a robot's recording: its subfolder "first", or the folder itself.
std::optional<std::filesystem::path> solvedRound(const std::filesystem::path& folder) {
  for (const std::filesystem::path& round : {folder / "first", folder}) {
    std::error_code ignored;
    if (std::filesystem::exists(round / "captures.json", ignored) &&
        std::filesystem::exists(round / "offsets.json", ignored) &&
        std::filesystem::exists(round / "result.json", ignored)) {
      return round;
    }
  }
  return std::nullopt;
}

/// Adds a folder opened alone. A robot's recording gives the solved round and its model; the check round was taken with
/// other offsets and must be opened explicitly.
void addAlone(const std::string& folder, Dataset& opened) {
  if (const auto round = solvedRound(folder)) {
    addSet(round->string(), opened);
    takeModel((*round / "result.json").string(), opened);
  } else {
    addFolder(folder, opened);
  }
}

/// Adds a model: added, removed and custom effects; the caller gives the captures.
void addModel(const JsonCursor& model, const std::string& file, bool alone, Dataset& opened) {
  if (alone) {
    throw InputError{fmt::format("{}: a model is opened together with captures; name them behind it", file)};
  }
  for (const auto& [key, list] : {std::pair{"with", &opened.with}, std::pair{"without", &opened.without}}) {
    if (const auto labels = model.find(key)) {
      for (const JsonCursor& label : labels->elements()) {
        list->push_back(label.text());
      }
    }
  }
  if (const auto define = model.find("define")) {
    opened.definitions = define->value().dump();
  }
}

/// Adds a session: its revisions, and its sets unless sets are given.
void addSession(const JsonCursor& document, const SetSearch& search, bool alone, Dataset& opened) {
  Session session = readSession(search.document);
  if (alone) {
    addInputs(document, search, InputUse::continues, opened);
  }
  requireSameCaptures(session, opened.inputs, search.document);
  opened.ladder = std::move(session.ladder);
  opened.at = session.at;
}

/// Adds a result, a diagnosis, a session or a model; `alone`: no sets are given.
void addDocument(const SetSearch& search, bool alone, Dataset& opened) {
  const std::string file = search.document.string();
  const nlohmann::json document = parseJson(readFile(file), file);
  const JsonCursor place{document, file};
  const std::string format = place.at("format").text();
  if (format == "naocal-diagnosis") {
    return addDiagnosis(place, search, !alone, opened);
  }
  if (format == "naocal-model") {
    return addModel(place, file, alone, opened);
  }
  if (format == "naocal-session") {
    return addSession(place, search, alone, opened);
  }
  if (format != "naocal-result") {
    place.at("format").refuse("\"naocal-result\", \"naocal-diagnosis\", \"naocal-session\" or \"naocal-model\": "
                              "mate-bridge opens capture sets, recordings, results, diagnoses, sessions and models");
  }
  if (!alone) {
    throw InputError{fmt::format("{}: a result is opened by itself, with the sets that it was made from", file)};
  }
  addResult(place, search, opened);
}

} // namespace

Dataset openDataset(const std::vector<std::string>& paths, const std::vector<std::filesystem::path>& lookIn) {
  Dataset opened;
  for (const std::string& path : paths) {
    if (!isDocument(path)) {
      paths.size() == 1 ? addAlone(path, opened) : addFolder(path, opened);
    }
  }
  for (const std::string& path : paths) {
    if (isDocument(path)) {
      addDocument({path, lookIn}, paths.size() == 1, opened);
    }
  }
  if (opened.sets.empty()) {
    throw InputError{"expected a folder with captures.json, a result or a diagnosis; found none"};
  }
  opened.robot = loadRobot(opened.sets);
  return opened;
}

Dataset openSession(std::vector<std::string> paths, const std::string& file,
                    const std::vector<std::filesystem::path>& lookIn) {
  if (std::filesystem::exists(file)) {
    paths.push_back(file);
  }
  Dataset opened = openDataset(paths, lookIn);
  opened.sessionFile = file;
  return opened;
}

} // namespace naocal
