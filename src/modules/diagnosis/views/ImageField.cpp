#include "diagnosis/views/ImageField.hpp"

#include "diagnosis/views/ResidualField.hpp"
#include "estimation/DriverState.hpp"
#include "inference/Thresholds.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace naocal {

namespace {

constexpr Eigen::Index leastCorners = 4; // with three, the board's motion fits everything

constexpr double counts = 0.5; // weight above which a corner counts

constexpr double leastNoise = 0.01; // [px], lower limit of corner noise

/// Sums over a pose's repeats of one board in one camera, per corner.
struct RepeatSums {
  struct Corner {
    Eigen::Vector2d error = Eigen::Vector2d::Zero();
    double weight = 0, share = 0;
  };
  std::map<int, Corner> corners;

  void add(const MotionFreeResidual& observation, const Eigen::MatrixXd& freed) {
    for (std::size_t i = 0; i < observation.ids->size(); ++i) {
      const double weight = observation.errors->weight[eigenIndex(i)];
      Corner& corner = corners[(*observation.ids)[i]];
      corner.error += weight * freed.middleRows<2>(eigenIndex(2 * i));
      corner.weight += weight;
      corner.share += weight * observation.share;
    }
  }
};

/// Sum of squares of the repeats' means, and its degrees of freedom beside the boards' motions.
struct MeanSquares {
  double sum = 0, freedom = 0, corners = 0;

  void add(const RepeatSums& repeats) {
    double own = 0;
    for (const auto& [id, corner] : repeats.corners) {
      if (corner.share > counts) {
        sum += corner.share * (corner.error / corner.weight).squaredNorm();
        own += 1;
      }
    }
    corners += own;
    freedom += std::max(0.0, 2 * own - 6);
  }
};

/// `boards`: predictions of the observation's picture.
MotionFreeResidual removeMotions(const BoardResidual& errors, const ImageObservation& picture,
                                 const std::vector<PredictedBoard>& boards) {
  const BoardObservation& observation = picture.observations[errors.observation];
  MotionFreeResidual result{
      .errors = &errors, .ids = &observation.ids, .camera = picture.camera, .board = observation.view.board()};
  result.opticalFromBoard = boards[errors.observation].opticalFromBoard.rotation;
  result.weights = errors.weight.replicate(1, 2).transpose().reshaped();
  result.weighted = result.weights.asDiagonal() * errors.motionRows;
  result.motion.compute(errors.motionRows.transpose() * result.weighted);
  return result;
}

constexpr double plausibleShape = 0.001; // of a corner on its board [m]

constexpr double plausibleLens = 1; // of a polynomial coefficient, at the edge of the picture [px]

/// Position of a corner in the picture, about -1 to 1: (u, v) - (cx, cy), in units of cx. Uses the prediction, since
/// measured positions share the noise of the errors to explain.
Eigen::Vector2d cornerPlace(const Measurements& measurements, const MotionFreeResidual& observation,
                            Eigen::Index corner) {
  const auto lens = measurements.pictures[observation.errors->picture].nominal.lens();
  return (observation.errors->predicted.col(corner) - lens.segment<2>(2)) / lens[2];
}

/// Normal equations of a field's coefficients, without prior, and the squared errors.
struct FieldEquations {
  Eigen::MatrixXd gram;
  Eigen::VectorXd gradient;
  MeanSquares errors;
};

/// Estimates the coefficients along the directions that the errors determine.
FieldFit solveField(const FieldEquations& equations, double plausible) {
  const MeanSquares& errors = equations.errors;
  const Eigen::Index count = equations.gradient.size();
  const SymmetricEigen ways = symmetricEigen(equations.gram);
  const Eigen::VectorXd along = ways.vectors.transpose() * equations.gradient;
  // A first guess of the noise selects the determined directions: standard error up to five times `plausible`.
  const double guessed = std::max(errors.sum / std::max(1.0, errors.freedom), leastNoise * leastNoise);
  const double leastTold = guessed / std::pow(5 * plausible, 2);
  double explained = 0, freedom = 0; // over the determined directions
  for (Eigen::Index i = 0; i < count; ++i) {
    if (ways.values[i] > leastTold) {
      explained += along[i] * along[i] / ways.values[i];
      ++freedom;
    }
  }
  FieldFit result{.estimate = Eigen::VectorXd::Zero(count), .covariance = Eigen::MatrixXd::Zero(count, count)};
  constexpr double fewest = 10;
  const double remaining = errors.freedom - freedom;
  if (freedom < 1 || remaining < fewest) {
    return result;
  }
  result.freedom = freedom;
  const double noise = std::max((errors.sum - explained) / remaining, leastNoise * leastNoise);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double inNoise = ways.values[i] / noise;
    if (ways.values[i] > leastTold) {
      const double prior = inNoise * plausible * plausible, kept = prior / (1 + prior);
      const double found = along[i] / ways.values[i];
      result.estimate += kept * found * ways.vectors.col(i);
      result.covariance += kept / inNoise * ways.vectors.col(i) * ways.vectors.col(i).transpose();
      result.bayes += kept * inNoise * found * found - std::log1p(prior);
    }
  }
  result.rmsPx = std::sqrt(std::max(0.0, explained - freedom * noise) / (2 * errors.corners));
  result.share = errors.sum > 0 ? std::max(0.0, explained - freedom * noise) / errors.sum : 0;
  result.pValue = fTail(explained / freedom / noise, freedom, remaining);
  return result;
}

} // namespace

Eigen::RowVectorXd monomials(const Eigen::Vector2d& at, int most) {
  Eigen::RowVectorXd result((most + 1) * (most + 2) / 2);
  Eigen::Index k = 0;
  for (int degree = 0; degree <= most; ++degree) {
    for (int ofY = 0; ofY <= degree; ++ofY) {
      result[k++] = std::pow(at.x(), degree - ofY) * std::pow(at.y(), ofY);
    }
  }
  return result;
}

SheetBasis::SheetBasis(const std::vector<Eigen::Vector3d>& points) : points_{points} {
  for (const Eigen::Vector3d& point : points) {
    box_.extend(point.head<2>());
  }
}

Eigen::RowVectorXd SheetBasis::basis(std::size_t corner) const {
  constexpr int degree = 3;
  const Eigen::Vector2d at = points_[corner].head<2>() - box_.center();
  return monomials(at / std::max(1e-6, box_.sizes().maxCoeff() / 2), degree);
}

Eigen::MatrixXd MotionFreeResidual::removeMotion(const Eigen::MatrixXd& columns) const {
  return columns - errors->motionRows * motion.solve(weighted.transpose() * columns);
}

MotionFreeResiduals::MotionFreeResiduals(const FittedModel& fitted) {
  const std::vector<std::size_t> poseOf = posesOfPictures(fitted.measurements);
  using Repeats = std::array<std::size_t, 3>; // pose, camera, board
  std::map<Repeats, std::vector<std::size_t>> repeats;
  std::map<std::size_t, std::vector<PredictedBoard>> scenes; // by picture
  for (const BoardResidual& errors : fitted.fit.residuals) {
    if (errors.residual.allFinite() && (errors.weight.array() > counts).count() >= leastCorners) {
      const ImageObservation& picture = fitted.measurements.pictures[errors.picture];
      const auto [boards, fresh] = scenes.try_emplace(errors.picture);
      if (fresh) {
        boards->second = predictBoards(fitted.measurements, picture,
                                       predictState(fitted.measurements, fitted.model, picture, fitted.fit.unknowns));
      }
      const MotionFreeResidual& added = observations_.emplace_back(removeMotions(errors, picture, boards->second));
      repeats[{poseOf[errors.picture], added.camera, added.board}].push_back(observations_.size() - 1);
    }
  }
  std::size_t number = 0;
  for (const auto& [key, members] : repeats) {
    for (std::size_t member : members) {
      observations_[member].repeats = number;
      observations_[member].share = 1 / static_cast<double>(members.size());
    }
    ++number;
  }
}

FieldFit MotionFreeResiduals::fitField(Eigen::Index count, double plausible,
                                       const std::function<bool(const MotionFreeResidual&)>& chosen,
                                       const std::function<Eigen::MatrixXd(const MotionFreeResidual&)>& columns) const {
  FieldEquations equations{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count), {}};
  std::map<std::size_t, RepeatSums> repeats;
  for (const MotionFreeResidual& observation : observations_) {
    if (chosen(observation)) {
      const Eigen::MatrixXd own = columns(observation), weighted = observation.weights.asDiagonal() * own;
      const Eigen::MatrixXd left = observation.removeMotion(observation.errors->residual.reshaped());
      equations.gram += observation.share * weighted.transpose() * observation.removeMotion(own);
      equations.gradient += observation.share * weighted.transpose() * left;
      repeats[observation.repeats].add(observation, left);
    }
  }
  for (const auto& [number, sums] : repeats) {
    equations.errors.add(sums);
  }
  return solveField(equations, plausible);
}

ImageField fitCornerField(const MotionFreeResiduals& errors, const Measurements& measurements, std::size_t board) {
  const Eigen::Index count = 3 * eigenIndex(measurements.targets[board].board.points.size());
  return {ImageField::Of::corners, board,
          errors.fitField(
              count, plausibleShape, [&](const MotionFreeResidual& observation) { return observation.board == board; },
              [&](const MotionFreeResidual& observation) {
                Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(observation.errors->motionRows.rows(), count);
                for (std::size_t i = 0; i < observation.ids->size(); ++i) {
                  columns.block<2, 3>(eigenIndex(2 * i), 3 * (*observation.ids)[i]) = observation.cornerJacobian(i);
                }
                return columns;
              })};
}

ImageField fitSheetField(const MotionFreeResiduals& errors, const Measurements& measurements, std::size_t board) {
  const SheetBasis sheet{measurements.targets[board].board.points};
  const Eigen::Index terms = sheet.basis(0).size();
  return {ImageField::Of::sheet, board,
          errors.fitField(
              3 * terms, plausibleShape,
              [&](const MotionFreeResidual& observation) { return observation.board == board; },
              [&](const MotionFreeResidual& observation) {
                Eigen::MatrixXd columns(observation.errors->motionRows.rows(), 3 * terms);
                for (std::size_t i = 0; i < observation.ids->size(); ++i) {
                  const Eigen::RowVectorXd basis = sheet.basis(static_cast<std::size_t>((*observation.ids)[i]));
                  const Eigen::Matrix<double, 2, 3> byCorner = observation.cornerJacobian(i);
                  for (Eigen::Index axis = 0; axis < 3; ++axis) {
                    columns.block(eigenIndex(2 * i), axis * terms, 2, terms) = byCorner.col(axis) * basis;
                  }
                }
                return columns;
              })};
}

ImageField fitCameraField(const MotionFreeResiduals& errors, const Measurements& measurements, std::size_t camera) {
  const Eigen::Index terms = monomials({0, 0}, lensDegree).size();
  return {ImageField::Of::camera, camera,
          errors.fitField(
              2 * terms, plausibleLens,
              [&](const MotionFreeResidual& observation) { return observation.camera == camera; },
              [&](const MotionFreeResidual& observation) {
                const Eigen::Index corners = observation.errors->residual.cols();
                Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(2 * corners, 2 * terms);
                for (Eigen::Index i = 0; i < corners; ++i) {
                  columns.block(2 * i, 0, 1, terms) = monomials(cornerPlace(measurements, observation, i), lensDegree);
                  columns.block(2 * i + 1, terms, 1, terms) = columns.block(2 * i, 0, 1, terms);
                }
                return columns;
              })};
}

ImageField refitField(const ImageField& field, const MotionFreeResiduals& errors, const Measurements& measurements) {
  return field.of == ImageField::Of::corners ? fitCornerField(errors, measurements, field.at)
         : field.of == ImageField::Of::sheet ? fitSheetField(errors, measurements, field.at)
                                             : fitCameraField(errors, measurements, field.at);
}

std::optional<ImageField> findStrikingField(const FittedModel& fitted) {
  constexpr std::size_t fewCorners = 60; // of a board, to be looked at one by one: that takes their cube of time
  const MotionFreeResiduals errors{fitted};
  std::vector<ImageField> fields;
  for (std::size_t board = 0; board < fitted.measurements.targets.size(); ++board) {
    fields.push_back(fitSheetField(errors, fitted.measurements, board));
    if (fitted.measurements.targets[board].board.points.size() <= fewCorners) {
      fields.push_back(fitCornerField(errors, fitted.measurements, board));
    }
  }
  for (std::size_t camera = 0; camera < fitted.measurements.robot.cameras.size(); ++camera) {
    fields.push_back(fitCameraField(errors, fitted.measurements, camera));
  }
  const double p = threshold::fieldAlarm / static_cast<double>(fields.size());
  std::erase_if(fields, [&](const ImageField& field) {
    return field.fit.bayes < threshold::fieldEvidence || field.fit.pValue > p ||
           field.fit.rmsPx < threshold::negligiblePx;
  });
  const auto best = std::max_element(
      fields.begin(), fields.end(), [](const ImageField& a, const ImageField& b) { return a.fit.bayes < b.fit.bayes; });
  return best == fields.end() ? std::nullopt : std::optional{*best};
}

} // namespace naocal
