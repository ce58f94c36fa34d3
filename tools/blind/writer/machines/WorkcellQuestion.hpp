#pragma once

#include "writer/machines/WorkcellPlanner.hpp"

#include <memory>

namespace blind {

/// One set of a machine to be written.
struct WorkcellItem {
  std::string group;        // control, catalogue, setup, event, reading
  std::string kind;         // effect, set-up, what moved; empty: none
  double noncentrality = 0; // target
  Witness witness = Witness::wristCamera;
  int poses = 30;
};

/// A flaw of a machine.
struct HiddenMachineFlaw {
  const MachineFamily* family = nullptr;
  std::string place;
  std::vector<double> values;
  double noncentrality = 0, kept = 0;
};

/// A machine with hidden flaws and a session in which to find them.
struct WorkcellQuestion {
  WorkcellPlan plan;
  std::unique_ptr<Machine> machine; // cell refers to it
  Workcell cell;
  WorkcellSession session;
  std::optional<HiddenMachineFlaw> hidden;
  std::optional<std::size_t> reversed, slipped; // joints
  std::optional<std::size_t> movedFrom;         // first reading after something moved
  std::optional<std::size_t> badReading;
};

/// Name of a witness in files: "wrist camera", ...
const char* nameOf(Witness witness);

/// All sets in random order: every prefix is a fair sample. `only`: a single group; empty: all.
std::vector<WorkcellItem> drawWorkcellDesign(int controls, int sets, const std::string& only, std::uint64_t seed);

/// Draws machines and sessions until the item's flaw has the required size without being implausibly large. Throws
/// std::runtime_error if that fails.
WorkcellQuestion drawWorkcellQuestion(const WorkcellItem& item, RandomStream& chance);

} // namespace blind
