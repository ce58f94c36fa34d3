#include "hardware/v4l2/VideoBuffers.hpp"

#include "hardware/v4l2/VideoSystem.hpp"

#include <cerrno>
#include <linux/videodev2.h>

namespace naocal {
namespace {

v4l2_buffer numbered(std::size_t index) {
  v4l2_buffer buffer{};
  buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = std::uint32_t(index);
  return buffer;
}

} // namespace

VideoBuffers::VideoBuffers(VideoSystem& system, int file, unsigned count) : system_{system}, file_{file} {
  v4l2_requestbuffers request{};
  request.count = count;
  request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  request.memory = V4L2_MEMORY_MMAP;
  checkCall(system_.ioctl(file_, VIDIOC_REQBUFS, &request), "it gives no buffers");
  try {
    for (std::size_t index = 0; index < request.count; ++index) {
      v4l2_buffer buffer = numbered(index);
      checkCall(system_.ioctl(file_, VIDIOC_QUERYBUF, &buffer), "it does not describe its buffers");
      void* const begin = system_.map(buffer.length, file_, long(buffer.m.offset));
      if (begin == nullptr) {
        throw VideoError{"its buffers cannot be mapped"};
      }
      memory_.push_back({begin, buffer.length});
      enqueue(buffer);
    }
  } catch (...) {
    release();
    throw;
  }
}

VideoBuffers::~VideoBuffers() {
  release();
}

void VideoBuffers::release() {
  for (const Memory& memory : memory_) {
    system_.unmap(memory.begin, memory.length);
  }
}

bool VideoBuffers::dequeue(v4l2_buffer& buffer) {
  buffer = numbered(0);
  const int result = system_.ioctl(file_, VIDIOC_DQBUF, &buffer);
  return result == -EAGAIN ? false : (checkCall(result, "it gives no picture"), true);
}

std::span<const std::uint8_t> VideoBuffers::bytes(const v4l2_buffer& buffer) const {
  if (buffer.index >= memory_.size() || buffer.bytesused > memory_[buffer.index].length) {
    return {};
  }
  return {static_cast<const std::uint8_t*>(memory_[buffer.index].begin), buffer.bytesused};
}

void VideoBuffers::enqueue(v4l2_buffer& buffer) {
  if (system_.ioctl(file_, VIDIOC_QBUF, &buffer) < 0) {
    checkCall(system_.ioctl(file_, VIDIOC_QBUF, &buffer), "it does not take its buffers back");
  }
}

} // namespace naocal
