#pragma once

#include "framework/core/Clock.hpp"
#include "framework/network/Peer.hpp"

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace naocal {

/// Limits what clients can make the robot write into its log. A sentence is "Subject: cause, found this" or "Subject:
/// cause: details": its subject ends at the first colon and space, such as "Client 10.1.24.7", its cause at the next
/// ones or at ", found". The same cause of the same subject is written once an hour, with the number of sentences that
/// were left out; different causes draw on the subject's budget. Not thread-safe.
class BoundedLog {
public:
  static constexpr int burst = 20;                    // causes of one subject
  static constexpr std::chrono::minutes refill{1};    // then one per minute
  static constexpr std::chrono::hours repeat{1};      // the same cause again
  static constexpr std::size_t mostSubjects = 100;    // further ones count as one
  static constexpr std::size_t longestSentence = 500; // [bytes]; longer ones are cut
  static constexpr std::size_t longestCause = 100;    // [bytes]; what follows tells causes no more apart

  explicit BoundedLog(
      Log log, std::function<TimePoint()> now = [] { return Clock::now(); });

  /// Writes a sentence with control characters escaped, unless its cause was written within `repeat`. Drops it if its
  /// subject has no budget left, which is written once.
  void operator()(std::string_view sentence);

private:
  struct Cause {
    TimePoint written;
    std::size_t leftOut = 0; // sentences since then
  };
  struct Budget {
    double left = burst; // causes
    TimePoint time;      // of the last refill
    bool isSpent = false;
    std::map<std::string, Cause> causes; // written within the last two `repeat`; no more than the budget gives then
    void refillUntil(TimePoint now);
  };
  Budget& budgetOf(std::string& subject, TimePoint now); // replaces `subject` beyond `mostSubjects`

  Log log_;
  std::function<TimePoint()> now_;
  std::map<std::string, Budget> budgets_; // by subject
};

} // namespace naocal
