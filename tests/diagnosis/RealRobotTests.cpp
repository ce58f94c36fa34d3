#include "SharedData.hpp"
#include "Solved.hpp"
#include "diagnosis/Diagnosis.hpp"

#include <catch2/catch.hpp>

namespace naocal {

TEST_CASE("what is found missing in a real NAO's limbs predicts captures that the search has not seen", "[slow]") {
  // Proves the loop on measurements of a robot in another laboratory (Freiburg, 2014): diagnosis of the training set,
  // suggestions added, prediction of the test set. Published with six free parameters per link: 2.1 px (arm), 4.2 px
  // (leg). Here the lens is fixed, and at most twenty unknowns are added.
  const auto data = sharedData("nao-freiburg-2014");
  if (!data) {
    return;
  }
  struct Limit {
    std::string limb;
    double before, after; // [px]
  };
  for (const auto& [limb, before, after] : {Limit{"larm", 2.9, 1.78}, {"lleg", 4.4, 3.9}}) {
    const std::filesystem::path training = *data / (limb + "-train");
    const Solved plain = solved(training);
    const Diagnosis diagnosis = diagnose(plain.measurements);
    const Solved larger = solved(training, diagnosis.suggested);
    const CaptureSet test = readCaptureSet(*data / (limb + "-test")).set;
    INFO(limb << ": " << diagnosis.sentence);
    CHECK(diagnosis.lackOfFit.dof[1] < 1); // one mark per image does not determine the noise
    CHECK(diagnosis.lackOfFit.pValue < 1e-6);
    CHECK(larger.model.unknownCount() <= plain.model.unknownCount() + 20);
    CHECK(compare(plain.stored(), {test}, robotOf(test), false).all.rmsPx > before);
    CHECK(compare(larger.stored(), {test}, robotOf(test), false).all.rmsPx < after);
  }
}

} // namespace naocal
