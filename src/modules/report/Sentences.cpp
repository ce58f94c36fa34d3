#include "report/Sentences.hpp"

#include "math/Angles.hpp"

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

/// What noise alone would leave, and how often it would look as if something were missing.
Fact misfitFact(const JsonPlace& result) {
  const double p = numberAt(result, "pValue");
  const std::string chance =
      p >= 0.05 ? "the likeliest cause of more is no more striking than pure noise."
      : p >= 0.001
          ? fmt::format("if nothing were missing, evidence this strong for a cause would turn up once in {:.0f} "
                        "calibrations.",
                        1 / p)
          : "if nothing were missing, evidence this strong for a cause would turn up less than once in 1000 "
            "calibrations.";
  return {fmt::format("{:.2f} px", numberAt(result, "noiseFloorPx")), "is the noise floor; " + chance};
}

} // namespace

VerdictWords verdictWords(const JsonPlace& result) {
  const std::string said = result.at("sentence").text(), between = ": ";
  const std::size_t colon = said.find(between);
  if (colon == said.npos) {
    return {said, ""};
  }
  std::string rest = said.substr(colon + between.size());
  if (!rest.empty() && rest.front() >= 'a' && rest.front() <= 'z') {
    rest.front() = static_cast<char>(rest.front() - 'a' + 'A');
  }
  return {said.substr(0, colon) + ".", std::move(rest)};
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
