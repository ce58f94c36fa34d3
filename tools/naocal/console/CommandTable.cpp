#include "console/CommandTable.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <string>

namespace naocal {

namespace {

/// Headings of help: what a person does.
struct Group {
  static constexpr std::string_view first = "First steps", calibrate = "Calibrate", understand = "Understand",
                                    handOn = "Hand on", evaluate = "Evaluate";
};

constexpr std::array table{
    CommandEntry{"demo", Group::first,
                 "the whole way on a simulated robot: pictures, corners, what is missing, offsets, truth, report",
                 picturesProgram},
    CommandEntry{"simulate", Group::first, "writes a synthetic robot's captures; the truth lies beside them",
                 picturesProgram},
    CommandEntry{"board", Group::calibrate, "draws ChArUco boards to print, and keeps the size of the print",
                 picturesProgram},
    CommandEntry{"poses", Group::calibrate, "plans poses worth taking, and where to lay the boards", picturesProgram},
    CommandEntry{"check", Group::calibrate, "lists every problem of a capture set at once", mainProgram},
    CommandEntry{"detect", Group::calibrate, "finds the boards' corners in a set's pictures", picturesProgram},
    CommandEntry{"solve", Group::calibrate, "calibrates joints and cameras from capture sets", mainProgram},
    CommandEntry{"compare", Group::calibrate, "measures a result's prediction error on other captures", mainProgram},
    CommandEntry{"diagnose", Group::understand, "says where and why the model fails, and which effect is missing",
                 mainProgram},
    CommandEntry{"effects", Group::understand, "lists the physical effects that a calibration can estimate",
                 mainProgram},
    CommandEntry{"explore", Group::understand, "adds and removes effects by hand, with history", mainProgram},
    CommandEntry{"report", Group::understand,
                 "one HTML page to look at a result, a diagnosis or an evaluation, readable without a network",
                 picturesProgram},
    CommandEntry{"apply", Group::handOn,
                 "writes a result into a robot's configuration (HULKs' layout), and takes it back", mainProgram},
    CommandEntry{"export", Group::handOn, "writes a result as configuration files of other programs", mainProgram},
    CommandEntry{"import", Group::handOn,
                 "makes capture sets of tables (CSV) and ROS 2 recordings (MCAP); reads other programs' configuration",
                 picturesProgram},
    CommandEntry{"history", Group::handOn, "the runs of robots, and how their offsets changed over time", mainProgram},
    CommandEntry{"replay", Group::evaluate,
                 "runs the robot's own program over a recording: detects, solves and compares as on the robot",
                 mainProgram},
    CommandEntry{"evaluate", Group::evaluate, "measures how good naocal is on simulated robots with known truth",
                 evaluateProgram},
};

} // namespace

std::span<const CommandEntry> commandTable() {
  return table;
}

const CommandEntry* findCommand(std::string_view name) {
  const auto* const entry =
      std::find_if(table.begin(), table.end(), [&](const CommandEntry& each) { return each.name == name; });
  return entry == table.end() ? nullptr : entry;
}

void addTable(CLI::App& app) {
  for (const CommandEntry& entry : table) {
    app.add_subcommand(std::string{entry.name}, std::string{entry.description})->group(std::string{entry.group});
  }
}

} // namespace naocal
