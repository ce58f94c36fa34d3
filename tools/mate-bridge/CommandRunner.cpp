#include "CommandRunner.hpp"

#include "dialects/heads/DialectNames.hpp"
#include "io/InputError.hpp"
#include "protocol/BoundedJson.hpp"

#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>

namespace naocal {

namespace {

using Json = nlohmann::json;

constexpr std::size_t mostWords = 64;

/// Commands that need no input while they run.
const std::set<std::string> commands{"apply",    "board",  "check",  "compare", "detect", "diagnose", "effects",
                                     "evaluate", "export", "import", "poses",   "report", "simulate", "solve"};

/// Empty if it has been deleted.
std::string currentFolder() {
  std::error_code gone;
  return std::filesystem::current_path(gone).string();
}

} // namespace

CommandRunner::CommandRunner(boost::asio::io_context& context, std::optional<std::filesystem::path> program,
                             MessageSink tell)
    : tell_{std::move(tell)}, folder_{currentFolder()}, child_{context, "naocal", std::move(program),
                                                               [this] { tell_(latest()); }} {}

void CommandRunner::run(const std::vector<std::string>& words) {
  if (words.empty() || words.size() > mostWords || !commands.contains(words.front())) {
    throw InputError{fmt::format("expected one of naocal's commands ({}) and its options, found \"{}\"",
                                 fmt::join(commands, ", "), fmt::join(words, " "))};
  }
  ending_ = ending_ && child_.isRunning();
  child_.start(words);
}

void CommandRunner::end() {
  child_.end(ending_ ? SIGTERM : SIGINT);
  ending_ = true;
  tell_(latest());
}

std::string CommandRunner::latest() const {
  const auto& program = child_.program();
  const auto& exitCode = child_.exitCode();
  return jsonText({{"kind", "errand"},
                   {"program", program ? Json(program->string()) : Json(nullptr)},
                   {"folder", folder_},
                   {"importedDialects", importedDialects()},
                   {"exportedDialects", exportedDialects()},
                   {"words", child_.words()},
                   {"lines", child_.lines()},
                   {"running", child_.isRunning()},
                   {"ending", ending_},
                   {"exitCode", exitCode ? Json(*exitCode) : Json(nullptr)}});
}

} // namespace naocal
