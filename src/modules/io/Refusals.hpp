#pragma once

#include "io/InputError.hpp"

#include <string>
#include <utility>
#include <vector>

namespace naocal {

/// Treatment of refused places while a document is read: the first one ends reading (an InputError), or all are
/// collected and reading goes on after each.
class Refusals {
public:
  enum class Treatment { throwFirst, collect };

  explicit Refusals(Treatment treatment = Treatment::throwFirst) : treatment_{treatment} {}

  bool isCollecting() const { return treatment_ == Treatment::collect; }

  /// Reads a part of the document; false if it was refused.
  template <typename Read> bool attempt(Read&& read) {
    if (!isCollecting()) {
      std::forward<Read>(read)();
      return true;
    }
    try {
      std::forward<Read>(read)();
      return true;
    } catch (const InputError& error) {
      sentences_.emplace_back(error.what());
      return false;
    }
  }

  /// One sentence per refused place, in reading order.
  const std::vector<std::string>& sentences() const { return sentences_; }

private:
  Treatment treatment_;
  std::vector<std::string> sentences_;
};

} // namespace naocal
