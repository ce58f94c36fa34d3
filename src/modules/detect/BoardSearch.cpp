#include "detect/BoardSearch.hpp"

#include "data/Board.hpp"
#include "detect/CornerRefinement.hpp"
#include "detect/MarkerDetector.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <optional>

namespace naocal {

namespace {

constexpr double tightest = 0.3, loosest = 0.7; // [px] bounds of the largest distance from the predicted position

constexpr double timesMedian = 6; // largest distance relative to the median

constexpr double walkingDistance = 1.5; // [squares] from known points to a searched corner

constexpr double longestMove = 2.0; // [px] from prediction to refined position, lower bound

constexpr double longestMoveInSquares = 0.1;

constexpr double leastContrast = 10; // [grey level] below it there is no corner

constexpr double mostAsymmetry = 0.03; // above it there is no corner; 0.001 to 0.01 for an unobstructed window

class Walk {
public:
  Walk(const SmoothImage& picture, const LensDistortion& lens, const CharucoPattern& pattern,
       const std::vector<PointMatch>& markerCorners)
      : picture_{picture}, lens_{lens}, pattern_{pattern}, markerCorners_{markerCorners},
        reach_{symmetryRadius(pattern, int(markerCells(pattern.dictionary, pattern.firstMarkerId).rows()))} {}

  BoardSearchResult result() {
    spread();
    refine();
    removeMisplaced();
    retryMissing();
    BoardSearchResult result;
    for (const auto& [id, corner] : found_) {
      result.corners[id] = corner.pixel;
    }
    for (const auto& [id, corner] : refused_) {
      result.refused.push_back(corner);
    }
    return result;
  }

private:
  struct Found {
    Eigen::Vector2d pixel;
    PointMatch observation;
  };

  Eigen::Vector2d onBoard(int id) const { return cornerOnBoard(pattern_, id); }

  /// All known points except corner `id`.
  std::vector<PointMatch> others(int id) const {
    std::vector<PointMatch> observations = markerCorners_;
    for (const auto& [foundId, corner] : found_) {
      if (foundId != id) {
        observations.push_back(corner.observation);
      }
    }
    return observations;
  }

  Eigen::Vector2d pixel(const Eigen::Matrix3d& homography, const Eigen::Vector2d& place) const {
    return lens_.distort((homography * place.homogeneous()).hnormalized());
  }

  /// Refines corner `id` from its prediction by `homography`; absent without a crossing as printed.
  std::optional<CornerFit> fitCornerAt(int id, const Eigen::Matrix3d& homography) const {
    const int column = id % (pattern_.squaresX - 1), row = id / (pattern_.squaresX - 1);
    const auto map = [&](const Eigen::Vector2d& place) { return pixel(homography, place); };
    const Eigen::Vector2d start = map(onBoard(id));
    if (!picture_.contains(start)) {
      return std::nullopt;
    }
    const auto pairs = symmetricPairs(map, onBoard(id), reach_, isBlackSquare(pattern_, column, row));
    const double square = std::min((map(onBoard(id) + Eigen::Vector2d::UnitX()) - start).norm(),
                                   (map(onBoard(id) + Eigen::Vector2d::UnitY()) - start).norm());
    const auto fit = fitCorner(picture_, pairs, start, std::max(longestMove, longestMoveInSquares * square));
    return fit && fit->contrast >= leastContrast && fit->asymmetry <= mostAsymmetry ? fit : std::nullopt;
  }

  void take(int id, const Eigen::Vector2d& place) {
    found_[id] = {place, {onBoard(id), lens_.undistort(place), 1}};
    refused_.erase(id);
  }

  /// Whether a known point lies close enough to a corner to search for it.
  bool isNear(int id) const {
    const auto observations = others(id);
    return std::any_of(observations.begin(), observations.end(),
                       [&](const PointMatch& one) { return (one.onBoard - onBoard(id)).norm() <= walkingDistance; });
  }

  void spread() {
    for (bool grown = true; grown;) {
      std::map<int, Eigen::Vector2d> fresh;
      for (int id = 0; id < cornerCount(pattern_); ++id) {
        if (found_.count(id) || !isNear(id)) {
          continue;
        }
        if (const auto fit = fitCornerAt(id, *fitLocalHomography(others(id), onBoard(id)))) {
          fresh[id] = fit->place;
        }
      }
      for (const auto& [id, place] : fresh) {
        take(id, place);
      }
      grown = !fresh.empty();
    }
  }

  /// Refines all corners again, now with an accurate local homography.
  void refine() {
    for (auto& [id, corner] : std::map{found_}) {
      const auto homography = fitLocalHomography(others(id), onBoard(id));
      if (const auto fit = fitCornerAt(id, *homography)) {
        take(id, fit->place);
      } else {
        found_.erase(id);
      }
    }
  }

  /// Rejects a misplaced corner.
  void refuse(int id, double distance) {
    refused_[id] = {id, found_.at(id).pixel, true,
                    fmt::format("lies {:.1f} px from where its neighbours put it", distance)};
    found_.erase(id);
  }

  /// Distance of a corner from its expected position [px]: geometric mean of the distances from two predictions, one
  /// with and one without the corner. In least squares it has the same scatter for all corners, whether central or
  /// barely determined by the others.
  double misplacement(int id) const {
    const auto distance = [&](const std::vector<PointMatch>& observations) {
      return (found_.at(id).pixel - pixel(*fitLocalHomography(observations, onBoard(id)), onBoard(id))).norm();
    };
    auto observations = others(id);
    const double without = distance(observations);
    observations.push_back(found_.at(id).observation);
    return std::sqrt(without * distance(observations));
  }

  void removeMisplaced() {
    for (;;) {
      std::vector<std::pair<double, int>> misplacements; // (distance, corner id)
      for (const auto& [id, corner] : found_) {
        misplacements.emplace_back(misplacement(id), id);
      }
      std::sort(misplacements.begin(), misplacements.end());
      if (misplacements.empty()) {
        return;
      }
      tolerance_ = std::clamp(timesMedian * misplacements[misplacements.size() / 2].first, tightest, loosest);
      const auto [worst, id] = misplacements.back();
      if (worst <= tolerance_) {
        return;
      }
      refuse(id, worst);
    }
  }

  /// Second pass over corners that were searched when little was known.
  void retryMissing() {
    for (int id = 0; id < cornerCount(pattern_); ++id) {
      const auto homography = fitLocalHomography(others(id), onBoard(id));
      if (found_.count(id) || !homography) {
        continue;
      }
      const Eigen::Vector2d expected = pixel(*homography, onBoard(id));
      if (const auto fit = fitCornerAt(id, *homography)) {
        take(id, fit->place);
        if (const double distance = misplacement(id); distance > tolerance_) {
          refuse(id, distance);
        }
      } else if (!refused_.count(id) && picture_.contains(expected)) {
        refused_[id] = {id, expected, false, "no crossing of four squares is seen there"};
      }
    }
  }

  const SmoothImage& picture_;
  const LensDistortion& lens_;
  const CharucoPattern& pattern_;
  const std::vector<PointMatch>& markerCorners_;
  double reach_;               // [squares]
  double tolerance_ = loosest; // [px]
  std::map<int, Found> found_;
  std::map<int, RejectedCorner> refused_;
};

constexpr double leastTolerance = 3; // [px]

constexpr double toleranceInSides = 0.1;

constexpr double markerWeight = 0.04; // relative to a refined corner: a marker corner is about five times less accurate

std::vector<PointMatch> matchMarker(const Marker& marker, const CharucoPattern& pattern, const LensDistortion& lens) {
  const auto onBoard = *markerOnBoard(pattern, marker.id);
  std::vector<PointMatch> result;
  for (std::size_t i = 0; i < 4; ++i) {
    result.push_back({onBoard[i], lens.undistort(marker.corners[i]), markerWeight});
  }
  return result;
}

} // namespace

BoardSearchResult searchBoard(const SmoothImage& picture, const LensDistortion& lens, const CharucoPattern& pattern,
                              const std::vector<PointMatch>& markerCorners) {
  return Walk{picture, lens, pattern, markerCorners}.result();
}

MarkerAgreement findAgreeingMarkers(const std::vector<Marker>& markers, const CharucoPattern& pattern,
                                    const LensDistortion& lens) {
  std::vector<cv::Point2d> onBoard, seenAt;
  for (const Marker& marker : markers) {
    for (const PointMatch& corner : matchMarker(marker, pattern, lens)) {
      onBoard.emplace_back(corner.onBoard.x(), corner.onBoard.y());
      seenAt.emplace_back(corner.seenAt.x(), corner.seenAt.y());
    }
  }
  const cv::Mat found = cv::findHomography(onBoard, seenAt, cv::RANSAC, leastTolerance);
  MarkerAgreement result;
  if (found.empty()) {
    result.others = markers;
    return result;
  }
  Eigen::Matrix3d homography;
  cv::cv2eigen(found, homography);
  for (const Marker& marker : markers) {
    const auto corners = matchMarker(marker, pattern, lens);
    const double side = (marker.corners[0] - marker.corners[2]).norm() / std::sqrt(2);
    const double tolerance = std::max(leastTolerance, toleranceInSides * side);
    const bool agrees = std::all_of(corners.begin(), corners.end(), [&](const PointMatch& corner) {
      return ((homography * corner.onBoard.homogeneous()).hnormalized() - corner.seenAt).norm() <= tolerance;
    });
    (agrees ? result.agreeing : result.others).push_back(marker);
    if (agrees) {
      result.corners.insert(result.corners.end(), corners.begin(), corners.end());
    }
  }
  return result;
}

} // namespace naocal
