#include "Questioned.hpp"
#include "diagnose/Imprint.hpp"
#include "diagnose/Scene.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

/// The captures with every corner where an effect of this size puts it, beside the model as it was fitted.
CaptureSet perfectButFor(const Term& term, const Eigen::VectorXd& size, const Questioned& asked, CaptureSet set) {
  Model model = asked.model;
  model.add(term);
  Eigen::VectorXd unknowns(asked.fit.unknowns.size() + size.size());
  unknowns << asked.fit.unknowns, size;
  for (const Picture& picture : asked.measurements.pictures) {
    const auto boards = scene(asked.measurements, picture, believed(asked.measurements, model, picture, unknowns));
    for (std::size_t i = 0; i < boards.size(); ++i) {
      const Sighting& sighting = picture.sightings[i];
      const std::string& name = asked.measurements.targets[sighting.view.board()].name;
      for (BoardCorners& seen : *set.captures[picture.capture].corners) {
        for (std::size_t k = 0; seen.board == name && k < seen.ids.size(); ++k) {
          const auto place = std::find(sighting.ids.begin(), sighting.ids.end(), seen.ids[k]) - sighting.ids.begin();
          seen.uv[k] = boards[i].corners.col(place);
        }
      }
    }
  }
  return set;
}

} // namespace

TEST_CASE("an effect's imprint is what it leaves after a calibration without it") {
  // Proves the shifts before and after against a whole calibration of captures that are perfect but for that effect:
  // one that the joint offsets take up for the most part, one they take up less, and one of the lens, so large that the
  // calibration's being nonlinear shows.
  const CaptureSet set = simulatedSet(8, 3);
  const Questioned asked{set, false};
  const std::string label = GENERATE("encoderGain@LKneePitch", "elasticity@LKneePitch", "radialDistortion@top");
  CAPTURE(label);
  const std::size_t candidate = *asked.inquiry.find(label);
  const Imprint imprint = imprints(asked.measurements, asked.model, asked.fit, asked.inquiry, {candidate}).front();
  const CaptureSet perfect = perfectButFor(asked.inquiry.candidates()[candidate], imprint.size, asked, set);
  const Measurements measurements = measurementsOf({perfect}, asked.measurements.robot);

  double squares = 0, corners = 0;
  const Residuals before{measurements, asked.model, asked.fit.noise};
  for (const SightingResidual& sighting : before.sightings(before.start(asked.fit.unknowns))) {
    squares += sighting.residual.squaredNorm();
    corners += static_cast<double>(sighting.residual.cols());
  }
  CHECK(imprint.beforePx ==
        Approx(std::sqrt(squares / corners)).epsilon(0.03)); // one picture per pose stands for three

  CalibrationOptions options;
  options.noise = asked.inquiry.noise();
  options.noise.pose = asked.inquiry.ofCandidate(candidate).level;
  options.estimateNoise = options.robust = options.setAside = false;
  options.pixelGiven = true;
  CHECK(imprint.afterPx == Approx(calibrate(measurements, asked.model, options).rmsPx).epsilon(0.1));
  CHECK(imprint.afterPx < imprint.beforePx);
}

TEST_CASE("an imprint shows the pictures that shift most first, six of each camera") {
  // Proves the order and number that the page relies on.
  const Questioned asked{simulatedSet(8, 3), false};
  const std::size_t candidate = *asked.inquiry.find("elasticity@LKneePitch");
  const Imprint imprint = imprints(asked.measurements, asked.model, asked.fit, asked.inquiry, {candidate}).front();
  CHECK(std::is_sorted(imprint.pictures.begin(), imprint.pictures.end(),
                       [](const auto& a, const auto& b) { return a.beforePx > b.beforePx; }));
  for (const std::size_t camera : {0, 1}) {
    CHECK(std::count_if(imprint.pictures.begin(), imprint.pictures.end(), [&](const Imprint::Seen& seen) {
            return asked.measurements.pictures[seen.picture].camera == camera;
          }) <= 6);
  }
}

} // namespace naocal
