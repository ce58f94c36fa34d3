#include "fuzz/driver/BoundedRead.hpp"

#include "io/InputError.hpp"

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <cxxabi.h>
#include <fmt/format.h>
#include <memory>
#include <sys/resource.h>
#include <sys/time.h>
#include <typeinfo>
#include <unistd.h>

namespace naocal {
namespace {

long peakMemory() { // [MiB]
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

std::string tooSlow; // sentence about the present read

void abortSlowRead(int) { // async-signal-safe
  [[maybe_unused]] const ssize_t count = ::write(STDERR_FILENO, tooSlow.data(), tooSlow.size());
  std::abort();
}

/// Aborts the process unless it is destroyed in time. SIGALRM stays libFuzzer's.
class Deadline {
public:
  explicit Deadline(int longestRead) {
    tooSlow = fmt::format("a read takes longer than {} s of processor time, or {} s\n", longestRead, longestWait);
    struct sigaction action {};
    action.sa_handler = abortSlowRead;
    ::sigaction(SIGPROF, &action, nullptr);
    const itimerval limit{{}, {longestRead, 0}};
    ::setitimer(ITIMER_PROF, &limit, nullptr);
    if (!wall_) {
      sigevent event{};
      event.sigev_notify = SIGEV_SIGNAL;
      event.sigev_signo = SIGPROF;
      wall_.emplace();
      ::timer_create(CLOCK_MONOTONIC, &event, &*wall_);
    }
    const itimerspec wait{{}, {longestWait, 0}};
    ::timer_settime(*wall_, 0, &wait, nullptr);
  }
  ~Deadline() {
    const itimerval none{};
    ::setitimer(ITIMER_PROF, &none, nullptr);
    const itimerspec never{};
    ::timer_settime(*wall_, 0, &never, nullptr);
  }
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

private:
  static inline std::optional<timer_t> wall_;
};

std::string typeName(const std::exception& error) {
  const std::unique_ptr<char, decltype(&std::free)> name{
      abi::__cxa_demangle(typeid(error).name(), nullptr, nullptr, nullptr), &std::free};
  return name ? name.get() : typeid(error).name();
}

} // namespace

std::optional<std::string> findFault(const Reader& reader, std::string_view bytes, long growth) {
  const long before = peakMemory();
  try {
    const Deadline deadline{reader.longest()};
    reader.read(bytes);
  } catch (const InputError& error) {
    if (std::string_view{error.what()}.empty()) {
      return "expected a sentence about what is wrong with the input, found none";
    }
  } catch (const std::exception& error) {
    return fmt::format("expected an InputError, found {}: {}", typeName(error), error.what());
  }
  if (const long grown = peakMemory() - before; grown > growth) {
    return fmt::format("expected at most {} MiB more memory, found {}", growth, grown);
  }
  return std::nullopt;
}

} // namespace naocal
