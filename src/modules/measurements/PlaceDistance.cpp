#include "measurements/WitnessSource.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace naocal {

namespace {

/// A measured distance between two places: |a - b| = metres.
class DistanceBetweenPlaces final : public Witness {
public:
  DistanceBetweenPlaces(const StateLayout& quantities, const std::array<std::size_t, 2>& places, double metres,
                        std::size_t level)
      : Witness{{{0, 1, level}}, listOwn(quantities, places), ""}, places_{places}, metres_{metres} {}

  WitnessRows compare(const RigidTransform&, const ModelState& modelState) const override {
    const Eigen::Vector3d between = modelState.place(places_[0]) - modelState.place(places_[1]);
    const double length = between.norm();
    WitnessRows rows{WitnessRows::Column::Constant(1, length - metres_), WitnessRows::ByMotion::Zero(1, 6),
                     WitnessRows::ByOwn{1, 6}};
    const Eigen::RowVector3d direction = between.transpose() / std::max(length, 1e-9);
    rows.byOwn << direction, -direction;
    return rows;
  }

private:
  static std::vector<std::size_t> listOwn(const StateLayout& quantities, const std::array<std::size_t, 2>& places) {
    std::vector<std::size_t> own;
    for (const std::size_t place : places) {
      const std::size_t first = quantities.place(place);
      own.insert(own.end(), {first, first + 1, first + 2});
    }
    return own;
  }

  std::array<std::size_t, 2> places_;
  double metres_;
};

/// Places that are known, or that a contact tells.
std::set<std::size_t> findLocatedPlaces(const Measurements& measurements) {
  std::set<std::size_t> located;
  const StateLayout& layout = measurements.quantities;
  for (std::size_t place = 0; place < measurements.instruments.places.size(); ++place) {
    const auto touches = [&](const WitnessObservation& observation) {
      const std::vector<std::size_t>& own = observation.witness->own();
      return std::find(own.begin(), own.end(), layout.place(place)) != own.end();
    };
    if (measurements.instruments.places[place].place.point ||
        std::any_of(measurements.pictures.begin(), measurements.pictures.end(), [&](const ImageObservation& picture) {
          return std::any_of(picture.witnesses.begin(), picture.witnesses.end(), touches);
        })) {
      located.insert(place);
    }
  }
  return located;
}

} // namespace

std::vector<WitnessObservation> makePlaceDistances(Measurements& measurements, const CaptureSet& set,
                                                   const std::function<std::string(const std::string&)>& nameOf) {
  std::vector<WitnessObservation> result;
  const auto& places = measurements.instruments.places;
  const std::set<std::size_t> located = findLocatedPlaces(measurements);
  for (const PlaceDistance& distance : set.instruments.distances) {
    const std::array<std::size_t, 2> ends{indexOf(places, nameOf(distance.between[0])),
                                          indexOf(places, nameOf(distance.between[1]))};
    if (!located.contains(ends[0]) || !located.contains(ends[1])) {
      continue; // tells only where the other end is
    }
    measurements.levels.push_back({.name = fmt::format("{} to {}", places[ends[0]].name, places[ends[1]].name),
                                   .unit = ReadingLevel::Unit::metres,
                                   .sigma = distance.sigma,
                                   .isGiven = true});
    result.push_back(
        {std::nullopt, std::make_shared<DistanceBetweenPlaces>(measurements.quantities, ends, distance.metres,
                                                               measurements.levels.size() - 1)});
  }
  return result;
}

} // namespace naocal
