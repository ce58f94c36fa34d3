#include "failures/FailingSystem.hpp"
#include "failures/ReadFiles.hpp"
#include "io/Failure.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <new>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace naocal {
namespace {

/// End of one read; in shared memory, so that the parent sees how far a child came.
struct Progress {
  std::size_t number = 1; // allocation that fails
  bool finished = false;  // no allocation was left to fail
  char fault[400] = "";   // what is wrong with the outcome; empty: nothing
};

/// Reads with failing allocations `progress.number`, then the next, until one succeeds. Stops at the first outcome that
/// is neither success nor the sentence about memory.
void readUntilSuccess(const ReadFiles::Named& file, bool onwards, Progress& progress) {
  for (; !progress.finished; ++progress.number) {
    try {
      const failing::Allocation failure{progress.number, onwards};
      file.read();
      progress.finished = !failing::Allocation::hasFailed();
    } catch (const std::exception& error) {
      const Failure told = describeFailure(error);
      if (told.exitCode != 2 || told.sentence.find("memory") == std::string::npos) {
        std::snprintf(progress.fault, sizeof progress.fault, "%s", told.sentence.c_str());
        return;
      }
    }
  }
}

/// The same in a child process, which the library's destructors may end (Failure.hpp); returns its exit code, or -1 if
/// a signal ended it. `said`: its standard error.
int readInChild(const ReadFiles::Named& file, bool onwards, Progress& progress, std::string& said) {
  const int output = ::memfd_create("stderr", MFD_CLOEXEC);
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(output, STDERR_FILENO);
    endWithSentence("test");
    readUntilSuccess(file, onwards, progress);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  said.resize(4000);
  said.resize(static_cast<std::size_t>(std::max<ssize_t>(0, ::pread(output, said.data(), said.size(), 0))));
  ::close(output);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Checks the outcome of every failing allocation.
void requireToldMemory(const ReadFiles::Named& file, bool onwards) {
  void* const shared = ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  REQUIRE(shared != MAP_FAILED);
  Progress& progress = *new (shared) Progress;
  while (!progress.finished) {
    std::string said;
    const int exitCode = readInChild(file, onwards, progress, said);
    INFO(file.name << ", allocation " << progress.number << ": " << said);
    REQUIRE(std::string{progress.fault}.empty());
    REQUIRE((exitCode == 0 || exitCode == 2));
    if (!progress.finished) {
      REQUIRE(said == "test: the memory is exhausted; end other programs, or use fewer captures or smaller pictures\n");
      ++progress.number;
    }
  }
  CHECK(progress.number > 2);
  ::munmap(shared, sizeof(Progress));
}

} // namespace

TEST_CASE("whichever allocation fails, a file is read or the exhausted memory is told in a sentence", "[slow]") {
  // Proves it for every allocation by `operator new`, one after the other, and for all from one on; `malloc` of the
  // picture libraries does not fail here, and leaks are not looked for. The JSON library's destructors allocate and
  // cannot throw: there the process ends with the same sentence.
  ReadFiles files;
  for (const ReadFiles::Named& file : files.all) {
    file.read(); // what is made once is made here
    requireToldMemory(file, false);
    requireToldMemory(file, true);
    CHECK(files.isCopyWhole());
  }
}

} // namespace naocal
