#include "Sets.hpp"

#include "Outputs.hpp"

#include "data/CaptureSetFile.hpp"
#include "io/Files.hpp"

#include <filesystem>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace naocal {

GivenSets readSets(const std::vector<std::string>& folders, bool skipBad) {
  GivenSets given;
  for (const std::string& folder : folders) {
    ReadCaptureSet read = readCaptureSet(folder, skipBad ? BadCaptures::skip : BadCaptures::refuse);
    for (const std::string& sentence : read.skipped) {
      fmt::print(stderr, "left out: {}\n", sentence);
    }
    given.inputs.sets.push_back(std::filesystem::weakly_canonical(folder).string()); // found from anywhere
    given.inputs.sha256.push_back(sha256(fileContent(std::filesystem::path{folder} / "captures.json")));
    given.sets.push_back(std::move(read.set));
  }
  given.robot = loadRobot(configurationDirectory(), given.sets.front().model);
  return given;
}

void writeJson(const nlohmann::json& json, const std::string& file) {
  if (file == "-") {
    fmt::print("{}\n", json.dump(1));
  } else {
    refuseAnotherKind(file, json.at("format").get_ref<const std::string&>());
    writeAtomically(file, json.dump(1) + "\n");
  }
}

} // namespace naocal
