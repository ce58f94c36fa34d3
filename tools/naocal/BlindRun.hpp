#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace naocal {

/// Which sets of the blind benchmark are to be asked, and how.
struct BlindPlan {
  std::filesystem::path out;
  std::uint64_t seed = 1;
  int controls = 4;        // per regime of noise
  int sets = 1;            // per effect and size, per case otherwise
  double pictureShare = 0; // of controls and catalogued effects: rendered instead of corners
  std::string only;        // one group alone; empty: all
  bool keep = false;       // sets stay after their answers are written
};

/// Asks naocal about robots whose flaws it cannot know. Everything goes through programs and files as a person would
/// use them: blind-writer, naocal detect, diagnose, solve and compare. Thread-safe.
class BlindRun {
public:
  /// Finds the programs beside this one. Throws InputError where they are missing.
  explicit BlindRun(BlindPlan plan);

  /// How many sets the plan has.
  std::size_t size() const { return size_; }
  bool answered(std::size_t number) const;
  /// Writes the set, answers it and writes the answer; nothing remains half done. False where a program was stopped.
  bool ask(std::size_t number) const;

private:
  std::vector<std::string> writerCommand() const;
  std::filesystem::path answerFile(std::size_t number) const;

  BlindPlan plan_;
  std::filesystem::path naocal_, writer_;
  std::size_t size_ = 0;
};

/// Lets blind-judge open a folder's truths and prints what it says. `json`, `page`: files to write, or nothing.
void judgeBlindly(const std::filesystem::path& folder, const std::string& json, const std::string& page);

} // namespace naocal
