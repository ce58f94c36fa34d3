#include "TemporaryFolder.hpp"
#include "fuzz/driver/BoundedRead.hpp"
#include "fuzz/driver/Mutation.hpp"
#include "io/Files.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <fstream>

// Every test proves that a reader accepts its seeds, and that it accepts or refuses, in the documented way, everything
// else in its corpus and 2000 random changes (100 where each costs a fit): no other exception, no crash, no more than
// its time (2 s; 20 s of fits) and 512 MiB. Changes are the same in every run. toolchain/fuzz searches for longer, led
// by coverage.

namespace naocal {
namespace {

const Reader& readerOf(const std::string& name) {
  const auto& all = Reader::all();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Reader* reader) { return reader->name() == name; });
  REQUIRE(found != all.end());
  return **found;
}

/// The files of a reader's corpus, sorted by name. Those that SeedCorpus.cpp writes are named seed-*.
std::vector<std::filesystem::path> corpusOf(const std::string& name) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator{std::filesystem::path{NAOCAL_SOURCE_DIR} / "tests/fuzz/corpus" / name}) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Reads the files of a corpus. The reader must accept its seeds: else nothing beyond what refuses them is tested.
std::vector<std::string> readCorpus(const Reader& reader) {
  std::vector<std::string> inputs;
  for (const auto& file : corpusOf(reader.name())) {
    inputs.push_back(readFile(file));
    if (file.filename().string().starts_with("seed-")) {
      INFO(file);
      CHECK_NOTHROW(reader.read(inputs.back()));
    }
  }
  return inputs;
}

/// Keeps the input that is being read in a file, so that it survives a crash; deletes the file at the end.
class KeptInput {
public:
  explicit KeptInput(const std::string& name) : file_{std::filesystem::temp_directory_path() / ("failed-" + name)} {}
  ~KeptInput() {
    if (!isFault_) {
      std::filesystem::remove(file_);
    }
  }
  void keep(const std::string& input) const {
    std::ofstream{file_, std::ios::binary | std::ios::trunc}.write(input.data(), std::streamsize(input.size()));
  }
  void markFault() { isFault_ = true; }
  const std::filesystem::path& file() const { return file_; }

private:
  std::filesystem::path file_;
  bool isFault_ = false;
};

void replay(const std::string& name, int mutationCount = 2000) {
  const Reader& reader = readerOf(name);
  const std::vector<std::string> corpus = readCorpus(reader);
  REQUIRE(!corpus.empty());
  KeptInput kept{name};
  std::mt19937_64 random{1};
  for (std::size_t i = 0; i < corpus.size() + mutationCount; ++i) {
    const std::string input = i < corpus.size() ? corpus[i] : mutate(corpus, random);
    kept.keep(input);
    if (const auto fault = findFault(reader, input)) {
      kept.markFault();
      FAIL(fmt::format("{}: {}; the input is in {}", name, *fault, kept.file().string()));
    }
  }
  SUCCEED();
}

} // namespace

TEST_CASE("random bytes as a capture set are read or refused") {
  replay("capture-set");
}
TEST_CASE("random bytes as a result are read or refused") {
  replay("result");
}
TEST_CASE("random bytes as a session are read or refused") {
  replay("session");
}
TEST_CASE("random bytes as a model file are read or refused") {
  replay("model");
}
TEST_CASE("random text as a correction is evaluated or refused") {
  replay("expression");
}
TEST_CASE("random bytes as poses are read or refused") {
  replay("poses");
}
TEST_CASE("random bytes as layers of a configuration are read or refused") {
  replay("configuration");
}
TEST_CASE("random bytes as a robot's drawing are read or refused") {
  replay("drawing");
}
TEST_CASE("random bytes as a scene of a simulated robot are read or refused") {
  replay("scene");
}
TEST_CASE("random bytes as a URDF are read or refused") {
  replay("urdf");
}
TEST_CASE("random bytes as a table of readings are read or refused") {
  replay("table");
}
TEST_CASE("random bytes as a recording of ROS 2 are read or refused") {
  replay("mcap");
}
TEST_CASE("random bytes as a camera's calibration are read or refused") {
  replay("camera-model");
}
TEST_CASE("random bytes as files of other teams are read or refused") {
  replay("dialects");
}
TEST_CASE("random bytes as another team's file of a head are read or refused") {
  replay("heads");
}
TEST_CASE("random bytes of a debug client are answered or end its connection") {
  replay("debug-frames");
}
TEST_CASE("random bytes of a configuration client are answered or end its connection") {
  replay("config-frames");
}
TEST_CASE("random bytes of the robot's hardware service are taken or end the connection") {
  replay("lola");
}
TEST_CASE("random messages of a panel are answered or refused") {
  replay("panel");
}
TEST_CASE("random changes of a model by a panel are made or refused") {
  replay("analysis", 100);
}
TEST_CASE("random requests to the bridge are answered or closed") {
  replay("http");
}
TEST_CASE("random bytes as a picture are decoded or refused") {
  replay("picture");
}

} // namespace naocal
