#include "report/ReportPage.hpp"

#include "calibration/KnownEffects.hpp"
#include "calibration/result/ResultFile.hpp"
#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/JsonReader.hpp"
#include "report/DiagnosisData.hpp"
#include "report/EvaluationData.hpp"
#include "report/PageFiles.hpp"
#include "report/ResultData.hpp"

#include <cassert>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

namespace naocal {

using nlohmann::json;

namespace {

/// JSON text that cannot close its script element.
std::string harmless(const json& data) {
  std::string text;
  for (const char letter : data.dump(-1, ' ', false, json::error_handler_t::replace)) {
    if (letter == '<') { // in JSON only inside strings
      text += "\\u003c";
    } else {
      text += letter;
    }
  }
  return text;
}

/// The frame with its {{placeholders}} replaced; replacements are not scanned again.
std::string filled(std::string_view frame, const std::map<std::string_view, std::string_view>& parts) {
  std::string page;
  for (std::size_t open = frame.find("{{"); open != frame.npos; open = frame.find("{{")) {
    const std::size_t close = frame.find("}}", open);
    assert(close != frame.npos);
    page.append(frame.substr(0, open)).append(parts.at(frame.substr(open + 2, close - open - 2)));
    frame.remove_prefix(close + 2);
  }
  return page.append(frame);
}

/// Data of a result's page; tells where the captures are.
json resultPage(const JsonCursor& result, const std::filesystem::path& file, const CaptureSources& sources) {
  const SourceCaptures captures{result, {file, sources.lookIn}};
  for (const std::string& sentence : captures.moved()) {
    sources.tell(sentence);
  }
  for (const std::string& sentence : captures.unavailable()) {
    sources.tell("the page has neither pictures nor joint angles: " + sentence);
  }
  return resultData(result, captures);
}

} // namespace

std::string renderReport(const std::filesystem::path& file, const CaptureSources& sources) {
  return renderReport(parseJson(readFile(file), file.string()), file, sources);
}

std::string renderReport(const json& document, const std::filesystem::path& file, const CaptureSources& sources) {
  const JsonCursor top{document, file.string()};
  const JsonCursor format = top.at("format");
  const bool isDiagnosis = format.value() == "naocal-diagnosis", isEvaluation = format.value() == "naocal-evaluation";
  if (!isDiagnosis && !isEvaluation && format.value() != "naocal-result") {
    format.refuse(
        "\"naocal-result\", \"naocal-diagnosis\" or \"naocal-evaluation\", as 'naocal solve', 'naocal diagnose' "
        "and 'naocal evaluate thesis' write them");
  }
  requireVersion(top);
  requireEstimates(document, file.string());
  const std::string data = harmless(isDiagnosis    ? diagnosisData(top)
                                    : isEvaluation ? evaluationData(top)
                                                   : resultPage(top, file, sources));
  if (!isDiagnosis && !isEvaluation) {
    requireKnownEffects(document, file.string());
  }
  const pageFiles::Page& page = isDiagnosis    ? pageFiles::diagnosis
                                : isEvaluation ? pageFiles::evaluation
                                               : pageFiles::result;
  const std::string modules = fmt::format("{{\"imports\":{{{}}}}}", fmt::join(pageFiles::modules, ","));
  return filled(
      pageFiles::frame,
      {{"style", page.style}, {"sections", page.sections}, {"data", data}, {"modules", modules}, {"page", page.name}});
}

} // namespace naocal
