#pragma once

#include "framework/core/Clock.hpp"

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <type_traits>
#include <utility>

namespace naocal {

/// Linear interpolation: `fraction` 0 gives `from`, 1 gives `to`. The customisation point of History: types with + - *
/// use this template, others declare an overload in their own namespace.
template <class T>
requires requires(const T& a) {
  T(a + (a - a) * 0.5);
}
T interpolate(const T& from, const T& to, double fraction) {
  return T(from + (to - from) * fraction);
}

/// Ring buffer of the last `Capacity` timestamped values; one writing thread, any number of reading threads.
///
/// The writer is wait-free (it overwrites the oldest entry); a reader retries if its entry is overwritten while it
/// reads. Each entry is a seqlock whose words are atomics; an odd sequence marks a write in progress. See Boehm, "Can
/// seqlocks get along with programming language memory models?" (2012).
template <class T, std::size_t Capacity = 256> class History {
  static_assert(std::is_trivially_copyable_v<T>, "a history copies its values word by word between threads");
  static_assert(Capacity >= 4);

public:
  struct Entry {
    TimePoint time;
    T value;
  };

  History() = default;
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  /// Adds a value (writing thread only). Returns false, and drops the value, unless it is newer than the newest entry.
  bool push(TimePoint time, const T& value) {
    if (count_.load(std::memory_order_relaxed) > 0 && time <= newestTime_) {
      return false;
    }
    newestTime_ = time;
    const std::uint64_t index = count_.load(std::memory_order_relaxed);
    slots_[index % Capacity].write(index, Entry{time, value});
    count_.store(index + 1, std::memory_order_release);
    return true;
  }

  /// The newest entry; absent if the history is empty.
  std::optional<Entry> newest() const {
    for (;;) {
      const std::uint64_t count = count_.load(std::memory_order_acquire);
      if (count == 0) {
        return std::nullopt;
      }
      if (const auto entry = read(count - 1)) {
        return entry;
      }
    }
  }

  /// The value at a time, interpolated between its neighbours; absent outside the time span of the entries.
  std::optional<T> at(TimePoint time) const {
    for (;;) {
      const std::uint64_t count = count_.load(std::memory_order_acquire);
      if (count == 0) {
        return std::nullopt;
      }
      if (const auto answer = search(count, time)) {
        return answer->value;
      }
    }
  }

  /// Calls `visit` for each entry from `first` to `last`, newest first; stops at an entry that was overwritten.
  template <class Visit> void visit(TimePoint first, TimePoint last, Visit&& visit) const {
    for (std::uint64_t index = count_.load(std::memory_order_acquire); index > 0; --index) {
      const auto entry = read(index - 1);
      if (!entry || entry->time < first) {
        return;
      }
      if (entry->time <= last) {
        visit(*entry);
      }
    }
  }

private:
  static constexpr std::size_t words = (sizeof(Entry) + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t);

  struct Answer {
    std::optional<T> value;
  };

  struct Slot {
    std::atomic<std::uint64_t> sequence{0}; // 2 index + 2 when entry `index` is complete; odd during a write
    std::array<std::atomic<std::uint64_t>, words> content{};

    void write(std::uint64_t index, const Entry& entry) {
      std::array<std::uint64_t, words> copy{};
      std::memcpy(copy.data(), static_cast<const void*>(&entry), sizeof(Entry));
      sequence.store(2 * index + 1, std::memory_order_relaxed);
      for (std::size_t i = 0; i < words; ++i) {
        content[i].store(copy[i], std::memory_order_release); // not before the odd sequence is stored
      }
      sequence.store(2 * index + 2, std::memory_order_release);
    }
  };

  /// Entry `index`, unless it has been overwritten.
  std::optional<Entry> read(std::uint64_t index) const {
    const Slot& slot = slots_[index % Capacity];
    const std::uint64_t expected = 2 * index + 2;
    if (slot.sequence.load(std::memory_order_acquire) != expected) {
      return std::nullopt;
    }
    std::array<std::uint64_t, words> copy;
    for (std::size_t i = 0; i < words; ++i) {
      copy[i] = slot.content[i].load(std::memory_order_acquire); // before the sequence is loaded again
    }
    if (slot.sequence.load(std::memory_order_relaxed) != expected) {
      return std::nullopt;
    }
    std::array<std::byte, sizeof(Entry)> bytes;
    std::memcpy(bytes.data(), copy.data(), sizeof(Entry));
    return std::bit_cast<Entry>(bytes);
  }

  /// Binary search in the first `count` entries; absent if an entry it needed was overwritten meanwhile.
  std::optional<Answer> search(std::uint64_t count, TimePoint time) const {
    // The oldest entry is excluded: the writer overwrites its slot next.
    std::uint64_t low = count > Capacity - 1 ? count - (Capacity - 1) : 0;
    std::uint64_t high = count - 1;
    auto from = read(low);
    auto to = read(high);
    if (!from || !to) {
      return std::nullopt;
    }
    if (time < from->time || time > to->time) {
      return Answer{};
    }
    while (high - low > 1) {
      const std::uint64_t middle = low + (high - low) / 2;
      const auto entry = read(middle);
      if (!entry) {
        return std::nullopt;
      }
      (entry->time <= time ? low : high) = middle;
      (entry->time <= time ? from : to) = entry;
    }
    if (time == from->time || time == to->time) {
      return Answer{time == from->time ? from->value : to->value};
    }
    return Answer{interpolate(from->value, to->value, toSeconds(time - from->time) / toSeconds(to->time - from->time))};
  }

  std::array<Slot, Capacity> slots_;
  std::atomic<std::uint64_t> count_{0};
  TimePoint newestTime_; // used by the writer only
};

} // namespace naocal
