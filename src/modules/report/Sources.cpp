#include "report/Sources.hpp"

#include "calibrate/Comparison.hpp"
#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "robot/Robot.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace fs = std::filesystem;

namespace {

/// The folder as it was given to 'naocal solve', or seen from the result file.
std::optional<fs::path> found(const fs::path& folder, const fs::path& resultFile) {
  for (const fs::path& candidate : {folder, resultFile.parent_path() / folder}) {
    std::error_code ignored;
    if (fs::exists(candidate / "captures.json", ignored)) {
      return candidate;
    }
  }
  return std::nullopt;
}

} // namespace

Sources::Sources(const JsonPlace& result, const fs::path& resultFile) {
  const JsonPlace inputs = result.at("inputs");
  const std::vector<JsonPlace> folders = inputs.at("sets").elements(), sums = inputs.at("sha256").elements();
  if (folders.size() != sums.size()) {
    inputs.at("sha256").refuse("as many sums as there are sets");
  }
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const std::string given = folders[i].text();
    const std::optional<fs::path> folder = found(given, resultFile);
    if (!folder) {
      missing_.push_back(fmt::format("the captures {} are no longer there", given));
      continue;
    }
    try {
      const fs::path file = *folder / "captures.json";
      if (sha256(fileContent(file)) != sums[i].text()) {
        missing_.push_back(fmt::format("{} has changed since the result was made", file.string()));
        continue;
      }
      const CaptureSet set = readCaptureSet(*folder, BadCaptures::skip).set;
      unchanged_[set.name] = {*folder, set};
    } catch (const InputError& error) {
      missing_.push_back(error.what());
    }
  }
}

std::map<std::string, double> Sources::angles(const SeenPicture& picture) const {
  std::map<std::string, double> result;
  const auto source = unchanged_.find(picture.set);
  if (source == unchanged_.end()) {
    return result;
  }
  const CaptureSet& set = source->second.set;
  const auto capture = std::find_if(set.captures.begin(), set.captures.end(),
                                    [&](const Capture& candidate) { return candidate.id == picture.capture; });
  for (std::size_t i = 0; capture != set.captures.end() && i < set.jointNames.size(); ++i) {
    if (std::isfinite(capture->joints.measured[i])) {
      result[set.jointNames[i]] = capture->joints.measured[i];
    }
  }
  return result;
}

std::optional<fs::path> Sources::image(const SeenPicture& picture) const {
  const auto source = unchanged_.find(picture.set);
  const fs::path inside = picture.image;
  if (source == unchanged_.end() || inside.empty() || inside.is_absolute() ||
      std::find(inside.begin(), inside.end(), "..") != inside.end()) {
    return std::nullopt;
  }
  const fs::path file = source->second.folder / inside;
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) ? std::optional{file} : std::nullopt;
}

std::optional<double> Sources::drawingRms() const {
  std::vector<CaptureSet> sets;
  for (const auto& [name, source] : unchanged_) {
    sets.push_back(source.set);
  }
  if (sets.empty() || !missing_.empty()) {
    return std::nullopt;
  }
  try {
    const Robot robot = loadRobot(configurationDirectory(), sets.front().model);
    return compare(StoredResult{}, sets, robot, false).nominal.rmsPx;
  } catch (const InputError&) { // no drawing of this robot here, or one that cannot see these corners
    return std::nullopt;
  }
}

} // namespace naocal
