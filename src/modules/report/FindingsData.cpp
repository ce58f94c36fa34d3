#include "report/FindingsData.hpp"

#include "report/PageValues.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace naocal {

using nlohmann::json;

namespace {

const std::vector<std::string_view>& levels() {
  static const std::vector<std::string_view> all{"stop", "act", "note"};
  return all;
}

/// The reason of a suspicion, with its capture.
std::string describeSuspicion(const JsonCursor& entry) {
  const std::string why = entry.at("why").text();
  const auto capture = entry.find("capture");
  const std::string name = capture ? fmt::format("capture {}", capture->integer(0, maxInteger)) : "";
  return why.find(name) != why.npos ? why : fmt::format("{} ({})", why, name);
}

/// Of a file of an earlier version.
json olderFindings(const JsonCursor& document) {
  std::vector<std::string> sentences;
  for (const char* const key : {"warnings", "notes"}) {
    for (const JsonCursor& sentence : elementsOf(document, key)) {
      sentences.push_back(sentence.text());
    }
  }
  for (const JsonCursor& entry : elementsOf(document, "suspicious")) {
    sentences.push_back(describeSuspicion(entry));
  }
  json findings = json::array();
  for (std::string& sentence : sentences) {
    findings.push_back({{"level", "note"}, {"sentence", std::move(sentence)}});
  }
  return findings;
}

} // namespace

json leaveOutData(const JsonCursor& document) {
  json labels = json::array();
  for (const JsonCursor& finding : elementsOf(document, "findings")) {
    for (const JsonCursor& answer : finding.at("answer").elements()) {
      if (const auto found = answer.find("label")) {
        labels.push_back(found->text());
      }
    }
  }
  return labels;
}

json findingsData(const JsonCursor& document) {
  const std::vector<JsonCursor> all = elementsOf(document, "findings");
  if (all.empty()) {
    return olderFindings(document);
  }
  const std::string told = document.at("sentence").text();
  json findings = json::array();
  for (const JsonCursor& finding : all) {
    const JsonCursor level = finding.at("level");
    if (told.find(finding.at("why").text()) == told.npos && finding.at("sentence").text() != told) {
      findings.push_back(
          {{"level", std::string{levels()[level.wordIndex(levels())]}}, {"sentence", finding.at("sentence").text()}});
    }
  }
  return findings;
}

} // namespace naocal
