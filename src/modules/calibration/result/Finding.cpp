#include "calibration/result/Finding.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

namespace naocal {

using nlohmann::json;

namespace {

bool contains(const std::vector<std::string>& all, std::string_view name) {
  return std::find(all.begin(), all.end(), name) != all.end();
}

/// Names within a label: what follows the "@", and the first word of "LKneePitch over q".
std::vector<std::string> namesIn(const std::string& label) {
  const std::size_t at = label.find('@');
  std::string names = at == label.npos ? label.substr(0, label.find(' ')) : label.substr(at + 1);
  std::replace_if(
      names.begin(), names.end(), [](char letter) { return letter == ',' || letter == '|'; }, ' ');
  std::vector<std::string> result;
  for (std::size_t begin = 0; begin <= names.size();) {
    const std::size_t end = std::min(names.find(' ', begin), names.size());
    result.push_back(names.substr(begin, end - begin));
    begin = end + 1;
  }
  return result;
}

/// Whether a clause begins with a name, which keeps its spelling: "elbow's zero ..", "backlash@elbow ..".
bool beginsWithName(const std::string& clause, const FindingPlace& where) {
  const std::string first = clause.substr(0, clause.find_first_of(" ',:"));
  return first.find('@') != first.npos || contains(where.joints, first) || contains(where.boards, first) ||
         contains(where.cameras, first);
}

json answersJson(const std::vector<FindingAnswer>& answers) {
  json list = json::array();
  for (const FindingAnswer& answer : answers) {
    list.push_back({{"do", answer.action}});
    if (!answer.of.empty()) {
      list.back()[answer.of] = answer.what;
    }
  }
  return list;
}

json toJson(const Finding& finding) {
  json look;
  if (finding.look) {
    look = {{"error", finding.look->error}, {"over", finding.look->over}};
  }
  return {{"id", finding.id},
          {"level", toString(finding.level)},
          {"sentence", finding.sentence},
          {"why", finding.why},
          {"numbers", finding.numbers},
          {"where",
           {{"poses", finding.where.poses},
            {"joints", finding.where.joints},
            {"boards", finding.where.boards},
            {"cameras", finding.where.cameras},
            {"captures", finding.where.captures}}},
          {"look", std::move(look)},
          {"answer", answersJson(finding.answers)}};
}

} // namespace

FindingPlace placeOf(const std::string& label, const Measurements& measurements) {
  FindingPlace where;
  const auto add = [](const std::string& name, std::vector<std::string>& names) {
    if (!contains(names, name)) {
      names.push_back(name);
    }
  };
  for (const std::string& name : namesIn(label)) {
    for (const Joint& joint : measurements.robot.joints) {
      if (joint.name == name) {
        add(name, where.joints);
      }
    }
    for (const Target& target : measurements.targets) {
      if (target.name == name) {
        add(name, where.boards);
      }
    }
    for (const CaptureSet& set : *measurements.sets) {
      if (set.cameras.contains(name)) {
        add(name, where.cameras);
      }
    }
  }
  return where;
}

Finding makeFinding(const std::string& kind, const std::string& label, FindingLevel level, std::string why,
                    const Measurements& measurements) {
  Finding finding{kind + ":" + label, level, std::move(why), "", placeOf(label, measurements)};
  finding.sentence = formatSentence(finding.why, finding.where);
  return finding;
}

std::string formatSentence(std::string why, const FindingPlace& where) {
  if (!why.empty() && !beginsWithName(why, where)) {
    why.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(why.front())));
  }
  return why.ends_with('.') ? why : why + ".";
}

void append(std::vector<Finding> further, std::vector<Finding>& findings) {
  std::move(further.begin(), further.end(), std::back_inserter(findings));
}

void sortFindings(std::vector<Finding>& findings) {
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& one, const Finding& other) { return one.level < other.level; });
}

std::vector<std::string> reasonsAgainstUse(const std::vector<Finding>& findings) {
  std::vector<std::string> reasons;
  for (const Finding& finding : findings) {
    if (finding.level == FindingLevel::stop) {
      reasons.push_back(finding.why);
    }
  }
  return reasons;
}

std::vector<Finding> furtherThanVerdict(const std::vector<Finding>& findings) {
  static constexpr std::array<std::string_view, 5> ofVerdict = {"good", "effect-missing", "unknown-effect", "event",
                                                                "negligible"};
  std::vector<Finding> further;
  for (const Finding& finding : findings) {
    if (std::find(ofVerdict.begin(), ofVerdict.end(), finding.kind()) == ofVerdict.end()) {
      further.push_back(finding);
      further.back().sentence = formatSentence(finding.why, finding.where);
    }
  }
  return further;
}

std::vector<const Finding*> furtherFindings(const std::vector<Finding>& findings) {
  std::vector<const Finding*> further;
  for (std::size_t i = 1; i < findings.size(); ++i) {
    if (findings.front().sentence.find(findings[i].why) == std::string::npos) {
      further.push_back(&findings[i]);
    }
  }
  return further;
}

std::vector<std::string> sentencesOf(const std::vector<const Finding*>& findings) {
  std::vector<std::string> sentences;
  std::transform(findings.begin(), findings.end(), std::back_inserter(sentences),
                 [](const Finding* finding) { return finding->sentence; });
  return sentences;
}

std::string toString(FindingLevel level) {
  switch (level) {
  case FindingLevel::stop:
    return "stop";
  case FindingLevel::act:
    return "act";
  case FindingLevel::note:
    return "note";
  }
  return {};
}

json toJson(const std::vector<Finding>& findings) {
  json list = json::array();
  std::transform(findings.begin(), findings.end(), std::back_inserter(list),
                 [](const Finding& finding) { return toJson(finding); });
  return list;
}

} // namespace naocal
