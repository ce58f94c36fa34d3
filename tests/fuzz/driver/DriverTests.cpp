#include "fuzz/driver/BoundedRead.hpp"
#include "fuzz/driver/Mutation.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace naocal {
namespace {

const Reader refusing{"refusing", [](std::string_view) { throw InputError{"expected a, found b"}; }};
const Reader silent{"silent", [](std::string_view) { throw InputError{""}; }};
const Reader throwing{"throwing", [](std::string_view bytes) { static_cast<void>(std::string{bytes}.at(1)); }};
const Reader exhausted{"exhausted", [](std::string_view) { throw std::bad_alloc{}; }};
void* (*volatile fill)(void*, int, std::size_t) = std::memset; // else the compiler leaves out memory that nobody reads
const Reader growing{"growing", [](std::string_view) {
                       constexpr std::size_t size = 64 << 20;
                       fill(std::make_unique_for_overwrite<char[]>(size).get(), 'x', size);
                     }};
const Reader endless{"endless", [](std::string_view bytes) {
                       for (volatile bool ends = bytes.empty(); !ends;) {
                       }
                     }};

} // namespace

TEST_CASE("a reader that throws something else than an InputError, or needs much memory, is found out") {
  // Proves that the tests of readers can fail: each kind of fault gets its sentence, and a plain refusal gets none.
  CHECK(!findFault(refusing, "x"));
  CHECK(!findFault(throwing, "xx"));
  CHECK(findFault(silent, "x") == "expected a sentence about what is wrong with the input, found none");
  CHECK_THAT(findFault(throwing, "x").value_or(""), Catch::Contains("InputError, found std::out_of_range"));
  CHECK_THAT(findFault(exhausted, "x").value_or(""), Catch::Contains("found std::bad_alloc"));
  CHECK_THAT(findFault(growing, "x", 32).value_or(""), Catch::Contains("expected at most 32 MiB more memory"));
}

TEST_CASE("a reader that does not end is ended after two seconds of processor time", "[slow]") {
  // Proves it for a busy loop, in a child process; not for a reader that sleeps, which takes a minute.
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGABRT, SIG_DFL); // not Catch2's
    findFault(endless, "x");
    ::_exit(0);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  CHECK((WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT));
}

TEST_CASE("random changes of inputs are the same in every run and bounded in size") {
  // Proves reproducibility by the generator's state and the bound; how well the changes find faults is not tested.
  const std::vector<std::string> inputs{"{\"a\": [1, 2.5]}", std::string(largestInput, '7'), ""};
  std::mt19937_64 one{1}, same{1};
  int changed = 0;
  for (int i = 0; i < 300; ++i) {
    const std::string text = mutate(inputs, one);
    REQUIRE(text == mutate(inputs, same));
    REQUIRE(text.size() <= largestInput);
    changed += std::find(inputs.begin(), inputs.end(), text) == inputs.end();
  }
  CHECK(changed > 200);
}

} // namespace naocal
