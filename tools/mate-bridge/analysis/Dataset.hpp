#pragma once

#include "data/Capture.hpp"
#include "diagnosis/Session.hpp"
#include "io/InputError.hpp"
#include "robot/Robot.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace naocal {

/// An opened dataset: capture sets and the initial model.
struct Dataset {
  std::vector<CaptureSet> sets;
  ResultSources inputs;
  std::map<std::string, std::filesystem::path> folders; // by set name
  Robot robot;
  std::string result;             // file of the opened result, or of the opened recording; may be empty
  std::vector<std::string> terms; // of that result; empty: base model
  std::vector<std::string> with,
      without;                       // differences from the base model, of an opened diagnosis or model
  std::string definitions = "[]";    // custom effects, a JSON list
  std::vector<ModelRevision> ladder; // revisions of an opened session; replaces the members above
  std::size_t at = 0;                // current revision
  std::string sessionFile;           // file that stores the session; may be empty
  std::vector<std::string> moved;    // a sentence for each set that was found elsewhere than at its place
};

/// Captures that a document names were not found; the user can name a folder to search.
class MissingCaptures : public InputError {
public:
  using InputError::InputError;
};

/// Opens capture sets (folders with captures.json), folders of sets, recordings of the robot, or one RESULT.json,
/// DIAGNOSIS.json or session together with its sets (at the recorded path, near the document or in `lookIn`, by
/// `findSet`; for an older diagnosis they must be given), or a MODEL.json with sets. A robot's recording opened alone
/// gives the round that was solved and its model. Detects corners in images without detections; writes nothing. Throws
/// InputError that names file, expectation and finding, MissingCaptures if a document's sets are not found.
Dataset openDataset(const std::vector<std::string>& paths, const std::vector<std::filesystem::path>& lookIn = {});

/// Like `openDataset`, and stores the session in `file`; continues it if the file exists.
Dataset openSession(std::vector<std::string> paths, const std::string& file,
                    const std::vector<std::filesystem::path>& lookIn = {});

} // namespace naocal
