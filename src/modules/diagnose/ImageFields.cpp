#include "diagnose/ImageFields.hpp"

#include "diagnose/FieldBasis.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>

namespace naocal {

namespace {

constexpr double plausibleShape = 0.001; // of a corner on its board [m]
constexpr double plausibleLens = 1;      // of a polynomial's coefficient, at the picture's rim [px]

/// Where in the picture a corner is, about -1 to 1 across: (u, v) - (cx, cy), in units of cx. As predicted: measured
/// places share the noise of the errors that they would explain.
Eigen::Vector2d place(const Measurements& measurements, const FreedSighting& sighting, Eigen::Index corner) {
  const auto lens = measurements.pictures[sighting.errors->picture].drawn.lens();
  return (sighting.errors->predicted.col(corner) - lens.segment<2>(2)) / lens[2];
}

} // namespace

ImageField cornerField(const FreedErrors& errors, const Measurements& measurements, std::size_t board) {
  const Eigen::Index count = 3 * at(measurements.targets[board].board.points.size());
  return {ImageField::Of::corners, board,
          errors.fitted(
              count, plausibleShape, [&](const FreedSighting& sighting) { return sighting.board == board; },
              [&](const FreedSighting& sighting) {
                Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(sighting.errors->motionRows.rows(), count);
                for (std::size_t i = 0; i < sighting.ids->size(); ++i) {
                  columns.block<2, 3>(at(2 * i), 3 * (*sighting.ids)[i]) = sighting.byCorner(i);
                }
                return columns;
              })};
}

ImageField sheetField(const FreedErrors& errors, const Measurements& measurements, std::size_t board) {
  const Sheet sheet{measurements.targets[board].board.points};
  const Eigen::Index terms = sheet.basis(0).size();
  return {ImageField::Of::sheet, board,
          errors.fitted(
              3 * terms, plausibleShape, [&](const FreedSighting& sighting) { return sighting.board == board; },
              [&](const FreedSighting& sighting) {
                Eigen::MatrixXd columns(sighting.errors->motionRows.rows(), 3 * terms);
                for (std::size_t i = 0; i < sighting.ids->size(); ++i) {
                  const Eigen::RowVectorXd basis = sheet.basis(static_cast<std::size_t>((*sighting.ids)[i]));
                  const Eigen::Matrix<double, 2, 3> byCorner = sighting.byCorner(i);
                  for (Eigen::Index axis = 0; axis < 3; ++axis) {
                    columns.block(at(2 * i), axis * terms, 2, terms) = byCorner.col(axis) * basis;
                  }
                }
                return columns;
              })};
}

ImageField cameraField(const FreedErrors& errors, const Measurements& measurements, std::size_t camera) {
  const Eigen::Index terms = monomials({0, 0}, lensDegree).size();
  return {ImageField::Of::camera, camera,
          errors.fitted(
              2 * terms, plausibleLens, [&](const FreedSighting& sighting) { return sighting.camera == camera; },
              [&](const FreedSighting& sighting) {
                const Eigen::Index corners = sighting.errors->residual.cols();
                Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(2 * corners, 2 * terms);
                for (Eigen::Index i = 0; i < corners; ++i) {
                  columns.block(2 * i, 0, 1, terms) = monomials(place(measurements, sighting, i), lensDegree);
                  columns.block(2 * i + 1, terms, 1, terms) = columns.block(2 * i, 0, 1, terms);
                }
                return columns;
              })};
}

ImageField again(const ImageField& field, const FreedErrors& errors, const Measurements& measurements) {
  return field.of == ImageField::Of::corners ? cornerField(errors, measurements, field.at)
         : field.of == ImageField::Of::sheet ? sheetField(errors, measurements, field.at)
                                             : cameraField(errors, measurements, field.at);
}

std::optional<ImageField> strikingField(const Measurements& measurements, const Model& model,
                                        const CalibrationResult& fit) {
  constexpr double surely = 6;           // 2 ln of a Bayes factor
  constexpr double byChance = 0.001;     // in all fields together
  constexpr std::size_t fewCorners = 60; // of a board, to be looked at one by one: that takes their cube of time
  constexpr double known = 0.1;          // no lens, no detector and no printer is known better [px]
  const FreedErrors errors{measurements, model, fit};
  std::vector<ImageField> fields;
  for (std::size_t board = 0; board < measurements.targets.size(); ++board) {
    fields.push_back(sheetField(errors, measurements, board));
    if (measurements.targets[board].board.points.size() <= fewCorners) {
      fields.push_back(cornerField(errors, measurements, board));
    }
  }
  for (std::size_t camera = 0; camera < measurements.robot.cameras.size(); ++camera) {
    fields.push_back(cameraField(errors, measurements, camera));
  }
  const double p = byChance / static_cast<double>(fields.size());
  std::erase_if(fields, [&](const ImageField& field) {
    return field.fit.bayes < surely || field.fit.pValue > p || field.fit.rmsPx < known;
  });
  const auto best = std::max_element(
      fields.begin(), fields.end(), [](const ImageField& a, const ImageField& b) { return a.fit.bayes < b.fit.bayes; });
  return best == fields.end() ? std::nullopt : std::optional{*best};
}

} // namespace naocal
