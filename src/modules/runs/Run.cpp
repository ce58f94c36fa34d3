#include "runs/Run.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <regex>

namespace naocal {

namespace {

/// The text in letters, digits, "." and "-", at most `longest` of them.
std::string plainWords(std::string_view text, std::size_t longest) {
  std::string words{text.substr(0, longest)};
  std::replace_if(
      words.begin(), words.end(),
      [](unsigned char letter) { return letter >= 128 || (std::isalnum(letter) == 0 && letter != '.'); }, '-');
  return words;
}

} // namespace

bool isSameRobot(const RunRobot& a, const RunRobot& b) {
  return !a.bodyId.empty() && !b.bodyId.empty() ? a.bodyId == b.bodyId : a.body == b.body;
}

std::string makeRunId(const Run& run) {
  return fmt::format("{:%Y-%m-%d_%H-%M-%S}_{}_{}", fmt::gmtime(run.time), plainWords(run.robot.body, 40),
                     plainWords(run.kind, 20));
}

std::string formatTime(RunTime time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(time));
}

std::string formatMinute(RunTime time) {
  return fmt::format("{:%Y-%m-%d %H:%M}", fmt::gmtime(time));
}

std::string formatDay(RunTime time) {
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(time));
}

std::optional<RunTime> parseTime(const std::string& text) {
  static const std::regex form{R"((\d{4})-(\d\d)-(\d\d)(?:[T ](\d\d):(\d\d)(?::(\d\d))?Z?)?)"};
  std::smatch parts;
  if (text.size() > 20 || !std::regex_match(text, parts, form)) {
    return std::nullopt;
  }
  const auto number = [&](std::size_t i) { return parts[i].matched ? std::stoi(parts[i].str()) : 0; };
  const std::chrono::year_month_day date{std::chrono::year{number(1)},
                                         std::chrono::month{static_cast<unsigned>(number(2))},
                                         std::chrono::day{static_cast<unsigned>(number(3))}};
  if (!date.ok() || number(1) < 1970 || number(4) > 23 || number(5) > 59 || number(6) > 59) {
    return std::nullopt;
  }
  return RunTime{std::chrono::sys_days{date}} + std::chrono::hours{number(4)} + std::chrono::minutes{number(5)} +
         std::chrono::seconds{number(6)};
}

RunTime presentTime() {
  return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
}

} // namespace naocal
