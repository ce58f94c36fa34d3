#include "io/Files.hpp"

#include "../Skipped.hpp"
#include "../TemporaryFolder.hpp"
#include "data/CaptureSetFile.hpp"
#include "data/GoodSet.hpp"
#include "io/InputError.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace naocal {
namespace {

namespace fs = std::filesystem;

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator{folder}, {}));
}

} // namespace

TEST_CASE("a written file holds what was written and leaves nothing beside it") {
  // Proves it for a new and for a replaced file. Safety against power cuts cannot be tested here.
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "file";
  writeAtomically(file, "first");
  const std::string second("sec\0nd\n", 7);
  writeAtomically(file, second);
  CHECK(readFile(file) == second);
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("a replaced file keeps its permissions, and a link stays a link") {
  // Proves it for non-default permissions.
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "file", link = folder.path() / "link";
  writeAtomically(file, "first");
  fs::permissions(file, fs::perms::owner_all);
  fs::create_symlink("file", link);
  writeAtomically(link, "second");
  CHECK(readFile(file) == "second");
  CHECK(fs::status(file).permissions() == fs::perms::owner_all);
  CHECK(fs::is_symlink(link));
}

TEST_CASE("what cannot be written is refused and changes nothing") {
  // Proves it for a missing folder and for a target that is a non-empty folder, where the final rename fails.
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "file" / "inside");
  for (const fs::path& file : {folder.path() / "none" / "file", folder.path() / "file"}) {
    CHECK_THROWS_WITH(writeAtomically(file, "content"), Catch::StartsWith(file.string() + ": cannot be written"));
  }
  CHECK(entries(folder.path()) == 1);
  CHECK(entries(folder.path() / "file") == 1);
}

TEST_CASE("a file in a folder that must not be changed stays as it was") {
  // Proves it for a write-protected folder; skipped for root, who may write everywhere.
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "file";
  writeAtomically(file, "old");
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  if (::access(folder.path().c_str(), W_OK) == 0) {
    skip("this user may write into protected folders");
  } else {
    CHECK_THROWS_AS(writeAtomically(file, "new"), InputError);
    CHECK(readFile(file) == "old");
  }
  fs::permissions(folder.path(), fs::perms::owner_all);
}

TEST_CASE("a device is written to and not replaced") {
  // Proves it for /dev/null, which a rename would replace.
  writeAtomically("/dev/null", "content");
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("what cannot be read is refused by name") {
  // Proves it for a missing file and for a folder.
  const TemporaryFolder folder;
  const fs::path missing = folder.path() / "none";
  CHECK_THROWS_WITH(readFile(missing), Catch::StartsWith(missing.string()) && Catch::Contains("no such file"));
  CHECK_THROWS_WITH(readFile(folder.path()), Catch::Contains("a folder"));
  CHECK_THROWS_WITH(readCaptureSet(missing), Catch::StartsWith((missing / "captures.json").string()));
}

TEST_CASE("a set is written into a folder that is made for it and carries the folder's name") {
  // Proves it for nested folders, and that the name is independent of the path's spelling.
  const TemporaryFolder folder;
  const auto set = parseCaptureSet(goodSet().dump(), "set").set;
  const fs::path place = folder.path() / "many" / "night";
  writeCaptureSet(set, place);
  CHECK(readCaptureSet(place).set.name == "night");
  CHECK(readCaptureSet(place / "").set.name == "night");
  CHECK(readCaptureSet(place / ".." / "night" / ".").set.name == "night");
  CHECK(readFile(place / "captures.json") == formatCaptureSet(set));
  writeAtomically(folder.path() / "taken", "");
  CHECK_THROWS_AS(writeCaptureSet(set, folder.path() / "taken"), InputError);
}

TEST_CASE("a checksum is SHA-256") {
  // Proves it for two standard test vectors (FIPS 180-4: "" and "abc").
  CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

} // namespace naocal
