#pragma once

namespace CLI {
class App;
}

namespace naocal {

/// Each function adds one subcommand; its callback throws InputError for bad usage or input.
void addSimulate(CLI::App& app);
void addDetect(CLI::App& app);
void addSolve(CLI::App& app, int& exitCode);
void addCompare(CLI::App& app);
void addEffects(CLI::App& app);
void addDiagnose(CLI::App& app, int& exitCode);
void addExplore(CLI::App& app);
void addPoses(CLI::App& app);
void addReport(CLI::App& app);
void addApply(CLI::App& app, int& exitCode);
void addExport(CLI::App& app, int& exitCode);
void addImport(CLI::App& app);
void addRecordingImports(CLI::App& importer); // of `import`
void addBoard(CLI::App& app);
void addCheck(CLI::App& app, int& exitCode);
void addHistory(CLI::App& app);
void addReplay(CLI::App& app, int& exitCode);
void addDemo(CLI::App& app, int& exitCode);
void addEvaluate(CLI::App& app);
void addEvaluateNext(CLI::App& evaluate); // further subcommands of evaluate
void addEvaluateThesis(CLI::App& evaluate);

} // namespace naocal
