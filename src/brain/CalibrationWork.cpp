#include "brain/CalibrationWork.hpp"

#include "brain/LegPoses.hpp"
#include "brain/SavedCalibration.hpp"
#include "captures/Files.hpp"

#include <deque>
#include <exception>

namespace naocal {
namespace {

constexpr double leastGain = 0.5; // what a calibration leaves of the error at most, to be kept

/// Each foot's poses, one foot after the other; each time that the robot steps onto one is a stance.
CalibrationRound legRound(const std::deque<LegPoses>& legs, RoundOptions options) {
  CalibrationRound round;
  int stance = 0;
  for (const LegPoses& leg : legs) {
    const CalibrationRound onFoot = leg.round(options, stance++);
    round.insert(round.end(), onFoot.begin(), onFoot.end());
  }
  return round;
}

} // namespace

void CalibrationWork::begin(std::filesystem::path folder) {
  folder_ = std::move(folder);
  sessions_ = {};
  give([files = surroundings_.files, folder = folder_](Finding&) {
    std::filesystem::create_directories(folder);
    std::filesystem::copy(files, folder / "configuration", std::filesystem::copy_options::recursive);
  });
}

void CalibrationWork::plan(Legs legs) {
  give([legs = std::move(legs), &drawing = surroundings_.drawing, folder = folder_,
        files = surroundings_.files](Finding& finding) mutable {
    std::filesystem::path file = files / "poses" / (drawing.model + ".json");
    if (!legs.asked.empty()) { // what was asked for stays with what was recorded
      file = folder / "poses.json";
      writeAtomically(file, legs.asked);
    }
    const PoseFile poses = readPoseFile(file, drawing);
    std::deque<LegPoses> each;
    for (const SupportFoot foot : legs.feet) {
      each.emplace_back(drawing, poses, foot, legs.home);
    }
    finding.rounds.emplace();
    finding.rounds->at(0) = legRound(each, legs.options);
    ++legs.options.seed;
    legs.options.poses = static_cast<std::size_t>(legs.checkPoses);
    finding.rounds->at(1) = legRound(each, legs.options);
  });
}

void CalibrationWork::open(std::size_t round, CaptureSet header) {
  sessions_[round] = std::make_shared<Round>();
  give([session = sessions_[round], &drawing = surroundings_.drawing, header = std::move(header),
        folder = folder_ / (round == 0 ? "first" : "second")](Finding&) {
    session->session.emplace(drawing, header, folder);
  });
}

void CalibrationWork::look(std::size_t round, Capture capture, ShownCapture shown, CameraFrame frame) {
  give([this, session = sessions_[round], folder = folder_, capture = std::move(capture), shown = std::move(shown),
        frame = std::move(frame)](Finding&) mutable {
    if (lookedAt_.folder != folder) {
      lookedAt_ = {folder, {}};
    }
    shown.corners = 0;
    for (const BoardCorners& board : session->session.value().add(capture, frame)) {
      shown.boards.push_back(board.board);
      *shown.corners += static_cast<int>(board.ids.size());
    }
    lookedAt_.captures.push_back(std::move(shown));
    looked_.write(lookedAt_);
  });
}

void CalibrationWork::solve(StoredResult before, bool onlyHead) {
  give([this, session = sessions_[0], before = std::move(before), onlyHead](Finding& finding) {
    const CalibrationSession::Solved solved = session->session.value().solved();
    const std::vector<ShownOffset> offsets = onlyHead ? ofHead(solved.offsets) : solved.offsets;
    finding.outcome = shownOutcome(before, offsets, lookedAt_.captures);
    for (const Warning& warning : solved.warnings) { // only with the legs it is known where the floor is
      if (warning.about == Warning::About::fit || (warning.about == Warning::About::floor && !onlyHead)) {
        finding.outcome->warnings.push_back(warning.sentence);
      }
    }
    apply(learned(offsets), solved.result, surroundings_.configuration);
    finding.isApplied = true;
  });
}

void CalibrationWork::check(StoredResult before) {
  give([session = sessions_[1], before = std::move(before),
        &configuration = surroundings_.configuration](Finding& finding) {
    finding.error = session->session.value().error(before, configured(configuration));
    finding.isKept = finding.error->after <= leastGain * finding.error->before;
    if (!finding.isKept) {
      takeBack(configuration);
    }
  });
}

CalibrationWork::Finding* CalibrationWork::found() {
  Finding* finding = findings_.take();
  return finding != nullptr && finding->folder == folder_ ? finding : nullptr;
}

const std::vector<ShownCapture>* CalibrationWork::looked() {
  const Looked* looked = looked_.take();
  return looked != nullptr && looked->folder == folder_ ? &looked->captures : nullptr;
}

void CalibrationWork::give(std::function<void(Finding&)> task) {
  worker_.add([this, folder = folder_, task = std::move(task)] {
    Finding finding{.folder = folder};
    try {
      task(finding);
    } catch (const std::exception& error) {
      finding.problem = error.what();
    }
    if (finding.rounds || finding.isApplied || finding.error || !finding.problem.empty()) {
      findings_.write(std::move(finding));
    }
  });
}

} // namespace naocal
