#include "writer/machines/WorkcellQuestion.hpp"

#include "writer/NoncentralityScaling.hpp"
#include "writer/machines/WorkcellVisibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <stdexcept>

namespace blind {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr std::array<Witness, 6> witnesses{Witness::wristCamera,  Witness::cameraBeside, Witness::trackedPoints,
                                           Witness::trackedFrame, Witness::touch,        Witness::footAndHead};

class WorkcellDesigner {
public:
  WorkcellDesigner(const std::string& only, std::uint64_t seed) : only_{only}, chance_{seed, "machines"} {}

  std::vector<WorkcellItem> items(int controls, int sets) {
    for (const Witness witness : witnesses) {
      repeat(controls, {"control", "", 0, witness});
    }
    for (const MachineFamily& family : machineCatalogue()) {
      for (const double size : {10.0, 20.0, 40.0, 80.0}) {
        for (int i = 0; i < sets; ++i) {
          repeat(1, {"catalogue", family.effect, size, drawWitness(family.ofTracker)});
        }
      }
    }
    for (const char* kind : {"reversedJoint", "countSlip"}) {
      addEach(2 * sets, "setup", kind);
    }
    addEach(2 * sets, "reading", "bad reading");
    for (const Witness witness : witnesses) {
      if (witness != Witness::touch) { // whose places do not move
        repeat(sets, {"event", "moved", 0, witness});
      }
    }
    for (std::size_t i = items_.size(); i > 1; --i) {
      std::swap(items_[i - 1], items_[static_cast<std::size_t>(chance_.below(static_cast<int>(i)))]);
    }
    return std::move(items_);
  }

private:
  Witness drawWitness(bool tracker) {
    return tracker ? witnesses[static_cast<std::size_t>(2 + chance_.below(2))]
                   : witnesses[static_cast<std::size_t>(chance_.below(static_cast<int>(witnesses.size())))];
  }
  void addEach(int count, const char* group, const char* kind) {
    for (int i = 0; i < count; ++i) {
      repeat(1, {group, kind, 0, drawWitness(false)});
    }
  }
  void repeat(int count, WorkcellItem item) {
    for (int i = 0; i < count; ++i) {
      item.poses = 15 + chance_.below(46);
      if (only_.empty() || only_ == item.group) {
        items_.push_back(item);
      }
    }
  }

  const std::string& only_;
  RandomStream chance_;
  std::vector<WorkcellItem> items_;
};

const MachineFamily& machineFamily(const std::string& effect) {
  for (const MachineFamily& family : machineCatalogue()) {
    if (family.effect == effect) {
      return family;
    }
  }
  throw std::runtime_error{fmt::format("no effect is named {}", effect)};
}

/// Whether gravity holds the joint's gear at one end of a gap in every reading: backlash. Where its load is smaller
/// than the friction, the last motion decides: that is gearPlay, or hysteresis without any load.
bool isLoaded(const WorkcellQuestion& question, std::size_t joint) {
  const MachineBody body = bodyOf(question.cell);
  return std::all_of(question.session.begin(), question.session.end(), [&](const WorkcellReading& reading) {
    const VectorXd load = body.torques(body.settled(linkAngles(question.cell, reading)));
    return std::abs(load[static_cast<Index>(joint)]) > question.cell.flaws.joints[joint].gapFriction;
  });
}

/// Hides the flaw of an item; false if the question does not allow its size. `patience`: grows from 0 to 1 with the
/// attempts.
bool hideFlaw(const WorkcellItem& item, double patience, WorkcellQuestion& question, RandomStream& chance) {
  constexpr double most = 4, leastKept = 1e-3; // in units of the expected size; of the evidence
  const MachineFamily& family = machineFamily(item.kind);
  const auto joint = static_cast<std::size_t>(chance.below(static_cast<int>(question.machine->joints.size())));
  if (!family.ofTracker && question.machine->joints[joint].slides) {
    return false;
  }
  if (family.effect == "backlash" && !isLoaded(question, joint)) {
    return false;
  }
  const VectorXd without = stackMeasurements(question.cell, question.session);
  const MeasuredChange change = [&](const std::vector<double>& values) {
    Workcell flawed = question.cell;
    family.apply(flawed.flaws, joint, values);
    return VectorXd{stackMeasurements(flawed, question.session) - without};
  };
  std::vector<double> ofUnknowns;
  for (const FlawFamily::Unknown& unknown : family.unknowns) {
    ofUnknowns.push_back(unknown.physical);
  }
  const ProjectedProduct visibility = workcellVisibility(question.cell, question.session, question.plan);
  const std::vector<double> shape = drawShape(ofUnknowns, family.positive, chance);
  const auto flaw = scaleFlaw(change, visibility, shape, item.noncentrality, (1 + patience) * most);
  if (!flaw || flaw->kept < leastKept) {
    return false;
  }
  question.hidden = {&family, family.ofTracker ? "tracker" : question.machine->joints[joint].name, flaw->values,
                     flaw->noncentrality, flaw->kept};
  family.apply(question.cell.flaws, joint, flaw->values);
  return true;
}

Transform drawDisplacement(Witness witness, RandomStream& chance) {
  const double least = seesBoard(witness) ? 0.003 : 0.002;
  const double angle = chance.uniformWithin(std::numbers::pi), distance = chance.between(least, 0.02);
  if (witness == Witness::footAndHead) {
    return floorTransform(distance * std::cos(angle), distance * std::sin(angle), chance.uniformWithin(0.02));
  }
  const Vector3d axis{chance.normal(1), chance.normal(1), chance.normal(1)};
  return {rotationAbout(axis.normalized(), chance.uniformWithin(0.01)),
          {distance * std::cos(angle), distance * std::sin(angle), 0}};
}

/// Everything that is no flaw of the catalogue.
void arrange(const WorkcellItem& item, WorkcellQuestion& question, RandomStream& chance) {
  const auto joints = static_cast<int>(question.machine->joints.size());
  const auto readings = question.session.size();
  if (item.kind == "moved") {
    const auto from = readings * static_cast<std::size_t>(30 + chance.below(40)) / 100;
    const int samples = question.plan.samples; // between two poses
    question.movedFrom = from - from % static_cast<std::size_t>(samples);
    question.cell.moved =
        Workcell::Move{question.session[*question.movedFrom].time, drawDisplacement(question.plan.witness, chance)};
  } else if (item.kind == "bad reading") {
    question.badReading = static_cast<std::size_t>(chance.below(static_cast<int>(readings)));
  } else if (item.kind == "reversedJoint") {
    do {
      question.reversed = static_cast<std::size_t>(chance.below(joints));
    } while (question.machine->joints[*question.reversed].slides);
  }
}

/// A joint whose zero is off by whole turns of its motor; before its readings are staged.
void slipCount(WorkcellQuestion& question, RandomStream& chance) {
  const auto joints = question.machine->joints.size();
  question.plan.slipStep = 2 * std::numbers::pi / chance.between(50, 120);
  for (std::size_t i = 0; i < joints; ++i) { // zeros are good to a fifth of a turn
    question.cell.offsets[static_cast<Index>(i)] = chance.uniformWithin(0.2) * question.plan.slipStep;
  }
  // not the first and last joint, whose zeros other unknowns imitate
  question.slipped = static_cast<std::size_t>(1 + chance.below(static_cast<int>(joints) - 2));
  question.cell.offsets[static_cast<Index>(*question.slipped)] += chance.sign() * question.plan.slipStep;
}

} // namespace

const char* nameOf(Witness witness) {
  switch (witness) {
  case Witness::wristCamera:
    return "wrist camera";
  case Witness::cameraBeside:
    return "camera beside";
  case Witness::trackedPoints:
    return "tracked points";
  case Witness::trackedFrame:
    return "tracked frame";
  case Witness::footAndHead:
    return "one foot";
  case Witness::touch:
    break;
  }
  return "contacts";
}

std::vector<WorkcellItem> drawWorkcellDesign(int controls, int sets, const std::string& only, std::uint64_t seed) {
  return WorkcellDesigner{only, seed}.items(controls, sets);
}

WorkcellQuestion drawWorkcellQuestion(const WorkcellItem& item, RandomStream& chance) {
  constexpr int tries = 80;
  for (int attempt = 0; attempt < tries; ++attempt) {
    WorkcellQuestion question;
    question.plan = drawWorkcellPlan(item.witness, item.poses, chance);
    question.machine = std::make_unique<Machine>(drawMachine(question.plan.build, chance));
    question.cell = drawWorkcell(*question.machine, question.plan, chance);
    if (item.kind == "countSlip") {
      slipCount(question, chance);
    }
    try {
      question.session = stageWorkcell(question.cell, question.plan, chance);
    } catch (const std::runtime_error&) { // the board stands where this machine cannot look
      continue;
    }
    const double patience = static_cast<double>(attempt) / (tries - 1);
    if (item.group != "catalogue" || hideFlaw(item, patience, question, chance)) {
      arrange(item, question, chance);
      if (question.plan.witness == Witness::touch) {
        touchPlaces(question.cell, question.plan, question.session, chance);
      }
      return question;
    }
  }
  throw std::runtime_error{fmt::format("no machine and session were found in which {} of size {} can be hidden",
                                       item.kind, item.noncentrality)};
}

} // namespace blind
