#include "failures/FailingSystem.hpp"
#include "failures/ReadFiles.hpp"
#include "io/InputError.hpp"

#include <catch2/catch.hpp>
#include <optional>

namespace naocal {
namespace {

using failing::ReadFailure;

/// What is read where the `number`-th call of `read` fails; absent: refused. `reached`: whether there was such a call.
std::optional<std::string> readFailing(const ReadFiles::Named& file, std::size_t number, ReadFailure how,
                                       std::string& sentence, bool& reached) {
  const failing::Read failure{number, how};
  std::optional<std::string> content;
  try {
    content = file.read();
  } catch (const InputError& error) {
    sentence = error.what();
  }
  reached = failing::Read::hasFailed();
  return content;
}

} // namespace

TEST_CASE("a file whose disk fails is refused in one sentence, whichever call fails") {
  // Proves it for every call of `read`, one after the other, until a run has none left to fail. Any exception but an
  // InputError fails the test.
  ReadFiles files;
  for (const ReadFiles::Named& file : files.all) {
    INFO(file.name);
    bool reached = true;
    for (std::size_t number = 1; reached; ++number) {
      std::string sentence;
      const auto content = readFailing(file, number, ReadFailure::error, sentence, reached);
      REQUIRE(content.has_value() != reached);
      REQUIRE((!reached || sentence.find("cannot be read: Input/output error") != std::string::npos));
      REQUIRE((number > 1 || reached));
    }
  }
  CHECK(files.isCopyWhole());
}

TEST_CASE("a file whose reads are short or interrupted is read as a whole") {
  // Proves it for every call of `read`: one byte instead of all, and a signal before the first byte.
  ReadFiles files;
  for (const ReadFiles::Named& file : files.all) {
    INFO(file.name);
    const std::string whole = file.read();
    for (const ReadFailure how : {ReadFailure::shortRead, ReadFailure::interrupted}) {
      bool reached = true;
      for (std::size_t number = 1; reached; ++number) {
        std::string sentence;
        REQUIRE(readFailing(file, number, how, sentence, reached) == whole);
      }
    }
  }
}

} // namespace naocal
