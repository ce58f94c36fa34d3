#include "blind/NaoV6.hpp"
#include "writer/Question.hpp"

#include <catch2/catch.hpp>

namespace blind {

TEST_CASE("an event's truth tells between which readings it happened") {
  // Proves the reported interval of all three kinds of events against the images: no shift of a board's first corner
  // before it, some after it.
  const std::string kind = GENERATE("kicked board", "slipped robot", "offset step");
  RandomStream chance{5, "event"}, mistakes{5, "mistakes"};
  Question question = drawQuestion(naoV6(), {"event", kind, 0, 16, "clean"}, chance);
  Question calm = question;
  calm.robot = withoutFlaws(question.robot);
  corruptSession(kind, question.session, mistakes);
  const auto happened = happening(question);
  REQUIRE(happened);
  CHECK(happened->what == kind);
  CHECK(happened->before < happened->after);
  const TruePictures moved{question.robot, question.session}, still{calm.robot, calm.session};
  double before = 0, after = 0;
  for (const BoardSight& sight : question.session.sights) {
    const double time = question.session.readings[sight.reading].time - question.session.readings.front().time;
    const double shift = (moved.corners(sight).front() - still.corners(sight).front()).norm();
    double& most = time <= happened->before ? before : after;
    most = std::max(most, shift);
  }
  CHECK(before < 1e-6);
  CHECK(after > 1); // [px]
}

TEST_CASE("a twin does nearly the same to the pictures, and plausible sizes are met") {
  // Proves that a twin question names a twin effect at the hidden effect's place, and that a sized question has its
  // size. How similar the twin's images are is not tested.
  RandomStream chance{3, "twin"};
  const Question twin = drawQuestion(naoV6(), {"twin", "", 0, 20, "clean"}, chance);
  REQUIRE(twin.hidden.size() == 1);
  REQUIRE_FALSE(twin.twins.empty());
  CHECK(twin.twins.front().ends_with("@" + twin.hidden.front().place));
  CHECK_FALSE(twin.twins.front().starts_with(twin.hidden.front().family->effect + "@"));
  const Question shifted = drawQuestion(naoV6(), {"sized", "cameraTranslation", 0, 20, "clean", false, 2}, chance);
  const std::vector<double>& by = shifted.hidden.front().values;
  CHECK(std::hypot(by[0], by[1], by[2]) == Approx(2 * 0.005));
}

TEST_CASE("the same seed writes the same question, another one another") {
  // Proves that all random draws are determined by the seed. Files are not compared.
  const DesignItem item{"catalogue", "backlash", 40, 12, "quantised"};
  RandomStream a{5, "same"}, b{5, "same"}, c{6, "same"};
  const Question first = drawQuestion(naoV6(), item, a), again = drawQuestion(naoV6(), item, b),
                 other = drawQuestion(naoV6(), item, c);
  CHECK(first.robot.offsets == again.robot.offsets);
  CHECK(first.hidden[0].values == again.hidden[0].values);
  CHECK(first.session.readings.back().measured == again.session.readings.back().measured);
  CHECK_FALSE(first.robot.offsets == other.robot.offsets);
}

} // namespace blind
