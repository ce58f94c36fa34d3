#include "measurements/WitnessSource.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace naocal {

namespace {

/// A tracker's reading of a frame:
///
///   xyz, rotation = trackerFromWorld * worldFromLink * linkFromFrame, its origin times (1 + scale)
///
/// Rows: the origin's error [m], then the rotation vector of predicted * measured^T in the tracker's axes [rad].
class TrackerFrame final : public Witness {
public:
  TrackerFrame(const Measurements& measurements, std::size_t tracker, std::size_t frame,
               const std::array<std::size_t, 2>& levels, const FrameReading& reading)
      : Witness{{{0, 3, levels[0]}, {3, 3, levels[1]}},
                listOwn(measurements.quantities, tracker, frame),
                measurements.instruments.frames[frame].name},
        tracker_{tracker}, frame_{frame}, worldFromReference_{measurements.instruments.trackers[tracker].reference},
        linkFromReference_{measurements.instruments.frames[frame].reference}, xyz_{reading.xyz},
        rotation_{reading.rotation.normalized().toRotationMatrix()} {}

  WitnessRows compare(const RigidTransform& linkFromWorld, const ModelState& modelState) const override {
    const auto placement = modelState.trackerPlacement(tracker_), framePlacement = modelState.framePlacement(frame_);
    const RigidTransform trackerFromReference = transformFromPlacement(placement).inverse();
    const RigidTransform trackerFromLink = trackerFromReference * (linkFromWorld * worldFromReference_).inverse();
    const RigidTransform linkFromFrame = linkFromReference_ * transformFromPlacement(framePlacement);
    const RigidTransform trackerFromFrame = trackerFromLink * linkFromFrame;
    const Eigen::AngleAxisd error{Eigen::Matrix3d{trackerFromFrame.rotation * rotation_.transpose()}};
    const Eigen::Vector3d turn = error.angle() * error.axis();
    const double scale = 1 + modelState.trackerScale(tracker_);

    WitnessRows rows{WitnessRows::Column{6}, WitnessRows::ByMotion{6, 6}, WitnessRows::ByOwn{6, 13}};
    rows.residual << scale * trackerFromFrame.translation - xyz_, turn;
    const Eigen::Matrix3d byRotation = leftJacobian(turn).inverse(); // of the rotation vector
    const Eigen::Matrix3d& r = trackerFromLink.rotation;
    rows.byMotion << scale * r * crossMatrix(linkFromFrame.translation), -scale * r, -byRotation * r,
        Eigen::Matrix3d::Zero();
    const auto setColumn = [&](Eigen::Index column, double sign, const Eigen::Matrix<double, 6, 1>& motion) {
      rows.byOwn.col(column) << sign * scale * velocityAt(trackerFromFrame.translation, motion),
          sign * byRotation * motion.head<3>();
    };
    for (std::size_t i = 0; i < 6; ++i) {
      setColumn(static_cast<Eigen::Index>(i), -1, placementMotion(trackerFromReference, placement, i));
      setColumn(static_cast<Eigen::Index>(7 + i), 1,
                placementMotion(trackerFromLink * linkFromReference_, framePlacement, i));
    }
    rows.byOwn.col(6) << trackerFromFrame.translation, Eigen::Vector3d::Zero();
    return rows;
  }

private:
  static std::vector<std::size_t> listOwn(const StateLayout& quantities, std::size_t tracker, std::size_t frame) {
    std::vector<std::size_t> own;
    for (std::size_t i = 0; i < 7; ++i) {
      own.push_back(quantities.tracker(tracker) + i);
    }
    for (std::size_t i = 0; i < 6; ++i) {
      own.push_back(quantities.frame(frame) + i);
    }
    return own;
  }

  std::size_t tracker_, frame_;
  RigidTransform worldFromReference_, linkFromReference_;
  Eigen::Vector3d xyz_;
  Eigen::Matrix3d rotation_;
};

} // namespace

void addTrackerFrames(WitnessSource& source) {
  const InstrumentList& known = source.measurements.instruments;
  for (const FrameReading& reading : source.capture.frames) {
    const std::size_t tracker = indexOf(known.trackers, source.nameOf(reading.tracker)),
                      frame = indexOf(known.frames, source.nameOf(reading.frame));
    const Tracker& by = known.trackers[tracker].tracker;
    const std::string& name = known.trackers[tracker].name;
    const std::array<std::size_t, 2> levels{source.level(name, ReadingLevel::Unit::metres, by.sigma, 1e-3),
                                            source.level(name, ReadingLevel::Unit::radians, by.sigmaRotation, 1e-3)};
    source.witnesses.push_back({source.viewOf(known.frames[frame].link, "frame " + reading.frame),
                                std::make_shared<TrackerFrame>(source.measurements, tracker, frame, levels, reading)});
  }
}

} // namespace naocal
