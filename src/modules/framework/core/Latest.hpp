#pragma once

#include <array>
#include <atomic>
#include <utility>

namespace naocal {

/// The newest value from one writing thread to one reading thread; older ones that nobody read are lost.
///
/// Three places: one belongs to the writer, one to the reader, one waits between them. Neither side ever waits.
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

  /// The newest value if it has not been taken before (reading thread only); it may be moved from and stays until the
  /// next call. nullptr: nothing new.
  T* take() const {
    if ((between_.load(std::memory_order_relaxed) & fresh) == 0) {
      return nullptr;
    }
    readers_ = between_.exchange(readers_, std::memory_order_acq_rel) & index;
    return &places_[readers_];
  }

private:
  static constexpr unsigned char fresh = 4, index = 3;

  // Taking is the reader's business and no change of the production that it depends on.
  mutable std::array<T, 3> places_{};
  mutable std::atomic<unsigned char> between_{1};
  mutable unsigned char readers_ = 2;
  unsigned char writers_ = 0;
};

} // namespace naocal
