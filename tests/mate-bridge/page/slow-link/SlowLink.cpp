// Emulates a slow network between this network namespace and another one: two TUN devices with delay, loss and rate
// limit between them, as the kernel's netem where available. Runs until terminated.
// Usage: slow_link NAMESPACE DELAY_MS LOSS_PERCENT KBIT_PER_SECOND; devices: slow0 here, slow1 there.

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <fcntl.h>
#include <linux/if.h>
#include <linux/if_tun.h>
#include <poll.h>
#include <random>
#include <sched.h>
#include <stdexcept>
#include <string>
#include <sys/ioctl.h>
#include <unistd.h>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

int device(const char* name) {
  const int file = ::open("/dev/net/tun", O_RDWR | O_NONBLOCK);
  ifreq request{};
  request.ifr_flags = IFF_TUN | IFF_NO_PI;
  std::strncpy(request.ifr_name, name, IFNAMSIZ - 1);
  if (file < 0 || ::ioctl(file, TUNSETIFF, &request) < 0) {
    throw std::runtime_error{std::string{"slow_link: no TUN device "} + name + ": " + std::strerror(errno)};
  }
  return file;
}

/// One direction: a rate-limited queue, then a delay.
class Way {
public:
  Way(int from, int to, Clock::duration delay, double loss, double bytesPerSecond)
      : from_{from}, to_{to}, delay_{delay}, loss_{loss}, bytesPerSecond_{bytesPerSecond} {}

  void take() {
    std::array<char, 65536> bytes{};
    for (ssize_t size = 0; (size = ::read(from_, bytes.data(), bytes.size())) > 0;) {
      const auto now = Clock::now();
      free_ = std::max(free_, now);
      const std::chrono::duration<double> waiting = free_ - now;
      if (std::uniform_real_distribution{}(random_) < loss_ || waiting.count() * bytesPerSecond_ > longestQueue) {
        continue;
      }
      free_ +=
          std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>{double(size) / bytesPerSecond_});
      packets_.push_back({free_ + delay_, {bytes.begin(), bytes.begin() + size}});
    }
  }
  void deliver() {
    for (; !packets_.empty() && packets_.front().due <= Clock::now(); packets_.pop_front()) {
      [[maybe_unused]] const ssize_t sent = ::write(to_, packets_.front().bytes.data(), packets_.front().bytes.size());
    }
  }

private:
  static constexpr double longestQueue = 64e3; // a router's queue [bytes]; further packets are lost
  struct Packet {
    Clock::time_point due;
    std::vector<char> bytes;
  };
  int from_, to_;
  Clock::duration delay_;
  double loss_, bytesPerSecond_;
  std::deque<Packet> packets_;
  Clock::time_point free_;
  std::mt19937 random_{1};
};

} // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 5) {
      throw std::runtime_error{"slow_link: expected NAMESPACE DELAY_MS LOSS_PERCENT KBIT_PER_SECOND"};
    }
    const int here = device("slow0");
    const int other = ::open((std::string{"/run/netns/"} + argv[1]).c_str(), O_RDONLY);
    if (other < 0 || ::setns(other, CLONE_NEWNET) < 0) {
      throw std::runtime_error{std::string{"slow_link: cannot enter the namespace "} + argv[1]};
    }
    const int there = device("slow1");
    const auto delay = std::chrono::microseconds{static_cast<long>(1000 * std::atof(argv[2]))};
    const double loss = std::atof(argv[3]) / 100, rate = std::atof(argv[4]) * 1000 / 8;
    Way out{here, there, delay, loss, rate}, back{there, here, delay, loss, rate};
    std::puts("ready");
    std::fflush(stdout);
    std::array<pollfd, 2> files{pollfd{here, POLLIN, 0}, pollfd{there, POLLIN, 0}};
    for (;;) {
      ::poll(files.data(), files.size(), 1);
      out.take();
      back.take();
      out.deliver();
      back.deliver();
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
