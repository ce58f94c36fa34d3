#include "io/Failure.hpp"

#include "io/InputError.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <new>
#include <stdexcept>

namespace naocal {
namespace {

constexpr char exhaustedMemory[] =
    "the memory is exhausted; end other programs, or use fewer captures or smaller pictures";

const char* programName = "";

/// std::terminate_handler; does not allocate where memory is exhausted.
[[noreturn]] void terminateWithSentence() {
  try {
    if (const std::exception_ptr error = std::current_exception()) {
      std::rethrow_exception(error);
    }
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "%s: %s\n", programName, exhaustedMemory);
    std::_Exit(2);
  } catch (const std::exception& error) {
    const Failure failure = describeFailure(error);
    std::fprintf(stderr, "%s: %s\n", programName, printableText(failure.sentence, longestSentence).c_str());
    std::_Exit(failure.exitCode);
  } catch (...) {
  }
  std::abort();
}

} // namespace

Failure describeFailure(const std::exception& error) {
  if (dynamic_cast<const InputError*>(&error) != nullptr) {
    return {2, error.what()};
  }
  if (const auto* refused = dynamic_cast<const std::filesystem::filesystem_error*>(&error)) {
    return {2, fmt::format("{}: the system refuses it: {}; choose another place or change its permissions",
                           refused->path1().string(), refused->code().message())};
  }
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    return {2, exhaustedMemory};
  }
  const std::string_view said = error.what();
  if (dynamic_cast<const std::domain_error*>(&error) != nullptr || said.find("boost::math") != said.npos) {
    return {2, "the numbers leave the range that can be computed; look for huge values in the captures, and in the "
               "corrections of effects that were given"};
  }
  return {1, fmt::format("internal error: {}", said)};
}

void endWithSentence(const char* program) {
  programName = program;
  std::set_terminate(terminateWithSentence);
}

} // namespace naocal
