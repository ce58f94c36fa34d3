#define CATCH_CONFIG_RUNNER
#include "Skipped.hpp"

/// Exit code: 0 if all tests passed, `skippedExitCode` if some were skipped and none failed, otherwise another.
int main(int count, char** arguments) {
  const int failures = Catch::Session{}.run(count, arguments);
  if (failures == 0) {
    return naocal::isSkipped() ? naocal::skippedExitCode : 0;
  }
  return failures == naocal::skippedExitCode ? 1 : failures;
}
