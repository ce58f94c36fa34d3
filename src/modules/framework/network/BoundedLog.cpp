#include "framework/network/BoundedLog.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace naocal {
namespace {

constexpr const char* otherSubjects = "Further clients";

/// Start of a sentence up to its first colon and space.
std::string subjectOf(std::string_view sentence) {
  return std::string{sentence.substr(0, std::min(sentence.find(": "), BoundedLog::longestSentence))};
}

/// What follows the subject, without what was found and further details: clients choose these.
std::string causeOf(std::string_view sentence) {
  const std::size_t colon = sentence.find(": ");
  const std::string_view said = colon == std::string_view::npos ? sentence : sentence.substr(colon + 2);
  return std::string{said.substr(0, std::min({said.find(": "), said.find(", found"), BoundedLog::longestCause}))};
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

void BoundedLog::Budget::refillUntil(TimePoint now) {
  left = std::min<double>(burst, left + toSeconds(now - time) / toSeconds(refill));
  time = now;
}

BoundedLog::Budget& BoundedLog::budgetOf(std::string& subject, TimePoint now) {
  if (budgets_.size() >= mostSubjects && !budgets_.contains(subject)) {
    for (auto& [who, budget] : budgets_) {
      budget.refillUntil(now);
    }
    std::erase_if(budgets_, [](const auto& entry) { return entry.second.left >= burst; });
    if (budgets_.size() >= mostSubjects) {
      subject = otherSubjects;
    }
  }
  Budget& budget = budgets_.try_emplace(subject, Budget{burst, now, false, {}}).first->second;
  budget.refillUntil(now);
  return budget;
}

void BoundedLog::operator()(std::string_view sentence) {
  const TimePoint now = now_();
  std::string subject = subjectOf(sentence);
  const std::string cause = causeOf(sentence);
  Budget& budget = budgetOf(subject, now);
  const auto known = budget.causes.find(cause);
  if (known != budget.causes.end() && now - known->second.written < repeat) {
    ++known->second.leftOut;
    return;
  }
  if (budget.left >= 1) {
    std::erase_if(budget.causes, [&](const auto& entry) { return now - entry.second.written >= 2 * repeat; });
    budget.isSpent = budget.isSpent && budget.left < burst;
    budget.left -= 1;
    const std::size_t leftOut = std::exchange(budget.causes[cause], {now}).leftOut;
    log_(oneLine(sentence) +
         (leftOut == 0 ? "" : fmt::format(" ({} like it were left out since the last one.)", leftOut)));
  } else if (!std::exchange(budget.isSpent, true)) {
    log_(oneLine(subject + ": further sentences about it are left out, but for one a minute."));
  }
}

} // namespace naocal
