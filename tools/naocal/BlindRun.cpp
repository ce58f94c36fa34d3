#include "BlindRun.hpp"
#include "Subprocess.hpp"

#include "estimation/ModelFile.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "robot/Robot.hpp"

#include <chrono>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <optional>

namespace naocal {

namespace {

namespace files = std::filesystem;

nlohmann::json jsonOf(const files::path& file) {
  return nlohmann::json::parse(fileContent(file));
}

std::string setName(std::size_t number) {
  return fmt::format("s{:06}", number);
}

/// One question on its way through the programs, in a folder of its own for what lies in between.
class Question {
public:
  Question(files::path naocal, files::path out, std::string name)
      : naocal_{std::move(naocal)}, set_{out / "sets" / name}, locked_{out / "locked" / name}, between_{out /
                                                                                                        "between" /
                                                                                                        name} {
    files::create_directories(between_);
  }
  ~Question() { files::remove_all(between_); }
  Question(const Question&) = delete;
  Question& operator=(const Question&) = delete;

  /// What naocal says. Absent: it was stopped.
  std::optional<nlohmann::json> answer(bool pictures) const {
    if (pictures) {
      const Finished found = run({naocal_, "detect", set_.string(), "--threads", "1"});
      if (found.exitCode != 0) {
        return refused(found);
      }
    }
    const auto start = std::chrono::steady_clock::now();
    const Finished said =
        run({naocal_, "diagnose", set_.string(), "--json", between_ / "diagnosis.json", "--next-count", "0"});
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    if (said.exitCode != 0 && said.exitCode != 3) {
      return refused(said);
    }
    nlohmann::json answer{
        {"exitCode", said.exitCode}, {"seconds", seconds.count()}, {"locked", nlohmann::json::object()}};
    answer["diagnosis"] = jsonOf(between_ / "diagnosis.json");
    const auto suggested = answer["diagnosis"].value("suggested", std::vector<std::string>{});
    answer["solved"] = solved({}, "before.json");
    answer["solvedWithFixedNoise"] = solved({"--fixed-noise"}, "fixed.json");
    if (!suggested.empty()) {
      answer["solvedWithSuggested"] = solved(adding(suggested, answer["diagnosis"]), "after.json");
      answer["locked"] = locked();
    }
    return answer;
  }

private:
  static std::optional<nlohmann::json> refused(const Finished& finished) {
    if (finished.stopped) {
      return std::nullopt;
    }
    return nlohmann::json{{"exitCode", finished.exitCode},
                          {"error", finished.said},
                          {"diagnosis", nullptr},
                          {"locked", nlohmann::json::object()}};
  }

  /// The errors on poses that were never used for choosing, without and with what was suggested. Empty where they
  /// cannot be found.
  nlohmann::json locked() const {
    if (!files::exists(between_ / "before.json") || !files::exists(between_ / "after.json") ||
        run({naocal_, "compare", between_ / "after.json", locked_, "--against", between_ / "before.json", "--json",
             between_ / "compared.json"})
                .exitCode != 0) {
      return nlohmann::json::object();
    }
    const nlohmann::json compared = jsonOf(between_ / "compared.json");
    const nlohmann::json& before = compared.at("against");
    return {{"beforePx", before.at("rmsPx")},
            {"afterPx", compared.at("rmsPx")},
            {"weightedBeforePx", before.at("weightedPx")},
            {"weightedAfterPx", compared.at("weightedPx")}};
  }

  /// How solve adds what a diagnosis suggests: by a model file where that defines effects of its own.
  std::vector<std::string> adding(const std::vector<std::string>& suggested, const nlohmann::json& diagnosis) const {
    const nlohmann::json define = diagnosis.value("define", nlohmann::json::array());
    if (define.empty()) {
      return {"--with", fmt::format("{}", fmt::join(suggested, ","))};
    }
    writeAtomically(between_ / "model.json", modelJson(suggested, {}, define).dump());
    return {"--model", between_ / "model.json"};
  }

  /// What RESULT.json says of the calibration itself; null where there is none.
  nlohmann::json solved(const std::vector<std::string>& options, const char* file) const {
    std::vector<std::string> solve{naocal_, "solve", set_.string(), "-o", between_ / file};
    solve.insert(solve.end(), options.begin(), options.end());
    const int exitCode = run(solve).exitCode;
    if ((exitCode != 0 && exitCode != 3) || !files::exists(between_ / file)) {
      return nullptr;
    }
    const nlohmann::json result = jsonOf(between_ / file);
    nlohmann::json told{{"exitCode", exitCode}};
    for (const char* key : {"usable", "verdict", "pValue", "rmsPx", "noise", "effects", "converged"}) {
      if (result.contains(key)) {
        told[key] = result.at(key);
      }
    }
    return told;
  }

  std::string naocal_;
  files::path set_, locked_, between_;
};

files::path thisProgram() {
  return files::read_symlink("/proc/self/exe");
}

files::path besideThisProgram(const char* name) {
  const files::path program = thisProgram().parent_path() / name;
  if (!files::exists(program)) {
    throw InputError{
        fmt::format("{}: expected the program beside naocal, found none; build the target {}", program.string(), name)};
  }
  return program;
}

} // namespace

BlindRun::BlindRun(BlindPlan plan)
    : plan_{std::move(plan)}, naocal_{thisProgram()}, writer_{besideThisProgram("blind-writer")} {
  std::vector<std::string> command = writerCommand();
  command.emplace_back("--size");
  const Finished counted = run(command);
  if (counted.exitCode != 0) {
    throw InputError{counted.said};
  }
  size_ = std::stoul(counted.printed);
}

std::vector<std::string> BlindRun::writerCommand() const {
  std::vector<std::string> command{writer_,      plan_.out,
                                   "--seed",     fmt::format("{}", plan_.seed),
                                   "--controls", fmt::format("{}", plan_.controls),
                                   "--sets",     fmt::format("{}", plan_.sets),
                                   "--pictures", fmt::format("{}", plan_.pictureShare),
                                   "--drawing",  configurationDirectory() / "drawings" / "NaoV6.json"};
  if (!plan_.only.empty()) {
    command.insert(command.end(), {"--only", plan_.only});
  }
  return command;
}

files::path BlindRun::answerFile(std::size_t number) const {
  return plan_.out / "answers" / (setName(number) + ".json");
}

bool BlindRun::answered(std::size_t number) const {
  return files::exists(answerFile(number));
}

bool BlindRun::ask(std::size_t number) const {
  const std::string name = setName(number);
  std::vector<std::string> write = writerCommand();
  write.insert(write.end(), {"--first", fmt::format("{}", number), "--count", "1"});
  const Finished written = run(write);
  if (written.stopped) {
    return false;
  }
  if (written.exitCode != 0) {
    throw InputError{written.said};
  }
  const nlohmann::json manifest = jsonOf(plan_.out / "manifest" / (name + ".json"));
  auto answer = Question{naocal_, plan_.out, name}.answer(manifest.at("pictures").get<bool>());
  if (!answer) {
    return false;
  }
  answer->update(
      {{"format", "naocal-blind-answer"}, {"version", 1}, {"set", name}, {"truthSha256", manifest.at("truthSha256")}});
  files::create_directories(plan_.out / "answers");
  writeAtomically(answerFile(number), answer->dump(1) + "\n");
  if (!plan_.keep) {
    files::remove_all(plan_.out / "sets" / name);
    files::remove_all(plan_.out / "locked" / name);
  }
  return true;
}

void judgeBlindly(const files::path& folder, const std::string& json, const std::string& page) {
  std::vector<std::string> command{besideThisProgram("blind-judge"), folder};
  if (!json.empty()) {
    command.insert(command.end(), {"--json", json});
  }
  if (!page.empty()) {
    command.insert(command.end(), {"--page", page});
  }
  const Finished judged = run(command);
  if (judged.exitCode != 0) {
    throw InputError{judged.said};
  }
  fmt::print("{}", judged.printed);
}

} // namespace naocal
