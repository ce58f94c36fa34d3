#include "Breaks.hpp"
#include "GoodSet.hpp"
#include "data/CaptureSetFile.hpp"
#include "data/Refusal.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace naocal {
namespace {

using nlohmann::json;

json broken(const Break& how) {
  json document = goodSet();
  applyBreak(how, document);
  return document;
}

} // namespace

TEST_CASE("every broken set is refused with a sentence that says where, what was expected and what was found") {
  // Proves it for the single modifications in the table. Examples cannot prove that every other defect is refused.
  for (const Break& how : breaks()) {
    const std::string sentence = refusal(broken(how).dump());
    INFO(how.place << " = " << how.value << "\n" << sentence);
    checkSentence(sentence, how.sentence);
  }
}

TEST_CASE("a capture that cannot be used can be left out; a broken set cannot") {
  // Proves that exactly the invalid capture is skipped, with the message that would have refused the file.
  for (const Break& how : breaks()) {
    const std::string text = broken(how).dump();
    INFO(how.place << " = " << how.value);
    if (how.what == Breaks::file) {
      CHECK_THROWS_AS(parseCaptureSet(text, "some/captures.json", BadCapturePolicy::skip), InputError);
      continue;
    }
    const auto read = parseCaptureSet(text, "some/captures.json", BadCapturePolicy::skip);
    CHECK(read.skipped == std::vector{refusal(text)});
    CHECK(read.set.captures.size() == goodSet()["captures"].size() - 1);
  }
}

TEST_CASE("boards of one dictionary share no marker") {
  // Proves the limit: board A uses 17 markers from id 0, so id 17 is free and id 16 is not.
  json document = goodSet();
  document["boards"][1]["dictionary"] = "DICT_4X4_100";
  document["boards"][1]["firstMarkerId"] = 17;
  CHECK(refusal(document.dump()) == "not refused");
  document["boards"][1]["firstMarkerId"] = 16;
  CHECK_THAT(refusal(document.dump()), Catch::Contains("boards[1]") && Catch::Contains("also on board \"A\""));
}

TEST_CASE("both hip yaw pitch angles may differ by the rounding of a log") {
  // Proves that the angles of this one motor may differ in the last digits; the table of breaks tests the refusal.
  json document = goodSet();
  document["captures"][0]["joints"]["measured"] = {0, 0, 0.3, 0.3015};
  CHECK(refusal(document.dump()) == "not refused");
}

} // namespace naocal
