#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace blind {

/// What was hidden in one set, as its sealed truth tells.
struct Truth {
  struct Effect {
    std::string name;                       // effect@place
    std::map<std::string, double> unknowns; // true sizes
    std::vector<std::string> drivers;       // outside the catalogue: what the misfit varies with
    double noncentrality = 0;
  };
  std::string set, group, kind, noise;
  int poses = 0;
  bool pictures = false;
  double wanted = 0; // noncentrality that was aimed at; 0: a physical size
  std::vector<Effect> effects;
  double lockedFloorPx = 0;
  double plausible = 0;                  // how large the effect is, in plausible sizes; 0: not sized so
  double jitter = 0;                     // of readings at rest [rad]
  std::map<std::string, double> offsets; // by joint [rad]
  struct Event {
    std::string what, at;         // "kicked board", "slipped robot", "offset step"; board, stance or joint
    double before = 0, after = 0; // between these readings, since the first one [s]
  };
  std::optional<Event> event;
};

/// A calibration of the set, as RESULT.json tells it.
struct Solved {
  struct Offset {
    double value, sigma, low, high, learned; // low, high: its 95 % interval
  };
  bool usable = false;
  double pValue = 0, rmsPx = 0;
  std::map<std::string, double> noise;
  std::map<std::string, Offset> offsets; // by joint
};

/// What the solver said about one set.
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
  std::string verdict; // empty: none was given
  std::vector<Candidate> ranking;
  std::vector<std::string> suggested;
  std::vector<Driver> drivers;
  std::optional<double> lockedBeforePx, lockedAfterPx; // rms on poses that were never used for choosing
  bool lockedFell = false;                             // that error, joints' random errors allowed for
  struct Suspicion {
    std::string why;
    std::optional<double> time; // since the first capture [s]
  };
  std::vector<Suspicion> suspicious;
  std::optional<Solved> first, suggestedAdded; // nothing added, and with what was suggested
  std::optional<double> fixedNoisePx;          // rms of a fit with the usual noise levels
};

struct Case {
  Truth truth;
  Answer answer;
};

/// All answered sets of a benchmark, by name. Throws when a truth is not the one that was sealed, or when an answer
/// was given to another one.
std::vector<Case> readCases(const std::filesystem::path& folder);

/// Hip yaw-pitch is one motor with two names; only axisTilt tells them apart. A spring is an elasticity.
std::string canonicalMotor(const std::string& effectAtPlace);

} // namespace blind
