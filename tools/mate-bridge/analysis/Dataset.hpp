#pragma once

#include "data/Capture.hpp"
#include "diagnosis/Session.hpp"
#include "robot/Robot.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace naocal {

/// What a person opened: capture sets, and the model to begin with.
struct Dataset {
  std::vector<CaptureSet> sets;
  ResultInputs inputs;
  std::map<std::string, std::filesystem::path> folders; // by the set's name
  Robot robot;
  std::vector<std::string> terms; // of the result that was opened; empty: the base model
  std::vector<std::string> with,
      without;                    // what a diagnosis or a model that was opened adds to the base model, and lacks
  std::string definitions = "[]"; // the person's own effects: a list of JSON
  std::vector<Rung> ladder;       // of a session that goes on, in place of all these
  std::size_t at = 0;             // where one stands on it
  std::string sessionFile;        // that keeps the ladder from now on; may be empty
};

/// Opens capture sets (folders with captures.json), folders of sets, recordings of the robot, or one RESULT.json,
/// DIAGNOSIS.json or session together with the sets that it was made from (as they are written there, or beside it;
/// behind an older diagnosis they are named), or a MODEL.json with sets behind it. A robot's recording that is opened
/// alone opens with the round that it was solved from and the model that it was solved with. Pictures whose corners
/// were not looked for are searched, and nothing is written. Throws InputError that names file, what was expected and
/// found.
Dataset openDataset(const std::vector<std::string>& paths);

/// The same, and keeps a session of it in a file: goes on from it where it is there already.
Dataset openSession(std::vector<std::string> paths, const std::string& file);

} // namespace naocal
