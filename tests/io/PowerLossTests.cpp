#include "PowerLoss.hpp"

#include "TemporaryFolder.hpp"
#include "io/Files.hpp"
#include "io/Folders.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

/// Contents of a file in all states after a number of requests; nothing: it is not there.
std::set<std::optional<std::string>> contentsOf(const std::string& file, const PowerLoss& failure,
                                                std::size_t requests) {
  std::set<std::optional<std::string>> contents;
  for (const PowerLoss::State& state : failure.statesAfter(requests)) {
    const auto found = state.find(file);
    contents.insert(found == state.end() ? std::nullopt : found->second);
  }
  return contents;
}

/// The same after any number of requests.
std::set<std::optional<std::string>> contentsOf(const std::string& file, const PowerLoss& failure) {
  std::set<std::optional<std::string>> contents;
  for (std::size_t requests = 0; requests <= failure.requests(); ++requests) {
    contents.merge(contentsOf(file, failure, requests));
  }
  return contents;
}

/// Writes a file without or with fsync of file and folder, and renames it, as many programs do.
void writeCarelessly(const std::filesystem::path& file, const std::string& content, bool syncsFile) {
  const std::string part = file.string() + ".new";
  const int number = ::open(part.c_str(), O_WRONLY | O_CREAT, 0600);
  REQUIRE(::write(number, content.data(), content.size()) == ssize_t(content.size()));
  if (syncsFile) {
    ::fsync(number);
  }
  ::close(number);
  ::rename(part.c_str(), file.c_str());
}

using Contents = std::set<std::optional<std::string>>;

} // namespace

TEST_CASE("after a power failure at any moment a written file is the old one or the new one") {
  // Proves it for a new and a replaced file, in all states of the disk that POSIX allows: with writes and names lost
  // and reordered. Once the function has returned, the new file is there in all of them.
  const TemporaryFolder folder;
  const PowerLoss first{folder.path(), [&] { writeAtomically(folder.path() / "file", "old content"); }};
  CHECK(first.requests() == 5); // create, write, fsync, rename, fsync of the folder
  CHECK(contentsOf("file", first) == Contents{std::nullopt, "old content"});
  CHECK(contentsOf("file", first, first.requests()) == Contents{"old content"});
  const PowerLoss second{folder.path(), [&] { writeAtomically(folder.path() / "file", "new content"); }};
  CHECK(contentsOf("file", second) == Contents{"old content", "new content"});
  CHECK(contentsOf("file", second, second.requests()) == Contents{"new content"});
}

TEST_CASE("after a power failure a file in a new folder is there") {
  // Proves it for two new folders, one in the other.
  const TemporaryFolder folder;
  const PowerLoss failure{folder.path(), [&] {
                            createFolders(folder.path() / "one" / "two" / "");
                            writeAtomically(folder.path() / "one/two/file", "content");
                          }};
  CHECK(contentsOf("one/two/file", failure, failure.requests()) == Contents{"content"});
  createFolders(folder.path() / "one/two");
  CHECK_THROWS_AS(createFolders(folder.path() / "one/two/file/three"), std::filesystem::filesystem_error);
}

TEST_CASE("a simulated power failure finds what careless programs lose") {
  // Proves that these tests can fail: without fsync of the file it may be empty, a half or zeros, without fsync of its
  // folder it may be lost after all, and so may a file in a folder whose own name was not made durable.
  const TemporaryFolder folder;
  const auto file = folder.path() / "file";
  const PowerLoss unsynced{folder.path(), [&] { writeCarelessly(file, "12345678", false); }};
  CHECK(contentsOf("file", unsynced, unsynced.requests()) ==
        Contents{std::nullopt, "", "1234", std::string(8, '\0'), "12345678"});
  std::filesystem::remove(file);
  const PowerLoss unnamed{folder.path(), [&] { writeCarelessly(file, "12345678", true); }};
  CHECK(contentsOf("file", unnamed, unnamed.requests()) == Contents{std::nullopt, "12345678"});
  const PowerLoss lost{folder.path(), [&] {
                         std::filesystem::create_directories(folder.path() / "new");
                         writeAtomically(folder.path() / "new" / "file", "content");
                       }};
  CHECK(contentsOf("new/file", lost, lost.requests()) == Contents{std::nullopt, "content"});
}

} // namespace naocal
