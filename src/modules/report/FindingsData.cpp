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
  json findings = json::array();
  const std::string told = document.at("sentence").text();
  const auto add = [&](const char* level, const std::string& sentence) {
    if (told.find(sentence) == told.npos) {
      findings.push_back({{"level", level}, {"sentence", sentence}});
    }
  };
  const auto reasons = document.find("reasons");
  const std::vector<std::string> against = reasons ? reasons->texts() : std::vector<std::string>{};
  for (const JsonCursor& entry : elementsOf(document, "suspicious")) {
    add("stop", describeSuspicion(entry));
  }
  for (const JsonCursor& warning : elementsOf(document, "warnings")) {
    const bool isReason = std::find(against.begin(), against.end(), warning.text()) != against.end();
    add(isReason ? "stop" : "note", warning.text());
  }
  for (const JsonCursor& note : elementsOf(document, "notes")) {
    add("note", note.text());
  }
  for (const JsonCursor& direction : elementsOf(document, "weak")) {
    const std::string sentence = direction.at("sentence").text();
    const bool isTold = std::any_of(findings.begin(), findings.end(), [&](const json& one) {
      return one["sentence"].get<std::string>().find(sentence.substr(1)) != std::string::npos; // but for a capital
    });
    if (!isTold) {
      add("note", sentence);
    }
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
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string why = all[i].at("why").text(), sentence = all[i].at("sentence").text(),
                      level{levels()[all[i].at("level").wordIndex(levels())]};
    if (i > 0 && told.find(why) == told.npos) {
      findings.push_back({{"level", level}, {"sentence", sentence}});
    }
  }
  return findings;
}

} // namespace naocal
