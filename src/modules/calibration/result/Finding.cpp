#include "calibration/result/Finding.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

namespace naocal {

using nlohmann::json;

namespace {

bool contains(const std::vector<std::string>& all, std::string_view name) {
  return std::find(all.begin(), all.end(), name) != all.end();
}

/// Names within a label: what follows the "@", without an unknown's name, or else all words.
std::vector<std::string> namesIn(const std::string& label) {
  const std::size_t at = label.find('@');
  std::string names = at == label.npos ? label : label.substr(at + 1, label.rfind('.') - at - 1);
  std::replace_if(
      names.begin(), names.end(), [](char letter) { return letter == ',' || letter == '|'; }, ' ');
  std::istringstream words{names};
  return {std::istream_iterator<std::string>{words}, {}};
}

template <class Entry> bool areNamed(const std::vector<Entry>& entries, const std::string& name) {
  return std::any_of(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.name == name; });
}

/// Whether a word names something of the captures, which keeps its spelling: "elbow's zero ..", "backlash@elbow ..".
bool isName(const std::string& word, const Measurements& measurements) {
  const FindingPlace place = placeOf("@" + word, measurements);
  const InstrumentList& all = measurements.instruments;
  return word.find('@') != word.npos || !place.joints.empty() || !place.boards.empty() || !place.cameras.empty() ||
         areNamed(measurements.robot.links, word) || areNamed(all.trackers, word) || areNamed(all.markers, word) ||
         areNamed(all.frames, word) || areNamed(all.places, word);
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
  finding.sentence = formatSentence(finding.why, measurements);
  return finding;
}

std::string nameCapture(const Measurements& measurements, std::size_t set, int capture) {
  const std::vector<CaptureSet>& sets = *measurements.sets;
  return (sets.size() > 1 ? sets[set].name + "/" : "") + std::to_string(capture);
}

std::string formatSentence(std::string why, const Measurements& measurements) {
  if (!why.empty() && !isName(why.substr(0, why.find_first_of(" ',:")), measurements)) {
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

void appendNew(std::vector<Finding> further, std::vector<Finding>& findings) {
  for (Finding& finding : further) {
    if (std::none_of(findings.begin(), findings.end(), [&](const Finding& one) { return one.id == finding.id; })) {
      findings.push_back(std::move(finding));
    }
  }
}

std::vector<Finding> furtherThanVerdict(const std::vector<Finding>& findings, const Measurements& measurements) {
  std::vector<Finding> further;
  for (const Finding& finding : findings) {
    if (!finding.isVerdict) {
      further.push_back(finding);
      further.back().sentence = formatSentence(finding.why, measurements);
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
