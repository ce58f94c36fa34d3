#include "data/SetSearch.hpp"

#include "TemporaryFolder.hpp"
#include "io/Files.hpp"

#include <catch2/catch.hpp>

using Catch::Contains;

namespace naocal {

namespace {

namespace fs = std::filesystem;

/// A set of its own content, and its sum.
std::string writeSet(const fs::path& folder, const std::string& content) {
  fs::create_directories(folder);
  writeAtomically(folder / "captures.json", content);
  return sha256(content);
}

} // namespace

TEST_CASE("a set is found at its place, relative to the document or absolute, without a word") {
  // Proves both, and that the document's own folder is one.
  const TemporaryFolder temporary;
  const fs::path root = fs::canonical(temporary.path());
  const std::string sum = writeSet(root / "runs/captures", "a");
  const SetSearch search{root / "runs/result.json"};
  for (const std::string& place :
       {std::string{"captures"}, (root / "runs/captures").string(), std::string{"./captures/"}}) {
    const SoughtSet found = findSet({place, sum}, search);
    CHECK(found.folder == root / "runs/captures");
    CHECK(found.sentence.empty());
  }
  CHECK(findSet({".", sum}, {root / "runs/captures/result.json"}).folder == root / "runs/captures");
}

TEST_CASE("a set that was moved is found by its sum, near the document or in a folder that is named") {
  // Proves where it is searched, that a sentence tells the new place, that a set of the same name with other content
  // does not count, and that links to folders are not followed.
  const TemporaryFolder temporary;
  const fs::path root = fs::canonical(temporary.path());
  const std::string sum = writeSet(root / "work/moved/deep/set", "a");
  writeSet(root / "work/captures", "b");
  const SetSearch search{root / "work/result.json"};
  SoughtSet found = findSet({"captures", sum}, search);
  CHECK(found.folder == root / "work/moved/deep/set");
  CHECK_THAT(found.sentence, Contains("were moved") && Contains((root / "work/moved/deep/set").string()));

  fs::rename(root / "work/moved/deep/set", root / "neighbour");
  CHECK(findSet({"captures", sum}, search).folder == root / "neighbour");
  fs::create_directories(root / "far/away/from/it/all");
  fs::rename(root / "neighbour", root / "far/away/from/it/all/set");
  found = findSet({"captures", sum}, search);
  CHECK_FALSE(found.folder);
  CHECK(found.changed == root / "work/captures");
  CHECK_THAT(found.sentence, Contains("has changed") && Contains("--look-in"));
  fs::create_directory_symlink(root / "far", root / "work/link");
  CHECK_FALSE(findSet({"captures", sum}, search).folder);
  CHECK(findSet({"captures", sum}, {root / "work/result.json", {root / "far"}}).folder ==
        root / "far/away/from/it/all/set");
  fs::remove_all(root / "work/captures");
  found = findSet({"captures", sum}, search);
  CHECK_FALSE(found.changed);
  CHECK_THAT(found.sentence, Contains("no longer there") && Contains("--look-in"));
}

TEST_CASE("without a sum a set's place and name count") {
  // Proves it for documents of earlier versions: at the place, else beside the document.
  const TemporaryFolder temporary;
  const fs::path root = fs::canonical(temporary.path());
  writeSet(root / "few", "a");
  CHECK(findSet({"/gone/few", ""}, {root / "result.json"}).folder == root / "few");
  CHECK_FALSE(findSet({"/gone/many", ""}, {root / "result.json"}).folder);
}

TEST_CASE("a document names a set that lies near it by a relative place") {
  // Proves that such a place leads back to the set, that places further up or from the file system's root are absolute,
  // and that a document and its set can be moved together.
  const TemporaryFolder temporary;
  const fs::path root = fs::canonical(temporary.path());
  const std::string sum = writeSet(root / "a/b/captures", "a");
  fs::create_directories(root / "a/b/c/d/e");
  CHECK(placeFrom(root / "a/b/captures", root / "a/b") == "captures");
  CHECK(placeFrom(root / "a/b/captures", root / "a/b/captures") == ".");
  CHECK(placeFrom(root / "a/b/captures", root / "a/b/c/d") == "../../captures");
  CHECK(placeFrom(root / "a/b/captures", root / "a/b/c/d/e") == (root / "a/b/captures").string());
  CHECK(placeFrom(root / "a/b/captures", "/usr/lib") == (root / "a/b/captures").string());
  const std::string place = placeFrom(root / "a/b/captures", root / "a/b/c");
  fs::rename(root / "a/b", root / "elsewhere");
  CHECK(findSet({place, sum}, {root / "elsewhere/c/result.json"}).folder == root / "elsewhere/captures");
}

} // namespace naocal
