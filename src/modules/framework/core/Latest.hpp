#pragma once

#include <array>
#include <atomic>
#include <utility>

namespace naocal {

/// Triple buffer: passes the newest value from one writing thread to one reading thread; unread older values are lost.
///
/// One slot belongs to the writer, one to the reader, one holds the value in between. Wait-free on both sides.
template <class T> class Latest {
public:
  Latest() = default;
  Latest(const Latest&) = delete;
  Latest& operator=(const Latest&) = delete;

  /// Hands over a value (writing thread only).
  void write(T value) {
    places_[writers_] = std::move(value);
    writers_ = between_.exchange(static_cast<unsigned char>(writers_ | fresh), std::memory_order_acq_rel) & index;
  }

  /// The newest value, unless already taken (reading thread only); may be moved from; valid until the next call.
  /// nullptr if there is no new value.
  T* take() const {
    if ((between_.load(std::memory_order_relaxed) & fresh) == 0) {
      return nullptr;
    }
    readers_ = between_.exchange(readers_, std::memory_order_acq_rel) & index;
    return &places_[readers_];
  }

private:
  static constexpr unsigned char fresh = 4, index = 3;

  // Mutable: taking a value does not change the production that the reader depends on.
  mutable std::array<T, 3> places_{};
  mutable std::atomic<unsigned char> between_{1};
  mutable unsigned char readers_ = 2;
  unsigned char writers_ = 0;
};

} // namespace naocal
