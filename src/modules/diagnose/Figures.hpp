#pragma once

#include "diagnose/Aliases.hpp"
#include "diagnose/BoardShape.hpp"
#include "diagnose/Leftover.hpp"
#include "diagnose/Taken.hpp"
#include "diagnose/WhatIf.hpp"
#include "evidence/DriverColumns.hpp"

#include <vector>

namespace naocal {

/// What a diagnosis's figures show beside its candidates' own.
struct Figures {
  /// What a model leaves over.
  struct Left {
    std::vector<WhatIfs> whatIfs; // per joint
    Leftover leftover;
    std::vector<BoardShape> shapes;
  };
  Taken taken;                        // poses and pictures, as the figures count them
  AliasMatrix aliases;                // of the first of the ranking, in the model as given
  std::vector<DriverValues> recorded; // what joints' deflections may vary with
  Left given, last;                   // of the model as given, and with everything suggested (empty where nothing is)
};

} // namespace naocal
