#pragma once

#include "hardware/v4l2/VideoSystem.hpp"

#include <cstdint>
#include <vector>

struct v4l2_buffer;

namespace naocal {

/// Buffers shared with a capture driver (mmap). Failures throw VideoError (VideoSystem.hpp).
class VideoBuffers {
public:
  /// Requests, maps and enqueues buffers.
  VideoBuffers(VideoSystem& system, int file, unsigned count);
  ~VideoBuffers();
  VideoBuffers(const VideoBuffers&) = delete;
  VideoBuffers& operator=(const VideoBuffers&) = delete;

  /// Dequeues a filled buffer; false if there is none.
  bool dequeue(v4l2_buffer& buffer);

  /// The buffer's bytes, valid until `enqueue`.
  std::span<const std::uint8_t> bytes(const v4l2_buffer& buffer) const;

  /// Returns the buffer to the driver; retries once.
  void enqueue(v4l2_buffer& buffer);

private:
  void release();

  VideoSystem& system_;
  int file_;
  struct Memory {
    void* begin;
    std::size_t length;
  };
  std::vector<Memory> memory_;
};

} // namespace naocal
