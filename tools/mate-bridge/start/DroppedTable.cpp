#include "start/DroppedTable.hpp"

#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "recordings/table/ColumnGuess.hpp"
#include "recordings/table/ColumnMeaning.hpp"
#include "recordings/table/TableImport.hpp"
#include "robot/Urdf.hpp"
#include "start/DroppedKinds.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <set>

namespace naocal {

namespace {

using Json = nlohmann::json;

constexpr std::uintmax_t largestMap = std::uintmax_t{4} << 20; // of a column map or a boards file [bytes]
constexpr std::size_t mostNames = 8;                           // listed in a sentence
constexpr std::size_t mostExamples = 3, longestExample = 40;   // cells of a column that the page shows
constexpr std::size_t mostPictureCells = 50;                   // that decide in which folder the pictures are

const std::vector<std::string> fileKeys{"table", "robot", "columns", "cameraModel", "boards", "pictures"};

/// "boards" of a boards file, "columns" of a column map; empty for other documents.
std::string kindOfDocument(const std::filesystem::path& file) {
  try {
    const Json document = parseJson(readFile(file, largestMap), file.string());
    if (document.is_object() && document.value("format", Json()) == "naocal-boards") {
      return "boards";
    }
    return document.is_object() && document.contains("joints") && !document.contains("format") ? "columns" : "";
  } catch (const InputError&) { // no JSON, or too large
    return "";
  }
}

std::string listed(std::vector<std::string> names) {
  const bool areMore = names.size() > mostNames;
  names.resize(std::min(names.size(), mostNames));
  return fmt::format("{}{}", fmt::join(names, ", "), areMore ? ", .." : "");
}

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::vector<std::string> linkNames(const Robot& robot) {
  std::vector<std::string> names;
  for (const Link& link : robot.links) {
    names.push_back(link.name);
  }
  return names;
}

/// The first cells of a column that are not empty.
std::vector<std::string> examplesOf(const CsvTable& table, std::size_t column) {
  std::vector<std::string> examples;
  for (std::size_t row = 0; row < table.rows() && examples.size() < mostExamples; ++row) {
    if (const std::string& cell = table.text(row, column); !cell.empty()) {
      examples.push_back(printableText(cell, longestExample));
    }
  }
  return examples;
}

} // namespace

void DroppedTable::add(std::shared_ptr<DroppedFiles> files) {
  const std::vector<std::string> names = files->names();
  if (files_) {
    files_->add(*files);
  } else {
    files_ = std::move(files);
  }
  for (std::string* last : {&tableName_, &robotName_, &columnsName_}) {
    if (std::find(names.begin(), names.end(), *last) != names.end()) {
      last->clear(); // is read again
    }
  }
  sortFiles();
  read();
}

/// Lists the dropped files by kind; pictures by all folders that lead to them.
void DroppedTable::sortFiles() {
  for (const std::string& key : fileKeys) {
    sources_[key].found.clear();
  }
  ignored_.clear();
  std::set<std::string> folders;
  for (const std::string& name : files_->names()) {
    const auto kind = droppedKindOf(name);
    const std::string key = kind == DroppedKind::document ? kindOfDocument(files_->folder() / name)
                            : kind == DroppedKind::table  ? "table"
                            : kind == DroppedKind::robot  ? "robot"
                            : kind == DroppedKind::lens   ? "cameraModel"
                                                          : "";
    if (kind == DroppedKind::picture) {
      for (auto folder = std::filesystem::path{name}.parent_path(); !folder.empty(); folder = folder.parent_path()) {
        folders.insert(folder.string());
      }
      folders.insert(".");
    } else if (key.empty()) {
      ignored_.push_back(name);
    } else {
      sources_[key].found.push_back(name);
    }
  }
  sources_["pictures"].found.assign(folders.begin(), folders.end());
}

/// The chosen file of a kind, or else the first one; empty: none.
std::string DroppedTable::choice(const std::string& key) const {
  const Source& source = sources_.at(key);
  return !source.chosen.empty() || source.found.empty() ? source.chosen
         : key == "pictures"                            ? usualPictures()
                                                        : source.found.front();
}

/// A dropped file, or a path on this computer. Empty for an empty choice.
std::filesystem::path DroppedTable::pathOf(const std::string& choice) const {
  const auto dropped = fileInside(files_->folder(), choice);
  return dropped && std::filesystem::exists(*dropped) ? *dropped : std::filesystem::path{choice};
}

/// The folder that has most of the pictures that the table names; as of the terminal, the table's where none has.
std::string DroppedTable::usualPictures() const {
  const std::string beside = std::filesystem::path{choice("table")}.parent_path().string();
  std::string best = beside.empty() ? "." : beside;
  if (!table_ || !map_.image ||
      std::find(table_->names().begin(), table_->names().end(), *map_.image) == table_->names().end()) {
    return best;
  }
  std::vector<std::string> cells;
  const std::size_t column = table_->column(*map_.image);
  for (std::size_t row = 0; row < table_->rows() && cells.size() < mostPictureCells; ++row) {
    if (const std::string& cell = table_->text(row, column); !cell.empty()) {
      cells.push_back(cell);
    }
  }
  std::ptrdiff_t most = 0;
  std::vector<std::string> folders = sources_.at("pictures").found;
  folders.insert(folders.begin(), best);
  for (const std::string& folder : folders) {
    const auto count = std::count_if(cells.begin(), cells.end(), [&](const std::string& cell) {
      const auto file = fileInside(files_->folder() / folder, cell);
      std::error_code ignored;
      return file && std::filesystem::is_regular_file(*file, ignored);
    });
    if (count > most) {
      most = count;
      best = folder;
    }
  }
  return best;
}

void DroppedTable::readTable(const std::string& name) {
  table_.reset();
  tableProblem_.clear();
  tableName_ = name;
  try {
    if (!name.empty()) {
      table_.emplace(readFile(pathOf(name)), name);
    }
  } catch (const InputError& error) {
    tableProblem_ = error.what();
  }
}

void DroppedTable::readRobot(const std::string& name) {
  robot_.reset();
  robotProblem_.clear();
  robotName_ = name;
  try {
    if (!name.empty()) {
      robot_ = parseUrdf(readUrdf(pathOf(name)), name);
    }
  } catch (const InputError& error) {
    robotProblem_ = error.what();
  }
}

/// Reads the chosen table and robot if they are others than before; the columns then begin anew.
void DroppedTable::read() {
  const std::string table = choice("table"), robot = choice("robot"), columns = choice("columns");
  const bool isTableNew = table != tableName_, isRobotNew = robot != robotName_;
  if (isTableNew) {
    readTable(table);
  }
  if (isRobotNew) {
    readRobot(robot);
  }
  if (isTableNew || isRobotNew || columns != columnsName_) {
    columnsName_ = columns;
    guess();
  }
}

/// Takes the columns from the chosen column map; without one, guesses them.
void DroppedTable::guess() {
  map_ = {};
  origin_ = Origin::none;
  columnsProblem_.clear();
  if (!table_ || !robot_) {
    return;
  }
  try {
    if (columnsName_.empty()) {
      map_ = guessColumns(*table_, *robot_).map;
      origin_ = Origin::guess;
    } else {
      map_ = parseColumnMap(parseJson(readFile(pathOf(columnsName_)), columnsName_), columnsName_, *robot_);
      origin_ = Origin::file;
    }
  } catch (const InputError& error) {
    columnsProblem_ = error.what();
  }
}

void DroppedTable::choose(const std::map<std::string, std::string>& choices) {
  for (const auto& [key, value] : choices) {
    if (sources_.contains(key)) {
      sources_[key].chosen = value;
    } else if (others_.contains(key)) {
      others_[key] = value;
    } else {
      throw InputError{
          fmt::format("import: expected a choice of a file, a link or a folder, found \"{}\"", printableText(key, 80))};
    }
  }
  read();
}

void DroppedTable::assign(const std::string& column, const std::string& meaning, const std::string& unit) {
  if (table_ && robot_) {
    table_->column(column); // throws if there is none
    assignColumn(map_, *robot_, column, meaning, unit);
    origin_ = Origin::person;
    columnsProblem_.clear();
  }
}

void DroppedTable::setColumns(const std::string& text) {
  if (robot_) {
    map_ = parseColumnMap(parseJson(text, "columns"), "columns", *robot_);
    origin_ = Origin::person;
    columnsProblem_.clear();
  }
}

/// What is there, and what is missing.
std::string DroppedTable::sentence() const {
  if (!table_ && robot_) {
    std::vector<std::string> joints;
    for (std::size_t i = 0; i < robot_->joints.size(); ++i) {
      if (robot_->joints[i].motor == i) {
        joints.push_back(robot_->joints[i].name);
      }
    }
    return fmt::format(
        "{} describes a robot with {} ({}). Drop a table of its joint angles, too (.csv), with the pictures "
        "that it names; or drop a capture set of this robot.",
        robotName_, counted(joints.size(), "joint"), listed(joints));
  }
  if (!table_ || !robot_) {
    return table_ ? fmt::format(
                        "{} has {} of {}. Drop the robot's URDF, too, or say where it is: its joints tell what the "
                        "columns are.",
                        tableName_, counted(table_->rows(), "row"), counted(table_->names().size(), "column"))
                  : "Drop a table of joint angles (.csv) and the robot's URDF.";
  }
  return fmt::format("{} has {}. {}{}", tableName_, counted(table_->rows(), "row"), originSentence(),
                     map_.image ? picturesSentence() : "");
}

std::string DroppedTable::originSentence() const {
  switch (origin_) {
  case Origin::guess:
    return "The columns are guessed from their names and values; correct what is wrong.";
  case Origin::file:
    return fmt::format("The columns are those of {}.", columnsName_);
  case Origin::person:
    return "The columns are as you chose them.";
  case Origin::none:
    break;
  }
  return "Say which columns are the angles of which joints.";
}

/// What the pictures need and is not there yet; empty: nothing.
std::string DroppedTable::picturesSentence() const {
  std::vector<std::string> missing;
  for (const auto& [what, isMissing] : {std::pair{"the lens calibration", choice("cameraModel").empty()},
                                        std::pair{"the link of the camera", others_.at("cameraLink").empty()},
                                        std::pair{"the printed boards", choice("boards").empty()}}) {
    if (isMissing) {
      missing.push_back(what);
    }
  }
  return missing.empty() ? "" : fmt::format(" Pictures also need {}.", fmt::join(missing, ", "));
}

Json DroppedTable::columnsState() const {
  Json columns = Json::array(), meanings = Json::array();
  for (std::size_t column = 0; column < table_->names().size(); ++column) {
    columns.push_back({{"name", table_->names()[column]}, {"examples", examplesOf(*table_, column)}});
  }
  if (robot_) {
    for (const ColumnMeaning& meaning : columnMeanings(map_, *robot_)) {
      meanings.push_back({{"id", meaning.id},
                          {"words", meaning.words},
                          {"column", meaning.column},
                          {"units", meaning.units},
                          {"unit", meaning.unit}});
    }
  }
  return {{"list", columns},
          {"meanings", meanings},
          {"map", columnMapJson(map_).dump(2, ' ', false, Json::error_handler_t::replace)}};
}

Json DroppedTable::state() const {
  Json files = Json::object();
  for (const auto& [key, source] : sources_) {
    files[key] = {{"chosen", choice(key)}, {"found", source.found}};
  }
  std::string problem;
  for (const std::string& each : {tableProblem_, robotProblem_, columnsProblem_}) {
    problem = problem.empty() ? each : problem;
  }
  return {{"files", files},
          {"cameraLink", others_.at("cameraLink")},
          {"boardLink", others_.at("boardLink")},
          {"output", others_.at("output")},
          {"links", robot_ ? linkNames(*robot_) : std::vector<std::string>{}},
          {"columns", table_ ? columnsState() : Json()},
          {"hasPictures", map_.image.has_value()},
          {"isReady", table_.has_value() && robot_.has_value()},
          {"sentence", sentence()},
          {"problem", withoutFolder(problem, folder())},
          {"ignored", ignored_}};
}

DroppedTable::Written DroppedTable::write() const {
  if (!table_ || !robot_) {
    throw InputError{"import: expected a table and the robot's URDF, found only one of them; drop the other, too"};
  }
  SceneSources sources;
  sources.robot = pathOf(robotName_).string();
  std::filesystem::path pictures;
  if (map_.image) { // else boards and cameras have measured nothing
    sources.cameraModel = pathOf(choice("cameraModel")).string();
    sources.cameraLink = others_.at("cameraLink");
    sources.boards = pathOf(choice("boards")).string();
    sources.boardLink = others_.at("boardLink");
    const std::string folder = choice("pictures");
    pictures = folder.empty() ? std::filesystem::absolute(pathOf(tableName_)).parent_path() : pathOf(folder);
  }
  const TableImport result = importTable(*table_, map_, readImportScene(sources), pictures);
  Written written;
  written.files = {"captures.json"};
  for (const auto& [path, content] : result.imported.files) {
    written.files.push_back(path);
  }
  for (const auto& [path, source] : result.imported.copies) {
    written.files.push_back(path);
  }
  written.sentences = summarize(result);
  if (const std::string& output = others_.at("output"); !output.empty()) {
    written.set = output;
  } else {
    const auto temporary = std::make_shared<TemporaryDirectory>();
    written.temporary = temporary;
    written.set = temporary->path() / std::filesystem::path{tableName_}.stem();
  }
  std::error_code ignored;
  written.isFolderNew = !std::filesystem::exists(written.set, ignored);
  const bool isFree = written.isFolderNew || std::filesystem::is_empty(written.set, ignored);
  try {
    writeImport(result.imported, written.set);
  } catch (...) {
    if (isFree) { // else it holds another's files
      written.remove();
    }
    throw;
  }
  return written;
}

void DroppedTable::Written::remove() const {
  std::error_code ignored;
  for (const std::string& file : files) {
    std::filesystem::remove(set / file, ignored);
  }
  std::filesystem::remove(set / "images", ignored); // if they are empty
  if (isFolderNew) {
    std::filesystem::remove(set, ignored);
  }
}

std::string withoutFolder(std::string sentence, const std::filesystem::path& folder) {
  for (const auto& [text, words] : {std::pair{folder.string() + "/", std::string{}},
                                    std::pair{folder.string(), std::string{"the dropped files"}}}) {
    for (std::size_t at = 0; (at = sentence.find(text, at)) != std::string::npos; at += words.size()) {
      sentence.replace(at, text.size(), words);
    }
  }
  return sentence;
}

} // namespace naocal
