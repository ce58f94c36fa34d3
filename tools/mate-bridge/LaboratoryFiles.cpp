#include "Laboratory.hpp"

#include "PassingFolder.hpp"

#include "calibration/Prediction.hpp"
#include "diagnosis/DiagnosisFile.hpp"
#include "estimation/ModelFile.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "poses/PoseFile.hpp"
#include "report/ReportPage.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

/// What the laboratory shares with the terminal's commands: their files, proposed poses, other captures.
namespace naocal {

namespace {

using Json = nlohmann::json;

std::filesystem::path written(const PassingFolder& folder, const Json& content) {
  std::filesystem::path file = folder.path() / "content.json"; // readers of files read files
  writeAtomically(file, content.dump());
  return file;
}

} // namespace

void Laboratory::propose(std::size_t count) {
  NextOptions wanted;
  wanted.count = count;
  next_ = nextPoses(opened_.sets, measurements_, diagnosis(), options(rungs_[at_]), wanted);
  Json told = nextJson(*next_, opened_.robot);
  told["whyNone"] = next_->whyNone;
  tell_("next", told);
}

void Laboratory::compareWith(const OpenedSets& others) {
  const PassingFolder passing;
  const StoredResult stored = readResult(written(passing, result_));
  Json told = comparisonJson(compare(stored, others.sets, opened_.robot, false));
  told["names"] = others.inputs.sets;
  tell_("compared", told);
}

std::string Laboratory::file(const std::string& name) {
  const PassingFolder passing;
  if (name == "result.json") {
    return result_.dump(2) + "\n";
  }
  if (name == "session.json") {
    return sessionJson(session()).dump(2) + "\n";
  }
  if (name == "report.html") {
    return reportPage(written(passing, result_));
  }
  if (name == "model.json") {
    const Rung& rung = rungs_[at_];
    return modelJson(rung.with, rung.without, Json::parse(rung.definitions)).dump(2) + "\n";
  }
  if (name == "poses.json") {
    if (!next_ || next_->poses.empty()) {
      throw InputError{"no poses were proposed for this model yet; ask for them first"};
    }
    return posesJson(*next_, opened_.robot).dump(2) + "\n";
  }
  if (name != "diagnosis.json" && name != "diagnosis.html") {
    throw InputError{fmt::format("there is no file {} to be made", name)};
  }
  Json document = diagnosisJson(diagnosis());
  if (next_) {
    document["next"] = nextJson(*next_, opened_.robot);
  }
  document["inputs"] = {{"sets", opened_.inputs.sets}, {"sha256", opened_.inputs.sha256}};
  return name == "diagnosis.json" ? document.dump(2) + "\n" : reportPage(written(passing, document));
}

} // namespace naocal
