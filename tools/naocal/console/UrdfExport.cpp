#include "console/UrdfExport.hpp"

#include "console/print/PrintText.hpp"

#include "calibration/result/Plausibility.hpp"
#include "data/CaptureSetFile.hpp"
#include "dialects/UrdfCorrection.hpp"
#include "inference/Thresholds.hpp"
#include "io/Files.hpp"
#include "io/Folders.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "robot/Urdf.hpp"

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

/// What the result says of joints, and the effects that it leaves out.
struct FoundCorrections {
  std::map<std::string, UrdfJointCorrection> joints;
  std::vector<std::string> unlearned, otherTerms;
};

double valueOf(const JsonCursor& unknowns, const std::string& name) {
  return unknowns.at(name).at("value").number(anyNumber);
}

FoundCorrections findCorrections(const JsonCursor& result) {
  FoundCorrections found;
  for (const JsonCursor& effect : result.at("effects").elements()) {
    const std::string name = effect.at("effect").text(), at = effect.at("at").value().get<std::string>();
    const JsonCursor unknowns = effect.at("unknowns");
    if (name == "jointOffset") {
      const JsonCursor offset = unknowns.at("o");
      if (offset.at("learned").number({0, 1, ""}) < threshold::learned) {
        found.unlearned.push_back(at);
        continue;
      }
      found.joints[at].offset = offset.at("value").number(anyNumber);
      found.joints[at].offsetSigma = offset.at("sigma").number(anyNumber);
    } else if (name == "linkGeometry") {
      found.joints[at].translation = {valueOf(unknowns, "x"), valueOf(unknowns, "y"), valueOf(unknowns, "z")};
      found.joints[at].rotation = {valueOf(unknowns, "rx"), valueOf(unknowns, "ry"), valueOf(unknowns, "rz")};
    } else {
      found.otherTerms.push_back(at.empty() ? name : name + "@" + at);
    }
  }
  return found;
}

CaptureSet readSetOf(const std::string& resultFile, const StoredResult& result, const PostureOptions& options) {
  const std::vector<std::string> folders = findCaptureFolders(result, resultFile, options);
  if (folders.empty()) {
    throw InputError{fmt::format("{}: expected its captures, which hold the URDF, found none where they were; name "
                                 "their folder with --set, or one to search with --look-in",
                                 resultFile)};
  }
  CaptureSet set = readCaptureSet(folders.front(), BadCapturePolicy::skip).set;
  if (set.urdf.empty()) {
    throw InputError{fmt::format("{}: expected a robot with a URDF, found a {}, which naocal describes itself",
                                 resultFile, set.model)};
  }
  return set;
}

} // namespace

void exportUrdf(const std::string& resultFile, const PostureOptions& options, const std::filesystem::path& folder) {
  const nlohmann::json document = parseJson(readFile(resultFile), resultFile);
  const StoredResult result = parseResult(document, resultFile);
  requireNoReasons(resultFile, listReasonsAgainstUse(result), options.force);
  const CaptureSet set = readSetOf(resultFile, result, options);
  const std::filesystem::path drawing = set.folder / set.urdf;
  const std::string text = readUrdf(drawing);
  const Robot robot = parseUrdf(text, drawing.string());
  const FoundCorrections found = findCorrections({document, resultFile});
  const std::string corrected = correctUrdf(text, drawing.string(), robot, found.joints);
  createFolders(folder);
  const auto write = [&](const std::string& name, const std::string& content) {
    writeAtomically(folder / name, content);
    printText("written: {}\n", (folder / name).string());
  };
  write(std::filesystem::path{set.urdf}.filename().string(), corrected);
  write("joint_offsets.yaml", urdfOffsetsYaml(robot, found.joints));
  if (!found.unlearned.empty()) {
    printText("left as drawn, for want of captures that tell them: {}\n",
              fmt::format("{}", fmt::join(found.unlearned, ", ")));
  }
  if (!found.otherTerms.empty()) {
    printText("a URDF has no place for: {}\n", fmt::format("{}", fmt::join(found.otherTerms, ", ")));
  }
}

} // namespace naocal
