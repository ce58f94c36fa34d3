#include "report/Sentences.hpp"

#include "geometry/Angles.hpp"

#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

double numberAt(const JsonPlace& place, const std::string& key) {
  return place.at(key).number({-1e15, 1e15, ""});
}

Fact cornerFact(const JsonPlace& result, std::size_t pictures, std::optional<double> drawingRms) {
  const double rms = numberAt(result, "rmsPx");
  const std::string where =
      fmt::format("rms distance between {:.0f} measured corners in {} pictures and where the result predicts them",
                  numberAt(result, "corners"), pictures);
  if (!drawingRms) {
    return {fmt::format("{:.2f} px", rms), where + fmt::format(" (median {:.2f} px).", numberAt(result, "medianPx"))};
  }
  return {fmt::format("{:.3g} → {:.2f} px", *drawingRms, rms),
          where + "; the first number is with the robot's drawing alone, boards where they fit best."};
}

Fact noiseFact(const JsonPlace& noise) {
  const bool told = noise.at("source").text() == "repeats";
  const double stance = numberAt(noise, "stance");
  return {fmt::format("{:.2g} px", numberAt(noise, "pixel")),
          fmt::format("noise of a corner per axis; {:.3f}° of an encoder's reading; {:.3f}° of a joint from pose to "
                      "pose{}: {}.",
                      degrees(numberAt(noise, "encoder")), degrees(numberAt(noise, "pose")),
                      stance > 0 ? fmt::format("; {:.3f}° more wherever the robot stands anew", degrees(stance)) : "",
                      told ? "measured from poses that were taken more than once"
                           : "partly assumed, because no pose was taken more than once")};
}

/// The p-value of chi2 in words.
Fact misfitFact(const JsonPlace& result) {
  const double p = numberAt(result, "pValue");
  const std::string figure = p >= 0.001 ? fmt::format("p = {:.2g}", p) : "p < 0.001";
  if (p >= 0.05) {
    return {figure, fmt::format("the noise explains what is left: {:.0f} of 100 sound calibrations would look worse.",
                                100 * p)};
  }
  if (p >= 0.001) {
    return {figure, fmt::format("what is left is larger than usual: only {:.2g} of 100 sound calibrations would look "
                                "worse.",
                                100 * p)};
  }
  return {figure, fmt::format("noise alone does not explain what is left (chi2 is {:.2g} times what it should be): "
                              "something is missing in the model, or captures are wrong.",
                              numberAt(result, "chi2") / std::max(1.0, numberAt(result, "dof")))};
}

} // namespace

std::string headline(const JsonPlace& result) {
  return result.at("usable").boolean() ? "This calibration can be used." : "This calibration should not be used.";
}

std::vector<Fact> facts(const JsonPlace& result, std::size_t pictures, std::optional<double> drawingRms) {
  std::vector<Fact> all{cornerFact(result, pictures, drawingRms), misfitFact(result), noiseFact(result.at("noise"))};
  if (const double floor = numberAt(result, "floorErrorAt2m"); floor > 0) {
    all.insert(all.begin() + 1,
               {fmt::format("± {:.1f} mm", 1000 * floor),
                "is how far off the robot will see a point on the floor 2 m ahead (1 sigma); below 50 mm is good "
                "enough to play."});
  }
  return all;
}

} // namespace naocal
