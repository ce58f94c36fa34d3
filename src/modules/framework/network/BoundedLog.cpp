#include "framework/network/BoundedLog.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace naocal {
namespace {

constexpr const char* otherSubjects = "Further clients";

std::string subjectOf(std::string_view sentence) {
  return std::string{sentence.substr(0, std::min(sentence.find(": "), BoundedLog::longestSentence))};
}

/// One line of at most `longestSentence` bytes; control characters become \xNN.
std::string oneLine(std::string_view sentence) {
  std::string line;
  for (const char letter : sentence.substr(0, BoundedLog::longestSentence)) {
    const auto byte = static_cast<unsigned char>(letter);
    line += byte < 0x20 || byte == 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(1, letter);
  }
  return sentence.size() > BoundedLog::longestSentence ? line + "..." : line;
}

} // namespace

BoundedLog::BoundedLog(Log log, std::function<TimePoint()> now) : log_{std::move(log)}, now_{std::move(now)} {}

BoundedLog::Budget& BoundedLog::budgetOf(std::string& subject, TimePoint now) {
  for (auto& [who, budget] : budgets_) {
    budget.left = std::min<double>(burst, budget.left + toSeconds(now - budget.time) / toSeconds(refill));
    budget.time = now;
  }
  if (budgets_.size() >= mostSubjects && !budgets_.contains(subject)) {
    std::erase_if(budgets_, [](const auto& entry) { return entry.second.left >= burst; });
    if (budgets_.size() >= mostSubjects) {
      subject = otherSubjects;
    }
  }
  return budgets_.try_emplace(subject, Budget{burst, now}).first->second;
}

void BoundedLog::operator()(std::string_view sentence) {
  std::string subject = subjectOf(sentence);
  Budget& budget = budgetOf(subject, now_());
  if (budget.left >= 1) {
    budget.isSpent = budget.isSpent && budget.left < burst;
    budget.left -= 1;
    log_(oneLine(sentence));
  } else if (!std::exchange(budget.isSpent, true)) {
    log_(oneLine(subject + ": further sentences about it are left out, but for one a minute."));
  }
}

} // namespace naocal
