#pragma once

#include "measurements/Measurements.hpp"

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// What follows from a finding.
enum class FindingLevel {
  stop, // the result must not be used
  act,  // it may be used, but something is to be done
  note  // good to know
};

/// What a finding concerns, by name.
struct FindingPlace {
  std::vector<std::string> poses, joints, boards, cameras;
  std::vector<int> captures; // ids
};

/// What a person can do about a finding: {"add", "effect", "elasticity@LKneePitch"}, {"mend", "setUp", "swapped.."},
/// {"leave out", "effect", ..}, {"take poses", "", ""}.
struct FindingAnswer {
  std::string action, of, what;
};

/// The plot that shows a finding: an error over a driver, as `PartialResidual` names them.
struct FindingLook {
  std::string error, over;
};

/// One thing that a person should know of a result or a diagnosis. Its id is its kind, and after a colon what it
/// concerns: effect-missing, unknown-effect, set-up, event, accident, not-learned, noise, negligible, weak; or "good".
struct Finding {
  std::string id;
  FindingLevel level = FindingLevel::note;
  std::string why;      // a clause: "12 corners do not fit the rest"
  std::string sentence; // whole
  FindingPlace where = {};
  std::map<std::string, double> numbers = {}; // SI, or in pixels where the name ends in Px
  std::vector<FindingAnswer> answers = {};
  std::optional<FindingLook> look = {};
  bool isVerdict = false; // on a fit: that it is good, or what is missing; a diagnosis has its own

  std::string_view kind() const { return std::string_view{id}.substr(0, id.find(':')); }
};

/// Joints, boards and cameras that a label names: "swappedJoints@shoulder,elbow", "jointOffset@HeadYaw.o", "board A".
FindingPlace placeOf(const std::string& label, const Measurements& measurements);

/// A finding about a label, its sentence made of the clause (`formatSentence`).
Finding makeFinding(const std::string& kind, const std::string& label, FindingLevel level, std::string why,
                    const Measurements& measurements);

/// Appends findings to others.
void append(std::vector<Finding> further, std::vector<Finding>& findings);

/// The clause as a sentence: with a capital, unless a name of the captures begins it, and a full stop.
std::string formatSentence(std::string why, const Measurements& measurements);

/// "17", or of one of several sets "SET/17".
std::string nameCapture(const Measurements& measurements, std::size_t set, int capture);

/// The most serious first, equal ones as they were.
void sortFindings(std::vector<Finding>& findings);

/// Why a result must not be used: the clauses of the findings of level stop.
std::vector<std::string> reasonsAgainstUse(const std::vector<Finding>& findings);

/// Appends findings, except on what others are about: of another id.
void appendNew(std::vector<Finding> further, std::vector<Finding>& findings);

/// The findings of a fit that hold whatever is missing: without its verdict. The first has its own sentence again.
std::vector<Finding> furtherThanVerdict(const std::vector<Finding>& findings, const Measurements& measurements);

/// The findings after the first that it does not already tell.
std::vector<const Finding*> furtherFindings(const std::vector<Finding>& findings);

/// Their sentences alone.
std::vector<std::string> sentencesOf(const std::vector<const Finding*>& findings);

/// As in files: "stop", "act", "note".
std::string toString(FindingLevel level);

/// A list as in files: {"id", "level", "sentence", "why", "numbers", "where", "look", "answer": [{"do", ..}]}.
nlohmann::json toJson(const std::vector<Finding>& findings);

} // namespace naocal
