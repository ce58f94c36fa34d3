#include "analysis/AnalysisSession.hpp"
#include "data/CaptureSetFile.hpp"
#include "fuzz/driver/Reader.hpp"
#include "fuzz/readers/PageMessages.hpp"
#include "io/Files.hpp"

#include <nlohmann/json.hpp>

namespace naocal {
namespace {

using Json = nlohmann::json;

constexpr int mostChanges = 2; // of an input; each is a fit

AnalysisSession openCaptures() {
  static const Robot robot = loadRobot(configurationDirectory(), "V6");
  static const CaptureSet set =
      parseCaptureSet(readFile(NAOCAL_SOURCE_DIR "/tests/fuzz/corpus/capture-set/seed-simulated"), "captures.json").set;
  return {Dataset{.sets = {set}, .robot = robot}, [](const std::string&, const Json&) {}};
}

/// Does what a page's message asks for. Returns whether it may have changed the model.
bool handleMessage(AnalysisSession& session, const Json& message) {
  const auto verb = message.value("do", Json());
  const auto given = [&](const char* key) { return message.value(key, Json()); };
  if (verb == "check") {
    session.checkEffect(given("effect"));
    return false;
  }
  if (verb == "define") {
    session.defineEffect(given("effect"));
  } else if (verb == "add" && given("labels").is_array()) {
    session.add(given("labels"));
  } else if (verb == "drop" && given("label").is_string()) {
    session.drop(given("label"));
  } else if (verb == "goTo" && given("rung").is_number_unsigned()) {
    session.goTo(given("rung"));
  } else if (verb == "make" && given("file").is_string()) {
    session.generateFile(given("file"));
  } else {
    return false;
  }
  return true;
}

/// Every line is a message of a page about two captures. The first one that is refused ends the input.
void analyse(std::string_view bytes) {
  AnalysisSession session = openCaptures();
  int changes = 0;
  for (const auto& [line, content] : pageMessages(bytes)) {
    if (changes < mostChanges && content.is_object()) {
      changes += handleMessage(session, content);
    }
  }
}

const Reader analysisReader{"analysis", analyse, 20}; // fits, under sanitizers

} // namespace
} // namespace naocal
