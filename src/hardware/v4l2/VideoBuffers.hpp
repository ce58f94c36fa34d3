#pragma once

#include "hardware/v4l2/VideoSystem.hpp"

#include <cstdint>
#include <vector>

struct v4l2_buffer;

namespace naocal {

/// Memory that a capture driver and this program share. What fails throws VideoError (VideoDevice.hpp).
class VideoBuffers {
public:
  /// Asks the driver for so many, maps them and gives them to it.
  VideoBuffers(VideoSystem& system, int file, unsigned count);
  ~VideoBuffers();
  VideoBuffers(const VideoBuffers&) = delete;
  VideoBuffers& operator=(const VideoBuffers&) = delete;

  /// Takes a filled buffer from the driver; false when there is none.
  bool dequeue(v4l2_buffer& buffer);

  /// Its bytes, until it is given back.
  std::span<const std::uint8_t> bytes(const v4l2_buffer& buffer) const;

  /// Gives it back; a driver that refuses once is asked twice.
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
