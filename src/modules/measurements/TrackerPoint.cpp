#include "measurements/WitnessSource.hpp"

namespace naocal {

namespace {

/// A tracker's reading of a marker:
///
///   xyz = (1 + scale) * trackerFromWorld * worldFromLink * marker
///
/// Sigma per axis as the tracker's maker says, else estimated.
class TrackerPoint final : public Witness {
public:
  TrackerPoint(const Measurements& measurements, std::size_t tracker, std::size_t marker, std::size_t level,
               Eigen::Vector3d xyz)
      : Witness{{{0, 3, level}},
                listOwn(measurements.quantities, tracker, marker),
                measurements.instruments.markers[marker].name},
        tracker_{tracker}, marker_{marker},
        reference_{measurements.instruments.trackers[tracker].reference}, xyz_{std::move(xyz)} {}

  WitnessRows compare(const RigidTransform& linkFromWorld, const ModelState& modelState) const override {
    const auto placement = modelState.trackerPlacement(tracker_);
    const RigidTransform trackerFromReference = transformFromPlacement(placement).inverse();
    const RigidTransform trackerFromLink = trackerFromReference * (linkFromWorld * reference_).inverse();
    const Eigen::Vector3d marker = modelState.marker(marker_), point = trackerFromLink * marker;
    const double scale = 1 + modelState.trackerScale(tracker_);
    WitnessRows rows{scale * point - xyz_, WitnessRows::ByMotion{3, 6}, WitnessRows::ByOwn{3, 10}};
    rows.byMotion << scale * trackerFromLink.rotation * crossMatrix(marker), -scale * trackerFromLink.rotation;
    for (std::size_t i = 0; i < 6; ++i) {
      rows.byOwn.col(static_cast<Eigen::Index>(i)) =
          -scale * velocityAt(point, placementMotion(trackerFromReference, placement, i));
    }
    rows.byOwn.col(6) = point;
    rows.byOwn.rightCols<3>() = scale * trackerFromLink.rotation;
    return rows;
  }

private:
  static std::vector<std::size_t> listOwn(const StateLayout& quantities, std::size_t tracker, std::size_t marker) {
    std::vector<std::size_t> own;
    for (std::size_t i = 0; i < 7; ++i) {
      own.push_back(quantities.tracker(tracker) + i);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      own.push_back(quantities.marker(marker) + i);
    }
    return own;
  }

  std::size_t tracker_, marker_;
  RigidTransform reference_;
  Eigen::Vector3d xyz_;
};

} // namespace

void addTrackerPoints(WitnessSource& source) {
  const InstrumentList& known = source.measurements.instruments;
  for (const PointReading& reading : source.capture.points) {
    const std::size_t tracker = indexOf(known.trackers, source.nameOf(reading.tracker)),
                      marker = indexOf(known.markers, source.nameOf(reading.marker));
    const std::size_t level = source.level(known.trackers[tracker].name, ReadingLevel::Unit::metres,
                                           known.trackers[tracker].tracker.sigma, 1e-3);
    source.witnesses.push_back(
        {source.viewOf(known.markers[marker].link, "marker " + reading.marker),
         std::make_shared<TrackerPoint>(source.measurements, tracker, marker, level, reading.xyz)});
  }
}

} // namespace naocal
