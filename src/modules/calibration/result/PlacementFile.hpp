#pragma once

#include "calibration/result/CalibrationResult.hpp"
#include "data/Board.hpp"

#include <Eigen/Core>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace naocal {

/// The placements of a result, by name: of boards in their link or in the world, of everything else in the world, of
/// frames and markers in their link.
struct StoredPlacements {
  std::map<std::string, Placement> boards, stances, cameras, trackers, frames;
  std::map<std::string, Eigen::Vector3d> markers, places; // [m]
};

/// `placements` of RESULT.json: of boards and stances, and, as far as there are any, of cameras beside the robot,
/// trackers, markers, frames and places.
nlohmann::json placementsJson(const FittedModel& fitted);

/// Reads them. Throws nlohmann's exceptions.
StoredPlacements parsePlacements(const nlohmann::json& placements);

/// Sets the unknowns of a term that is a placement to the stored one. Returns false if none is stored.
bool placeAsStored(const StoredPlacements& stored, const Measurements& measurements, const Term& term,
                   Eigen::VectorXd& unknowns);

} // namespace naocal
