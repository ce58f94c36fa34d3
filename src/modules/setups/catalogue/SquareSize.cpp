#include "calibration/Fit.hpp"
#include "estimation/ModelBuilder.hpp"
#include "setups/CaptureSelection.hpp"
#include "setups/Catalogue.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <set>

namespace naocal {

namespace {

constexpr char everyBoard[] = "all";

/// Ids of the boards that were seen.
std::set<std::string> seenBoards(const Measurements& measurements) {
  std::set<std::string> ids;
  for (const ImageObservation& picture : measurements.pictures) {
    for (const BoardObservation& observation : picture.observations) {
      ids.insert(measurements.targets[observation.view.board()].board.id);
    }
  }
  return ids;
}

void scaleBoards(std::vector<CaptureSet>& sets, const std::string& id, double factor) {
  for (CaptureSet& set : sets) {
    for (Board& board : set.boards) {
      if (id != everyBoard && board.id != id) {
        continue;
      }
      for (Eigen::Vector3d& point : board.points) {
        point *= factor;
      }
      if (board.pattern) {
        board.pattern->squareLength *= factor;
        board.pattern->markerLength *= factor;
      }
    }
  }
}

/// Labels of the scale of a board, in every set; with every board, of the one that all share.
std::vector<std::string> scalesOf(const Measurements& measurements, const std::string& id) {
  std::vector<std::string> labels;
  for (const Target& target : measurements.targets) {
    if (target.board.id == id) {
      labels.push_back(boardScale().name + '@' + target.name);
    }
  }
  return labels.empty() ? std::vector{boardScale().name + '@' + id} : labels;
}

/// A factor on the file's size, and the cost of the fit that found it.
struct EstimatedFactor {
  double factor = 1, cost = std::numeric_limits<double>::infinity();
};

/// The size of a board's squares relative to the file's, by a fit that starts with squares `start` times as large.
std::optional<EstimatedFactor> estimateFactor(Recording recording, const std::string& id, double start) {
  try {
    scaleBoards(recording.sets, id, start);
    const Measurements measurements = buildMeasurements(std::move(recording.sets), recording.robot);
    const std::vector<std::string> labels = scalesOf(measurements, id);
    const Model model = buildModel(measurements, labels);
    const Fit fit = fitInitially(measurements, model, Noise{.encoder = 0}, {.maxIterations = 30});
    const std::size_t scale = model.find(labels.front())->first;
    return EstimatedFactor{start * (1 + fit.minimum.state.unknowns[static_cast<Eigen::Index>(scale)]),
                           fit.minimum.linear.cost};
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// The same from several starts, in a part of the captures. Absent if no fit is possible, or if these captures tell
/// nothing of the size: those of a camera that stands anywhere beside the robot.
std::optional<double> estimateFactor(const Measurements& measurements, const std::string& id) {
  const std::size_t unknowns = buildModel(measurements).unknownCount();
  const Recording part = selectCaptures(measurements, unknowns).of({*measurements.sets, measurements.robot});
  EstimatedFactor best;
  for (const double start : {1.0, 5.0, 0.2, 25.0, 0.04}) {
    const auto estimate = estimateFactor(part, id, start);
    best = estimate && estimate->cost < best.cost ? *estimate : best;
  }
  return best.factor > 0 && std::isfinite(best.cost) ? std::optional{best.factor} : std::nullopt;
}

std::string describe(const std::string& id, double factor) {
  const std::string whose = id == everyBoard ? "all boards" : "board " + id;
  return factor > 2 || factor < 0.5
             ? fmt::format("the squares of {} are {:.4g} times {} than the file says: measure the print and correct "
                           "squareLength",
                           whose, std::max(factor, 1 / factor), factor > 1 ? "larger" : "smaller")
             : fmt::format("the squares of {} are {:.1f} % {} than the file says: measure the print and correct "
                           "squareLength",
                           whose, 100 * std::abs(factor - 1), factor > 1 ? "larger" : "smaller");
}

} // namespace

/// The squares of a print have another size than the file says: another unit, or a print that was scaled.
SetUp squareSize() {
  return {.name = "squareSize",
          .description = "the squares of the board have another size than the file says",
          .question = "How long is a square of board {}, measured on the print?",
          .listPlaces =
              [](const Measurements& measurements) {
                const std::set<std::string> ids = seenBoards(measurements);
                std::vector<std::string> places{ids.begin(), ids.end()};
                if (places.size() > 1) {
                  places.insert(places.begin(), everyBoard);
                }
                return places;
              },
          .listMendings =
              [](const Measurements& measurements, const std::string& id) {
                constexpr double inch = 0.0254;       // [m]
                constexpr double leastMistake = 0.08; // of the size: less is what printers and paper do (boardScale)
                constexpr double alike = 0.03;        // relative
                std::vector<double> factors{10, 0.1, 1e3, 1e-3, inch, 1 / inch};
                const auto estimated = estimateFactor(measurements, id);
                const bool isNew = estimated && std::abs(*estimated - 1) > leastMistake &&
                                   std::none_of(factors.begin(), factors.end(), [&](double factor) {
                                     return std::abs(*estimated / factor - 1) < alike;
                                   });
                if (isNew) {
                  factors.push_back(*estimated);
                }
                std::vector<Mending> ways;
                for (const double factor : factors) {
                  ways.push_back({describe(id, factor),
                                  [id, factor](Recording& recording) { scaleBoards(recording.sets, id, factor); }});
                }
                return ways;
              }};
}

} // namespace naocal
