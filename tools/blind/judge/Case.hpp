#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace blind {

/// Ground truth of one set, from its sealed file.
struct Truth {
  struct Effect {
    std::string name;                       // effect@place
    std::map<std::string, double> unknowns; // true sizes
    std::vector<std::string> drivers;       // outside the catalogue: drivers of the misfit
    double noncentrality = 0;
  };
  std::string set, group, kind, noise;
  int poses = 0;
  bool pictures = false;
  double wanted = 0; // target noncentrality; 0: a physical size
  std::vector<Effect> effects;
  double lockedFloorPx = 0;
  double plausible = 0;                  // size in units of the plausible size; 0: not sized this way
  double jitter = 0;                     // of readings at rest, 1 sigma [rad]
  std::map<std::string, double> offsets; // by joint [rad]
  struct Event {
    std::string what, at;                   // "kicked board", "slipped robot", "offset step"; board, stance or joint
    double before = 0, after = 0;           // last reading before and first one after it, since the first reading [s]
    std::optional<int> from = std::nullopt; // first capture after it, where something beside a machine moved
  };
  std::optional<Event> event;
  bool machine = false;          // a robot with a URDF; `noise` says then how it is measured
  std::string setUp;             // "reversedJoint@JOINT", "countSlip@JOINT"; empty: right
  std::optional<int> badCapture; // id of a wrong reading
};

/// A calibration of the set, from RESULT.json.
struct Solved {
  struct Offset {
    double value, sigma;
    double low, high;           // of its 95 % interval
    double boundLow, boundHigh; // of its 99.95 % bound
    double learned;
  };
  bool usable = false;
  double pValue = 0, rmsPx = 0;
  std::map<std::string, double> noise;
  std::map<std::string, Offset> offsets; // by joint
};

/// naocal's answer for one set.
struct Answer {
  struct Candidate {
    std::string name, state;
    std::vector<std::string> equivalent;
    struct Size {
      double value, sigma;
    };
    std::map<std::string, Size> unknowns;
  };
  struct Driver {
    std::string at, driver, expression;
  };
  int exitCode = 0;
  double seconds = 0;
  std::string verdict; // empty: no verdict
  std::vector<Candidate> ranking;
  std::vector<std::string> suggested;
  std::vector<Driver> drivers;
  std::optional<double> lockedBeforePx, lockedAfterPx; // rms on locked poses, never used for selection
  bool lockedFell = false;                             // that error fell, weighted with the joints' random errors
  struct Suspicion {
    std::string why;
    std::optional<double> time;       // since the first capture [s]
    std::string setUp, moved;         // label of a wrong set-up; what moved
    std::optional<int> capture, from; // ids of a bad capture and of the first one after a move
  };
  std::vector<Suspicion> suspicious;
  std::optional<Solved> first, suggestedAdded; // without additions, and with the suggested effects
  std::optional<double> fixedNoisePx;          // rms of a fit with the default noise levels
};

struct Case {
  Truth truth;
  Answer answer;
};

/// All answered sets of a benchmark, by name. Throws std::runtime_error if a truth differs from the sealed one, or if
/// an answer belongs to another truth.
std::vector<Case> readCases(const std::filesystem::path& folder);

/// Canonical label: hip yaw-pitch is one motor with two names, distinguished by axisTilt only; spring is an alias of
/// elasticity.
std::string canonicalMotor(const std::string& effectAtPlace);

} // namespace blind
