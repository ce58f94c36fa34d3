#include "measurements/InitialPlacements.hpp"

#include "camera/BoardPose.hpp"
#include "math/HandEye.hpp"
#include "math/LinearAlgebra.hpp"
#include "robot/Kinematics.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <limits>
#include <map>
#include <optional>

namespace naocal {

namespace {

using Poses = std::vector<RigidTransform>;

constexpr std::size_t mostViews = 200; // per estimate: a medoid's cost grows with their square

/// The pose with the smallest total distance to the others, robust against a few outliers. A turn by 1 rad counts as
/// much as half a metre.
RigidTransform medoidPose(const Poses& all) {
  const auto distance = [](const RigidTransform& a, const RigidTransform& b) {
    return (a.translation - b.translation).norm() +
           0.5 * Eigen::AngleAxisd{Eigen::Matrix3d{a.rotation.transpose() * b.rotation}}.angle();
  };
  double least = std::numeric_limits<double>::infinity();
  RigidTransform best = all.front();
  for (const RigidTransform& candidate : all) {
    double sum = 0;
    for (const RigidTransform& other : all) {
      sum += distance(candidate, other);
    }
    if (sum < least) {
      least = sum;
      best = candidate;
    }
  }
  return best;
}

bool isFree(const Target& target) {
  return target.unknown && !target.isFlat && !target.board.hasGuess;
}

/// Where the support stands, as far as it is known.
std::optional<RigidTransform> worldFromSupport(const Measurements& measurements, std::size_t stance) {
  const StanceInstance& instance = measurements.stances[stance];
  return instance.unknown || !instance.supportLink
             ? std::nullopt
             : std::optional{transformFromPlacement(instance.placement.numbers())};
}

/// worldFromLink at the measured angles; absent where the support's placement is unknown.
std::optional<RigidTransform> worldFromLink(const Measurements& measurements, const ImageObservation& picture,
                                            std::size_t link) {
  const auto support = worldFromSupport(measurements, picture.stance);
  if (!support) {
    return std::nullopt;
  }
  const std::size_t standing = *measurements.stances[picture.stance].supportLink;
  LinkPoses torsoFromLink;
  forwardKinematics(measurements.robot, picture.nominal, ancestorLinks(measurements.robot, {link, standing}),
                    torsoFromLink);
  return *support * torsoFromLink[standing].inverse() * torsoFromLink[link];
}

/// Estimates placements from boards in pictures.
class BoardPlacer {
public:
  explicit BoardPlacer(Measurements& measurements) : measurements_{measurements} {}

  /// Boards seen by cameras on the robot, and bases, in turn from what is known.
  void placeByCarriedCameras() {
    std::map<std::pair<std::size_t, std::size_t>, Poses> supportFromBoard; // by stance and board in the world
    std::map<std::size_t, Poses> linkFromBoard;
    for (const ImageObservation& picture : measurements_.pictures) {
      for (const BoardObservation& observation : picture.observations) {
        const std::size_t board = observation.view.board();
        const Target& target = measurements_.targets[board];
        Poses& poses = target.inWorld ? supportFromBoard[{picture.stance, board}] : linkFromBoard[board];
        if (measurements_.robot.cameras[picture.camera].inWorld || target.isFlat || poses.size() >= mostViews) {
          continue;
        }
        if (const auto opticalFromBoard = estimateBoardPose(observation.corners, picture.nominal.lens())) {
          LinkPoses torsoFromLink;
          forwardKinematics(measurements_.robot, picture.nominal, observation.view.links(), torsoFromLink);
          const CameraFrames frames =
              observation.view.pathFrames({measurements_.robot, picture.nominal, torsoFromLink});
          poses.push_back(frames.opticalFromTarget.inverse() * *opticalFromBoard);
        }
      }
    }
    for (const auto& [board, poses] : linkFromBoard) {
      if (isFree(measurements_.targets[board]) && !poses.empty()) {
        refer(board, medoidPose(poses));
      }
    }
    spreadInWorld(supportFromBoard);
  }

  /// Boards on links seen by cameras beside the robot, and these cameras.
  void placeByStandingCameras() {
    std::map<std::pair<std::size_t, std::size_t>, std::pair<Poses, Poses>> views; // by camera and board
    for (const ImageObservation& picture : measurements_.pictures) {
      for (const BoardObservation& observation : picture.observations) {
        const std::size_t board = observation.view.board();
        const Target& target = measurements_.targets[board];
        if (!measurements_.robot.cameras[picture.camera].inWorld || target.inWorld) {
          continue;
        }
        const auto hand = worldFromLink(measurements_, picture, *measurements_.robot.linkIndex(target.board.link));
        const auto opticalFromBoard = estimateBoardPose(observation.corners, picture.nominal.lens());
        if (hand && opticalFromBoard) {
          views[{picture.camera, board}].first.push_back(*hand);
          views[{picture.camera, board}].second.push_back(*opticalFromBoard);
        }
      }
    }
    for (const auto& [where, poses] : views) {
      placePair(where.first, where.second, poses.first, poses.second);
    }
  }

private:
  void refer(std::size_t board, const RigidTransform& reference) {
    measurements_.targets[board].reference = reference;
    placed_[board] = true;
  }
  bool isPlaced(std::size_t board) const { return !isFree(measurements_.targets[board]) || placed_.contains(board); }
  RigidTransform placedAt(std::size_t board) const {
    const Target& target = measurements_.targets[board];
    return isFree(target)
               ? target.reference
               : transformFromPlacement(target.board.placement.value_or(target.board.placementGuess).numbers());
  }

  /// From known bases to boards and from boards to unknown bases.
  void spreadInWorld(const std::map<std::pair<std::size_t, std::size_t>, Poses>& supportFromBoard) {
    for (bool found = true; found;) {
      found = false;
      for (const auto& [where, poses] : supportFromBoard) {
        const auto [stance, board] = where;
        if (poses.empty()) {
          continue;
        }
        const auto support = worldFromSupport(measurements_, stance);
        if (support && !isPlaced(board)) {
          refer(board, *support * medoidPose(poses));
          found = true;
        } else if (!support && isPlaced(board) && !bases_.contains(stance)) {
          const Twist there = placementFromTransform(placedAt(board) * medoidPose(poses).inverse());
          for (ImageObservation& picture : measurements_.pictures) {
            if (picture.stance == stance) {
              picture.nominal.worldFromSupport() = there;
            }
          }
          bases_[stance] = true;
        }
      }
    }
  }

  void placePair(std::size_t camera, std::size_t board, const Poses& worldFromHand, const Poses& opticalFromBoard) {
    CameraMount& mount = measurements_.robot.cameras[camera];
    const ModelState still{measurements_.quantities};
    const auto mounting = measurements_.sets->front().mountings.find(mount.name);
    const bool isGuessed = mounting != measurements_.sets->front().mountings.end() && mounting->second.guess;
    const bool isCameraPlaced = isGuessed || !measurements_.isCameraUnknown(camera) || cameras_.contains(camera);
    if (isCameraPlaced && isPlaced(board)) {
      return;
    }
    const auto setCamera = [&](const RigidTransform& worldFromOptical) {
      mount.translation = worldFromOptical.translation;
      mount.rotation = worldFromOptical.rotation * opticalFromCamera();
      cameras_[camera] = true;
    };
    Poses found;
    if (isPlaced(board)) {
      for (std::size_t i = 0; i < worldFromHand.size() && i < mostViews; ++i) {
        found.push_back(worldFromHand[i] * placedAt(board) * opticalFromBoard[i].inverse());
      }
      setCamera(medoidPose(found));
    } else if (isCameraPlaced) {
      for (std::size_t i = 0; i < worldFromHand.size() && i < mostViews; ++i) {
        found.push_back(worldFromHand[i].inverse() * linkFromOptical(mount, still) * opticalFromBoard[i]);
      }
      refer(board, medoidPose(found));
    } else {
      const HandEye both = solveHandEye(worldFromHand, opticalFromBoard);
      setCamera(both.worldFromEye);
      refer(board, both.handFromTarget);
    }
  }

  Measurements& measurements_;
  std::map<std::size_t, bool> placed_, bases_, cameras_;
};

/// Estimates placements from trackers' readings and from contacts.
class InstrumentPlacer {
public:
  InstrumentPlacer(Measurements& measurements, const std::function<std::string(const CaptureSet&, std::string)>& nameOf)
      : measurements_{measurements}, known_{measurements.instruments}, nameOf_{nameOf} {}

  void placeTrackers() {
    for (std::size_t tracker = 0; tracker < known_.trackers.size(); ++tracker) {
      isPlaced_ = known_.trackers[tracker].tracker.placement.has_value();
      placeByFrames(tracker);
      placeByPoints(tracker);
    }
  }

  /// Markers and places that touch: worldFromLink * marker = place, linear in both; the marker's guess as a prior.
  void placeContacts() {
    const std::size_t markers = known_.markers.size(), places = known_.places.size();
    const Eigen::Index count = 3 * eigenIndex(markers + places);
    Eigen::MatrixXd gram = Eigen::MatrixXd::Identity(count, count) * 1e-9;
    Eigen::VectorXd side = Eigen::VectorXd::Zero(count);
    constexpr double spread = 0.01; // of contacts at the drawing's geometry, for the weight of the guess [m]
    const auto addPrior = [&](Eigen::Index first, const Eigen::Vector3d& at, double sigma) {
      const double weight = spread * spread / (sigma * sigma);
      gram.diagonal().segment<3>(first).array() += weight;
      side.segment<3>(first) += weight * at;
    };
    bool any = false;
    for (std::size_t marker = 0; marker < markers; ++marker) {
      const MarkerInstance& instance = known_.markers[marker];
      addPrior(3 * eigenIndex(marker), instance.start, instance.marker.point ? 1e-6 : instance.marker.pointSigma);
    }
    for (std::size_t place = 0; place < places; ++place) {
      if (const auto& point = known_.places[place].place.point) {
        addPrior(3 * eigenIndex(markers + place), *point, 1e-6);
      }
    }
    for (const ImageObservation& picture : measurements_.pictures) {
      const CaptureSet& set = measurements_.setOf(picture);
      for (const ContactReading& contact : measurements_.captureOf(picture).contacts) {
        const std::size_t marker = indexOf(known_.markers, nameOf_(set, contact.marker)),
                          place = indexOf(known_.places, nameOf_(set, contact.place));
        if (const auto hand = worldFromLink(measurements_, picture, known_.markers[marker].link)) {
          Eigen::Matrix<double, 3, 6> rows;
          rows << hand->rotation, -Eigen::Matrix3d::Identity();
          const Eigen::Index at[2] = {3 * eigenIndex(marker), 3 * eigenIndex(markers + place)};
          for (Eigen::Index i = 0; i < 2; ++i) {
            side.segment<3>(at[i]) -= rows.middleCols<3>(3 * i).transpose() * hand->translation;
            for (Eigen::Index k = 0; k < 2; ++k) {
              gram.block<3, 3>(at[i], at[k]) += rows.middleCols<3>(3 * i).transpose() * rows.middleCols<3>(3 * k);
            }
          }
          any = true;
        }
      }
    }
    if (!any) {
      return;
    }
    const Eigen::VectorXd points = gram.ldlt().solve(side);
    for (std::size_t marker = 0; marker < markers; ++marker) {
      known_.markers[marker].start = points.segment<3>(3 * eigenIndex(marker));
    }
    for (std::size_t place = 0; place < places; ++place) {
      known_.places[place].start = points.segment<3>(3 * eigenIndex(markers + place));
    }
  }

private:
  void placeByFrames(std::size_t tracker) {
    std::map<std::size_t, std::pair<Poses, Poses>> readings; // by frame: worldFromLink, trackerFromFrame
    for (const ImageObservation& picture : measurements_.pictures) {
      const CaptureSet& set = measurements_.setOf(picture);
      for (const FrameReading& reading : measurements_.captureOf(picture).frames) {
        const std::size_t frame = indexOf(known_.frames, nameOf_(set, reading.frame));
        const auto hand = worldFromLink(measurements_, picture, known_.frames[frame].link);
        if (hand && nameOf_(set, reading.tracker) == known_.trackers[tracker].name) {
          readings[frame].first.push_back(*hand);
          readings[frame].second.push_back({reading.rotation.normalized().toRotationMatrix(), reading.xyz});
        }
      }
    }
    for (const auto& [frame, poses] : readings) {
      const auto& [worldFromHand, trackerFromFrame] = poses;
      const bool isFrameKnown = known_.frames[frame].frame.placement.has_value();
      const RigidTransform linkFromFrame =
          transformFromPlacement(known_.frames[frame].frame.placement.value_or(Placement{}).numbers());
      Poses found;
      for (std::size_t i = 0; i < worldFromHand.size() && i < mostViews; ++i) {
        found.push_back(isFrameKnown ? worldFromHand[i] * linkFromFrame * trackerFromFrame[i].inverse()
                                     : worldFromHand[i].inverse() * trackerAt(tracker) * trackerFromFrame[i]);
      }
      if (isPlaced_ && !isFrameKnown) {
        known_.frames[frame].reference = medoidPose(found);
      } else if (!isPlaced_ && isFrameKnown) {
        setTracker(tracker, medoidPose(found));
      } else if (!isPlaced_) {
        const HandEye both = solveHandEye(worldFromHand, trackerFromFrame);
        setTracker(tracker, both.worldFromEye);
        known_.frames[frame].reference = both.handFromTarget;
      }
    }
  }

  void placeByPoints(std::size_t tracker) {
    std::vector<SeenPoint> seen;
    std::vector<std::size_t> markers; // index of each point's marker
    for (const ImageObservation& picture : measurements_.pictures) {
      const CaptureSet& set = measurements_.setOf(picture);
      for (const PointReading& reading : measurements_.captureOf(picture).points) {
        const std::size_t marker = indexOf(known_.markers, nameOf_(set, reading.marker));
        const auto hand = worldFromLink(measurements_, picture, known_.markers[marker].link);
        if (hand && nameOf_(set, reading.tracker) == known_.trackers[tracker].name) {
          std::size_t point = 0;
          while (point < markers.size() && markers[point] != marker) {
            ++point;
          }
          if (point == markers.size()) {
            markers.push_back(marker);
          }
          seen.push_back({*hand, point, reading.xyz});
        }
      }
    }
    if (seen.empty()) {
      return;
    }
    if (!isPlaced_) {
      setTracker(tracker, registerPoints(seen, markers.size()).worldFromEye);
    }
    std::vector<Eigen::Vector3d> sums(markers.size(), Eigen::Vector3d::Zero());
    std::vector<double> counts(markers.size(), 0);
    for (const SeenPoint& reading : seen) {
      sums[reading.point] += reading.worldFromHand.inverse() * (trackerAt(tracker) * reading.inEye);
      counts[reading.point] += 1;
    }
    for (std::size_t point = 0; point < markers.size(); ++point) {
      if (!known_.markers[markers[point]].marker.point) {
        known_.markers[markers[point]].start = sums[point] / counts[point];
      }
    }
  }

  RigidTransform trackerAt(std::size_t tracker) const {
    const auto& placement = known_.trackers[tracker].tracker.placement;
    return placement ? transformFromPlacement(placement->numbers()) : known_.trackers[tracker].reference;
  }
  void setTracker(std::size_t tracker, const RigidTransform& worldFromTracker) {
    known_.trackers[tracker].reference = worldFromTracker;
    isPlaced_ = true;
  }

  Measurements& measurements_;
  InstrumentList& known_;
  const std::function<std::string(const CaptureSet&, std::string)>& nameOf_;
  bool isPlaced_ = false; // the tracker in hand
};

} // namespace

void placeInitially(Measurements& measurements,
                    const std::function<std::string(const CaptureSet&, std::string)>& nameOf) {
  BoardPlacer boards{measurements};
  boards.placeByCarriedCameras();
  boards.placeByStandingCameras();
  InstrumentPlacer instruments{measurements, nameOf};
  instruments.placeTrackers();
  instruments.placeContacts();
}

} // namespace naocal
