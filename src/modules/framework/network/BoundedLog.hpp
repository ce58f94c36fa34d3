#pragma once

#include "framework/core/Clock.hpp"
#include "framework/network/Peer.hpp"

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace naocal {

/// Limits what clients can make the robot write into its log. A sentence's subject is the text before its first colon
/// and space, such as "Client 10.1.24.7". Not thread-safe.
class BoundedLog {
public:
  static constexpr int burst = 20;                    // sentences of one subject
  static constexpr std::chrono::minutes refill{1};    // then one per minute
  static constexpr std::size_t mostSubjects = 100;    // further ones count as one
  static constexpr std::size_t longestSentence = 500; // [bytes]; longer ones are cut

  explicit BoundedLog(
      Log log, std::function<TimePoint()> now = [] { return Clock::now(); });

  /// Writes a sentence with control characters escaped. Drops it if its subject has no sentence left, which is written
  /// once.
  void operator()(std::string_view sentence);

private:
  struct Budget {
    double left = burst; // sentences
    TimePoint time;      // of the last refill
    bool isSpent = false;
  };
  Budget& budgetOf(std::string& subject, TimePoint now); // replaces `subject` beyond `mostSubjects`

  Log log_;
  std::function<TimePoint()> now_;
  std::map<std::string, Budget> budgets_; // by subject
};

} // namespace naocal
