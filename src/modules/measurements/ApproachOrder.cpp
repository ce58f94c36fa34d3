#include "measurements/ApproachOrder.hpp"

#include "measurements/CaptureReading.hpp"
#include "measurements/RestGrouping.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace naocal {

namespace {

/// The pictures of one set in the order in which they were taken.
using Sequence = std::vector<ImageObservation*>;

Sequence sequenceOf(std::size_t set, Measurements& measurements) {
  Sequence result;
  for (ImageObservation& picture : measurements.pictures) {
    if (picture.set == set) {
      result.push_back(&picture);
    }
  }
  std::sort(result.begin(), result.end(), [](const ImageObservation* one, const ImageObservation* other) {
    return one->instant.time != other->instant.time ? one->instant.time < other->instant.time
                                                    : one->capture < other->capture;
  });
  return result;
}

/// Whether all captures, of several poses, have one time.
bool isTimeless(const Sequence& pictures) {
  return pictures.empty() || pictures.front()->instant.time == pictures.back()->instant.time;
}

/// Directions of one set, picture by picture.
class DirectionFinder {
public:
  explicit DirectionFinder(Measurements& measurements)
      : measurements_{measurements}, tolerance_{restTolerance(measurements)},
        last_{Eigen::VectorXd::Constant(tolerance_.size(), nothing)}, direction_{last_} {}

  void visit(ImageObservation& picture) {
    const Capture& capture = measurements_.captureOf(picture);
    const bool isUnknown = before_ != nullptr && isPathUnknown(*before_, capture);
    before_ = &capture;
    const Eigen::VectorXd recorded = measuredAngles(measurements_.robot, measurements_.setOf(picture), capture);
    for (const std::size_t motor : motors()) {
      const auto at = static_cast<Eigen::Index>(motor);
      last_[at] = isUnknown ? nothing : last_[at];
      follow(at, std::isnan(recorded[at]) ? nothing : picture.instant.q[at]);
      double& approach = picture.instant.approach[at];
      if (!std::isnan(approach)) {
        direction_[at] = approach;
      } else if (!std::isnan(direction_[at])) {
        approach = direction_[at];
      }
    }
  }

private:
  static constexpr double nothing = RobotSample::nothing;

  /// Whether the robot moved on an unknown path between two captures.
  static bool isPathUnknown(const Capture& before, const Capture& capture) {
    const bool isSamePose = before.pose == capture.pose && before.repeat != capture.repeat;
    return before.stance != capture.stance || (isSamePose && capture.repeatKind != RepeatKind::rest);
  }

  std::vector<std::size_t> motors() const {
    std::vector<std::size_t> result;
    for (std::size_t joint = 0; joint < measurements_.robot.joints.size(); ++joint) {
      if (measurements_.robot.joints[joint].motor == joint) {
        result.push_back(joint);
      }
    }
    return result;
  }

  /// Compares a joint's angle with that at which its last motion was noticed.
  void follow(Eigen::Index joint, double angle) {
    double& last = last_[joint];
    if (std::isnan(angle) || std::isnan(last)) {
      direction_[joint] = nothing;
      last = angle;
    } else if (std::abs(angle - last) > tolerance_[joint]) {
      direction_[joint] = angle > last ? 1 : -1;
      last = angle;
    }
  }

  const Measurements& measurements_;
  Eigen::ArrayXd tolerance_;
  Eigen::VectorXd last_, direction_; // per joint
  const Capture* before_ = nullptr;
};

/// Number of pictures before the first motion of any joint.
std::size_t countBeforeMotion(const Sequence& pictures) {
  const auto first = std::find_if(pictures.begin(), pictures.end(), [](const ImageObservation* picture) {
    return !picture->instant.approach.array().isNaN().all();
  });
  return static_cast<std::size_t>(first - pictures.begin());
}

/// Whether a joint came from below and from above.
bool hasBothDirections(const Sequence& pictures, Eigen::Index joint) {
  const auto has = [&](double direction) {
    return std::any_of(pictures.begin(), pictures.end(),
                       [&](const ImageObservation* picture) { return picture->instant.approach[joint] == direction; });
  };
  return has(-1) && has(1);
}

/// Sets a joint's unknown directions to 0 where they are few. `before`: number of pictures before any motion.
void settleUnknown(const Sequence& pictures, std::size_t before, Eigen::Index joint) {
  constexpr double most = 0.1; // share
  const auto isUnknown = [&](const ImageObservation* picture) { return std::isnan(picture->instant.approach[joint]); };
  const auto unknown = std::count_if(pictures.begin() + static_cast<std::ptrdiff_t>(before), pictures.end(), isUnknown);
  if (static_cast<double>(unknown) > most * static_cast<double>(pictures.size() - before) ||
      !hasBothDirections(pictures, joint)) {
    return;
  }
  for (ImageObservation* picture : pictures) {
    picture->instant.approach[joint] = isUnknown(picture) ? 0 : picture->instant.approach[joint];
  }
}

/// Gives joints of one motor its direction.
void copyToFollowers(const Robot& robot, Eigen::VectorXd& approach) {
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    approach[static_cast<Eigen::Index>(joint)] = approach[static_cast<Eigen::Index>(robot.joints[joint].motor)];
  }
}

} // namespace

void deriveApproaches(Measurements& measurements) {
  for (std::size_t set = 0; set < measurements.sets->size(); ++set) {
    const Sequence pictures = sequenceOf(set, measurements);
    if (isTimeless(pictures)) {
      continue;
    }
    std::vector<bool> isRecorded;
    DirectionFinder finder{measurements};
    for (ImageObservation* picture : pictures) {
      isRecorded.push_back(!picture->instant.approach.array().isNaN().all());
      finder.visit(*picture);
    }
    const std::size_t before = countBeforeMotion(pictures);
    for (Eigen::Index joint = 0; joint < pictures.front()->instant.approach.size(); ++joint) {
      settleUnknown(pictures, before, joint);
    }
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      copyToFollowers(measurements.robot, pictures[i]->instant.approach);
      measurements.approachesFromOrder += !isRecorded[i] && !pictures[i]->instant.approach.array().isNaN().all();
    }
  }
}

} // namespace naocal
