#include "analysis/AnalysisSession.hpp"
#include "data/CaptureSetFile.hpp"
#include "fuzz/driver/Reader.hpp"
#include "io/Files.hpp"
#include "protocol/BoundedJson.hpp"

#include <nlohmann/json.hpp>
#include <sstream>

namespace naocal {
namespace {

using Json = nlohmann::json;

constexpr int mostChanges = 2; // of an input; each is a fit

AnalysisSession openCaptures() {
  static const Robot robot = loadRobot(configurationDirectory(), "V6");
  const auto seed = std::filesystem::path{NAOCAL_SOURCE_DIR} / "tests/fuzz/corpus/capture-set/seed-simulated";
  static const CaptureSet set = parseCaptureSet(readFile(seed), "captures.json").set;
  return {Dataset{.sets = {set}, .robot = robot}, [](const std::string&, const Json&) {}};
}

/// Does what a page's message asks for. Returns whether it may have changed the model.
bool handleMessage(AnalysisSession& session, const Json& message) {
  const auto verb = message.value("do", Json());
  const auto text = [&](const char* key) { return message.value(key, Json()); };
  if (verb == "check") {
    session.checkEffect(text("effect"));
    return false;
  }
  if (verb == "define") {
    session.defineEffect(text("effect"));
  } else if (verb == "add" && text("label").is_string()) {
    session.add(text("label"));
  } else if (verb == "drop" && text("label").is_string()) {
    session.drop(text("label"));
  } else if (verb == "goTo" && text("rung").is_number_unsigned()) {
    session.goTo(text("rung"));
  } else if (verb == "make" && text("file").is_string()) {
    session.generateFile(text("file"));
  } else {
    return false;
  }
  return true;
}

/// Every line is a message of a page about two captures. The first one that is refused ends the input.
void analyse(std::string_view bytes) {
  AnalysisSession session = openCaptures();
  int changes = 0;
  std::istringstream lines{std::string{bytes}};
  for (std::string line; std::getline(lines, line) && changes < mostChanges;) {
    Json message;
    try {
      message = parseBoundedJson(line);
    } catch (const Json::exception&) { // the bridge refuses it
    }
    changes += message.is_object() && handleMessage(session, message);
  }
}

const Reader analysisReader{"analysis", analyse, 20}; // fits, under sanitizers

} // namespace
} // namespace naocal
