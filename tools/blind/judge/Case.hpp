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
    std::string at, driver;
  };
  int exitCode = 0;
  double seconds = 0;
  std::string verdict; // empty: none was given
  std::vector<Candidate> ranking;
  std::vector<std::string> suggested;
  std::vector<Driver> drivers;
  std::optional<double> lockedBeforePx, lockedAfterPx; // rms on poses that were never used for choosing
  bool lockedFell = false;                             // that error, joints' random errors allowed for
};

struct Case {
  Truth truth;
  Answer answer;
};

/// All answered sets of a benchmark, by name. Throws when a truth is not the one that was sealed, or when an answer
/// was given to another one.
std::vector<Case> readCases(const std::filesystem::path& folder);

/// Hip yaw-pitch is one motor with two names; only axisTilt tells them apart.
std::string sameMotor(const std::string& effectAtPlace);

} // namespace blind
