#include "TemporaryFolder.hpp"
#include "diagnosis/DiagnosisFile.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "library/naocal.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {

TEST_CASE("a diagnosis is written as a file that replaces the former one") {
  // Proves that the file holds DIAGNOSIS.json and nothing else, and that a path that cannot be written is refused.
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "diagnosis.json";
  Diagnosis diagnosis;
  diagnosis.sentence = "The left knee gives way under load.";
  writeAtomically(file, "former");
  writeDiagnosis(diagnosis, file);
  const auto json = nlohmann::json::parse(readFile(file));
  CHECK(json == diagnosisJson(diagnosis));
  CHECK(json["format"] == "naocal-diagnosis");
  CHECK(json["sentence"] == diagnosis.sentence);
  CHECK(std::distance(std::filesystem::directory_iterator{folder.path()}, {}) == 1);
  CHECK_THROWS_AS(writeDiagnosis(diagnosis, file / "beneath-a-file.json"), InputError);
}

} // namespace naocal
