#include "io/Files.hpp"

#include "../Skipped.hpp"
#include "../TemporaryFolder.hpp"
#include "data/CaptureSetFile.hpp"
#include "data/GoodSet.hpp"
#include "io/InputError.hpp"

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
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

TEST_CASE("only regular files are read, and nothing is waited for") {
  // Proves it for a pipe without a writer, for a link to it, and for an endless and an empty device. Without the check
  // the first one hangs. A pipe that nobody reads is not written to, either.
  const TemporaryFolder folder;
  const fs::path pipe = folder.path() / "pipe", link = folder.path() / "link";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  fs::create_symlink(pipe, link);
  for (const fs::path& file : {pipe, link}) {
    CHECK_THROWS_WITH(readFile(file), file.string() + ": expected a file, found a pipe; copy its content into a file "
                                                      "first");
  }
  for (const char* device : {"/dev/zero", "/dev/null"}) {
    CHECK_THROWS_WITH(readFile(device), Catch::Contains("expected a file, found a device"));
  }
  CHECK_THROWS_WITH(writeAtomically(pipe, "content"), Catch::Contains("it is a pipe that nobody reads"));
}

TEST_CASE("a file of more bytes than are allowed is refused before it is read") {
  // Proves the boundary with a small limit, and the stated limit with a file that takes no space on the disk.
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "file";
  writeAtomically(file, "0123456789");
  CHECK(readFile(file, 10) == "0123456789");
  CHECK_THROWS_WITH(readFile(file, 9), Catch::EndsWith("expected at most 9 bytes in a file, found 10"));
  fs::resize_file(file, largestFile + 1);
  CHECK_THROWS_WITH(readFile(file), Catch::Contains("expected at most 1073741824 bytes in a file, found 1073741825"));
}

TEST_CASE("a read error is told as one") {
  // Proves it for a file of the system that can be opened and not read (EIO); its size is not known before.
  CHECK_THROWS_WITH(readFile("/proc/self/mem"),
                    "/proc/self/mem: cannot be read: Input/output error; check the path and "
                    "its permissions");
  CHECK(readFile("/proc/self/comm").starts_with("test_io"));
}

TEST_CASE("memory that does not suffice for a file is told as such") {
  // Proves it with a limit on this process's memory; not with sanitizers, which end the process instead.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  skip("sanitizers do not throw when memory is exhausted");
  return;
#endif
#endif
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "file";
  writeAtomically(file, "");
  fs::resize_file(file, 512 << 20);
  std::ifstream statm{"/proc/self/statm"};
  rlim_t pages = 0;
  statm >> pages;
  rlimit before{};
  REQUIRE(::getrlimit(RLIMIT_AS, &before) == 0);
  const rlimit small{pages * rlim_t(::sysconf(_SC_PAGESIZE)) + (64 << 20), before.rlim_max};
  std::string said;
  REQUIRE(::setrlimit(RLIMIT_AS, &small) == 0);
  try {
    readFile(file);
  } catch (const InputError& error) {
    said = error.what();
  }
  REQUIRE(::setrlimit(RLIMIT_AS, &before) == 0);
  CHECK(said.find("its 536870912 bytes do not fit into the memory that is left") != std::string::npos);
}

TEST_CASE("a path inside a folder does not lead out of it") {
  // Proves it for dots, absolute paths, and links to files and folders outside; links within the folder are followed.
  const TemporaryFolder folder;
  const fs::path set = folder.path() / "set", images = set / "images";
  fs::create_directories(images);
  writeAtomically(folder.path() / "private", "secret");
  writeAtomically(images / "0.png", "picture");
  fs::create_symlink(folder.path() / "private", images / "out.png");
  fs::create_symlink(folder.path(), set / "up");
  fs::create_symlink("0.png", images / "within.png");
  const fs::path whole = fs::canonical(images / "0.png");
  CHECK(fileInside(set, "images/0.png") == whole);
  CHECK(fileInside(set, "images/within.png") == whole);
  CHECK(fileInside(set, "images/../images/0.png") == whole);
  CHECK(fileInside(set, "images/new.png") == fs::canonical(images) / "new.png");
  for (const char* path : {"images/out.png", "up/private", "../private", "images/../../private", "", ".", ".."}) {
    CAPTURE(path);
    CHECK_FALSE(fileInside(set, path));
  }
  CHECK_FALSE(fileInside(set, folder.path() / "private"));
  CHECK_FALSE(fileInside(set, whole));
}

TEST_CASE("what a killed writer left is removed, and nothing else") {
  // Proves it for temporary files in nested folders and for one file's; one that another process is writing (locked)
  // stays, as do files with similar names.
  const TemporaryFolder folder;
  const fs::path deep = folder.path() / "location" / "default";
  fs::create_directories(deep);
  const fs::path left = deep / ".Projection.json.1f3a.part", own = folder.path() / ".result.json.77.part";
  const fs::path others[] = {deep / "notes.part", deep / ".part", deep / ".notes.txt.part", deep / ".a.12.part.json"};
  const fs::path busy = deep / ".Counter.json.abc.part";
  for (const fs::path& file : {left, own, others[0], others[1], others[2], others[3], busy}) {
    std::ofstream{file} << "half";
  }
  const int writing = ::open(busy.c_str(), O_WRONLY);
  REQUIRE(::flock(writing, LOCK_EX) == 0);
  removeAbandonedWritesOf(folder.path() / "other.json");
  CHECK(fs::exists(own));
  removeAbandonedWritesOf(folder.path() / "result.json");
  CHECK_FALSE(fs::exists(own));
  CHECK(fs::exists(left));
  removeAbandonedWrites(folder.path());
  CHECK_FALSE(fs::exists(left));
  CHECK(fs::exists(busy));
  for (const fs::path& file : others) {
    CHECK(fs::exists(file));
  }
  ::close(writing);
  removeAbandonedWrites(folder.path());
  CHECK_FALSE(fs::exists(busy));
  removeAbandonedWrites(folder.path() / "nothing");
}

TEST_CASE("a writer that is killed leaves a file that the next start removes") {
  // Proves it with a process that writes a file again and again: while it lives, removing takes nothing from it; after
  // it was killed, only the whole file remains.
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "file";
  int told[2];
  REQUIRE(::pipe(told) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    ::close(told[0]); // ends with SIGPIPE if the test ends early
    for (const std::string content(1 << 20, 'x');;) {
      writeAtomically(file, content);
      static_cast<void>(!::write(told[1], "x", 1));
    }
  }
  char byte = 0;
  for (int writes = 0; writes < 3; ++writes) {
    REQUIRE(::read(told[0], &byte, 1) == 1);
  }
  removeAbandonedWrites(folder.path()); // the writer goes on
  REQUIRE(::read(told[0], &byte, 1) == 1);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  removeAbandonedWrites(folder.path());
  CHECK(entries(folder.path()) == 1);
  CHECK(readFile(file).size() == 1 << 20);
  ::close(told[0]);
  ::close(told[1]);
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
