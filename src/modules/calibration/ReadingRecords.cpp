#include "calibration/ReadingRecords.hpp"

#include "estimation/DriverState.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace naocal {

namespace {

using nlohmann::json;

/// Positions of one capture that were read so far, in the file's order, which is that of its witnesses.
struct ReadSoFar {
  std::size_t points = 0, frames = 0;
};

/// Index of the place that a contact depends on.
std::size_t touchedPlace(const Measurements& measurements, const Witness& contact) {
  std::size_t place = 0;
  while (std::find(contact.own().begin(), contact.own().end(), measurements.quantities.place(place)) ==
         contact.own().end()) {
    ++place;
  }
  return place;
}

ReadingRecord::Error worldError(const Eigen::VectorXd& residual, const Eigen::Matrix3d& worldFromInstrument) {
  ReadingRecord::Error error{worldFromInstrument * residual.head<3>(), Eigen::Vector3d::Zero()};
  if (residual.size() == 6) {
    error.turn = worldFromInstrument * residual.tail<3>();
  }
  return error;
}

/// The reading behind a witness, without its errors, and the rotation from the axes of its residual to the world's.
std::pair<ReadingRecord, Eigen::Matrix3d> readingOf(const Measurements& measurements, const WitnessResidual& one,
                                                    const ModelState& placements, ReadSoFar& seen) {
  const ImageObservation& picture = measurements.pictures[one.picture];
  const Witness& witness = *picture.witnesses[one.witness].witness;
  const Capture& capture = measurements.captureOf(picture);
  const InstrumentList& all = measurements.instruments;
  ReadingRecord record{.picture = one.picture,
                       .instrument = measurements.levels[witness.parts().front().level].name,
                       .target = witness.target()};
  if (record.instrument == contactLevel) {
    const std::size_t place = touchedPlace(measurements, witness);
    record.kind = ReadingRecord::Kind::contact;
    record.place = all.places[place].name;
    record.measured = placements.place(place);
    return {record, Eigen::Matrix3d::Identity()};
  }
  const std::size_t tracker = indexOf(all.trackers, record.instrument);
  const RigidTransform worldFromTracker =
      all.trackers[tracker].reference * transformFromPlacement(placements.trackerPlacement(tracker));
  const bool isFrame = witness.parts().size() > 1;
  record.kind = isFrame ? ReadingRecord::Kind::frame : ReadingRecord::Kind::point;
  record.measured =
      worldFromTracker * (isFrame ? capture.frames[seen.frames++].xyz : capture.points[seen.points++].xyz);
  return {record, worldFromTracker.rotation};
}

json roundedPoint(const Eigen::Vector3d& point) {
  constexpr double finest = 1e7; // per metre or radian
  json list = json::array();
  for (const double value : point) {
    list.push_back(std::round(finest * value) / finest);
  }
  return list;
}

} // namespace

std::vector<ReadingRecord> recordReadings(const FittedModel& fitted) {
  const Measurements& measurements = fitted.measurements;
  if (measurements.witnessCount == 0) {
    return {};
  }
  const Residuals residuals{measurements, fitted.model, fitted.fit.noise, fitted.fit.loss};
  const std::vector<WitnessResidual> reported = residuals.witnessResiduals(residuals.startState(fitted.fit.unknowns));
  const std::vector<WitnessResidual> moved = residuals.witnessResiduals(fitted.fit.state);
  assert(reported.size() == moved.size());
  std::vector<ReadingRecord> records;
  const ModelState placements =
      predictState(measurements, fitted.model, measurements.pictures.front(), fitted.fit.unknowns);
  std::vector<ReadSoFar> seen(measurements.pictures.size());
  for (std::size_t i = 0; i < reported.size(); ++i) {
    const ImageObservation& picture = measurements.pictures[reported[i].picture];
    if (!picture.witnesses[reported[i].witness].view) {
      continue; // a distance between places, which no capture measured
    }
    auto [record, worldFromInstrument] = readingOf(measurements, reported[i], placements, seen[reported[i].picture]);
    record.reported = worldError(reported[i].residual, worldFromInstrument);
    record.fitted = worldError(moved[i].residual, worldFromInstrument);
    records.push_back(std::move(record));
  }
  return records;
}

json toJson(const ReadingRecord& record) {
  static const std::array<const char*, 3> kinds{"point", "frame", "contact"};
  json result{{"kind", kinds[static_cast<std::size_t>(record.kind)]},
              {"instrument", record.instrument},
              {"target", record.target},
              {"measured", roundedPoint(record.measured)},
              {"predicted", roundedPoint(record.measured + record.reported.shift)},
              {"fitted", roundedPoint(record.measured + record.fitted.shift)}};
  if (!record.place.empty()) {
    result["place"] = record.place;
  }
  if (record.kind == ReadingRecord::Kind::frame) {
    result["turn"] = {{"predicted", roundedPoint(record.reported.turn)}, {"fitted", roundedPoint(record.fitted.turn)}};
  }
  return result;
}

std::vector<ReadingLevel> readingLevels(const Measurements& measurements, const Noise& noise) {
  std::vector<ReadingLevel> levels = measurements.levels;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels[i].sigma = sigmaOf(measurements, noise, i);
  }
  return levels;
}

json toJson(const std::vector<ReadingLevel>& levels) {
  json result = json::object();
  for (const ReadingLevel& level : levels) {
    result[level.name][level.unit == ReadingLevel::Unit::metres ? "metres" : "radians"] = {
        {"sigma", level.sigma}, {"source", level.isGiven ? "given" : "estimated"}};
  }
  return result;
}

} // namespace naocal
