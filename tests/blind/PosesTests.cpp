#include "blind/NaoV6.hpp"
#include "writer/Question.hpp"

#include <catch2/catch.hpp>

namespace blind {

TEST_CASE("every planned attitude stands: its centre of mass lies over the sole") {
  // Proves static balance of the planned poses for the true robot, to within fixed bounds of the sole. Joint limits are
  // checked during sampling, not here.
  RandomStream chance{7, "mechanism"};
  const Question question = drawQuestion(naoV6(), {"control", "", 0, 20, "clean"}, chance);
  const TruePictures pictures{question.robot, question.session};
  for (std::size_t i = 0; i < question.session.readings.size(); ++i) {
    const int side = question.session.stances[question.session.readings[i].stance].side;
    const Skeleton::Posture posture = pictures.skeleton().posture(pictures.angles(static_cast<int>(i)));
    const Eigen::Vector3d centre =
        pictures.skeleton().torsoFromSole(posture, side).inverse() * pictures.skeleton().centreOfMass(posture);
    CHECK(centre.x() > -0.04);
    CHECK(centre.x() < 0.085);
    CHECK(std::abs(centre.y()) < 0.034);
  }
}

} // namespace blind
