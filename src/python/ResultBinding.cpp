#include "python/Bindings.hpp"
#include "python/Documents.hpp"
#include "python/Keywords.hpp"
#include "python/LongCall.hpp"
#include "python/Solved.hpp"
#include "python/Views.hpp"

#include "calibration/result/Verdict.hpp"
#include "diagnosis/CheckedCalibration.hpp"
#include "estimation/ModelBuilder.hpp"
#include "estimation/ModelFile.hpp"
#include "io/FileKind.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace naocal {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

using SharedSolved = std::shared_ptr<Solved>;

/// The corners of one board in one capture, measured and predicted.
struct SightingHandle {
  SharedSolved solved;
  std::size_t index; // in `CalibrationResult::residuals`

  const BoardResidual& fitted() const { return solved->fit.residuals[index]; }
  const BoardResidual& predicted() const { return solved->fit.withReportedAngles[index]; }
  const ImageObservation& picture() const { return solved->captures->measurements.pictures[fitted().picture]; }
  const BoardObservation& observation() const { return picture().observations[fitted().observation]; }
  const Capture& capture() const { return solved->captures->measurements.captureOf(picture()); }
  const std::string& board() const { return solved->captures->measurements.targets[observation().view.board()].name; }
};

/// One unknown with its unit.
struct EstimateHandle {
  std::string unit;
  Estimate estimate;
};

/// Which model to fit, and how. Throws InputError for numbers beyond the ranges of 'naocal solve'.
CalibrationOptions readOptions(const Keywords& given) {
  CalibrationOptions options;
  given.take("restarts", options.restarts, 0, 1000);
  given.take("seed", options.seed);
  given.take("robust", options.robust);
  given.take("estimate_noise", options.estimateNoise);
  given.take("pixel_noise", options.noise.pixel, 0.001, 100.0);
  given.take("encoder_noise", options.noise.encoder, 1e-7, 0.1);
  given.take("pose_noise", options.noise.pose, 0.0, 0.1);
  if (given.has("tolerance")) {
    given.take("tolerance", options.tolerance.emplace(), 1e-6, 10.0);
  }
  given.take("stance_noise", options.noise.stance, 0.0, 0.1);
  options.pixelGiven = given.has("pixel_noise");
  return options;
}

/// The model that was asked for. `candidates`: receives the effects of a model file, if one is given.
Model readModel(const Keywords& given, const Measurements& measurements, std::vector<Effect>& candidates) {
  std::vector<std::string> effects, without;
  given.take("effects", effects);
  given.take("without", without);
  std::filesystem::path path;
  given.take("model", path);
  if (path.empty()) {
    return buildModel(measurements, effects, without);
  }
  ModelFile file = readModelFile(path, measurements.robot);
  file.with.insert(file.with.end(), effects.begin(), effects.end());
  file.without.insert(file.without.end(), without.begin(), without.end());
  candidates = std::move(file.effects);
  return buildModel(measurements, file.with, file.without, candidates);
}

SharedSolved solve(const std::shared_ptr<Captures>& captures, const py::kwargs& keywords) {
  const Keywords given{keywords};
  CalibrationOptions options = readOptions(given);
  Model model = readModel(given, captures->measurements, options.effects);
  LongCall call{given.object("progress")};
  return call.run([&] {
    CalibrationResult fit = calibrateChecked(captures->measurements, model, options);
    return std::make_shared<Solved>(Solved{captures, std::move(model), std::move(fit)});
  });
}

std::vector<SightingHandle> listSightings(const SharedSolved& solved) {
  std::vector<SightingHandle> list;
  for (std::size_t i = 0; i < solved->fit.residuals.size(); ++i) {
    list.push_back({solved, i});
  }
  return list;
}

/// Estimates by the unknowns' names; placements, too.
py::dict listEstimates(const Solved& solved) {
  const std::vector<std::string> names = solved.model.names(), units = solved.model.units();
  py::dict estimates;
  for (std::size_t i = 0; i < names.size(); ++i) {
    estimates[py::str(names[i])] = EstimateHandle{units[i], solved.fit.estimates[i]};
  }
  return estimates;
}

py::array_t<double> listSigmas(const Solved& solved) {
  py::array_t<double> sigmas(std::ssize(solved.fit.estimates));
  for (py::ssize_t i = 0; i < sigmas.size(); ++i) {
    sigmas.mutable_at(i) = solved.fit.estimates[static_cast<std::size_t>(i)].sigma;
  }
  return sigmas;
}

/// Labels of the effects, without placements.
std::vector<std::string> listEffects(const Solved& solved) {
  std::vector<std::string> labels;
  for (const Term& term : solved.model.terms()) {
    if (!term.isPlacement) {
      labels.push_back(term.label());
    }
  }
  return labels;
}

/// A property that shows the points or weights which `get` finds in a sighting.
template <class Get> auto viewSighting(const Get& get) {
  return [get](const py::object& self) { return viewOf(get(self.cast<const SightingHandle&>()), self); };
}

py::object describeShoulder(const EstimateHandle& self) {
  const auto& averaged = self.estimate.averaged;
  return averaged ? toDictionary(averagedJson(*averaged).at("shoulder")) : py::none();
}

void bindEstimate(py::module_& module) {
  py::class_<EstimateHandle>(module, "Estimate", "Estimate of one unknown, in `unit`.")
      .def_property_readonly(
          "value", [](const EstimateHandle& self) { return self.estimate.value; },
          "Under the model as given: what predictions use.")
      .def_property_readonly(
          "sigma", [](const EstimateHandle& self) { return self.estimate.sigma; }, "Standard error of `value`.")
      .def_property_readonly(
          "best", [](const EstimateHandle& self) { return self.estimate.best(); },
          "Averaged over what may be missing, where that was tested; otherwise `value`.")
      .def_property_readonly(
          "best_sigma", [](const EstimateHandle& self) { return self.estimate.bestSigma(); },
          "Standard error of `best`.")
      .def_property_readonly(
          "interval", [](const EstimateHandle& self) { return self.estimate.interval(); },
          "95 % interval of `best`: [low, high].")
      .def_property_readonly(
          "bound",
          [](const EstimateHandle& self) {
            const auto& averaged = self.estimate.averaged;
            return averaged ? std::optional{averaged->bound} : std::nullopt;
          },
          "99.95 % bound of `best`: [low, high]; None where it is no average.")
      .def_property_readonly("shoulder", describeShoulder,
                             "What alone makes `bound` much wider: {'effects', 'without', 'weight', 'value'}, or None.")
      .def_property_readonly(
          "learned", [](const EstimateHandle& self) { return self.estimate.learned; },
          "1 - posterior sigma / prior sigma: 0 where the captures tell nothing.")
      .def_property_readonly("degrees_of_freedom", [](const EstimateHandle& self) { return self.estimate.freedom; })
      .def_readonly("unit", &EstimateHandle::unit)
      .def("__repr__", [](const EstimateHandle& self) {
        return fmt::format("<naocal.Estimate: {:.4g} +- {:.2g} {}>", self.estimate.best(), self.estimate.bestSigma(),
                           self.unit);
      });
}

void bindSightingViews(py::class_<SightingHandle>& sighting) {
  sighting
      .def_property_readonly("ids", viewSighting([](const SightingHandle& self) -> const std::vector<int>& {
                               return self.observation().ids;
                             }),
                             "Numbers of the corners on the board, (n,) int32. A view.")
      .def_property_readonly("predicted", viewSighting([](const SightingHandle& self) -> const auto& {
                               return self.predicted().predicted;
                             }),
                             "Predicted at the joint angles as read [px], (n, 2). A view.")
      .def_property_readonly(
          "residual", viewSighting([](const SightingHandle& self) -> const auto& { return self.predicted().residual; }),
          "Measured minus `predicted` [px], (n, 2). A view.")
      .def_property_readonly(
          "fitted", viewSighting([](const SightingHandle& self) -> const auto& { return self.fitted().predicted; }),
          "Predicted with the joints' estimated random deflections [px], (n, 2). A view.")
      .def_property_readonly("fitted_residual", viewSighting([](const SightingHandle& self) -> const auto& {
                               return self.fitted().residual;
                             }),
                             "Measured minus `fitted` [px], (n, 2). A view.")
      .def_property_readonly(
          "weight", viewSighting([](const SightingHandle& self) -> const auto& { return self.fitted().weight; }),
          "Weight of each corner in the fit, 0 to 1, (n,). A view.")
      .def_property_readonly(
          "measured",
          [](const SightingHandle& self) {
            const Eigen::Matrix2Xd points = self.fitted().predicted + self.fitted().residual;
            return py::array_t<double>({points.cols(), Eigen::Index{2}}, points.data());
          },
          "Measured corners in the distorted picture [px], (n, 2). A copy.");
}

void bindSighting(py::module_& module) {
  py::class_<SightingHandle> sighting(module, "Sighting",
                                      "The corners of one board in one capture, measured and predicted.");
  sighting
      .def_property_readonly(
          "set",
          [](const SightingHandle& self) { return self.solved->captures->measurements.setOf(self.picture()).name; })
      .def_property_readonly(
          "capture", [](const SightingHandle& self) { return self.capture().id; }, "The capture's id in its set.")
      .def_property_readonly("pose", [](const SightingHandle& self) { return self.capture().pose; })
      .def_property_readonly("camera", [](const SightingHandle& self) { return self.capture().camera; })
      .def_property_readonly("board", &SightingHandle::board)
      .def("__len__", [](const SightingHandle& self) { return self.observation().ids.size(); })
      .def("__repr__", [](const SightingHandle& self) {
        return fmt::format("<naocal.Sighting: board {} in capture {}, camera {}, {} corners>", self.board(),
                           self.capture().id, self.capture().camera, self.observation().ids.size());
      });
  bindSightingViews(sighting);
}

/// What was fitted: views of the unknowns, and estimates one by one.
void bindUnknowns(py::class_<Solved, SharedSolved>& result) {
  result
      .def_property_readonly(
          "names", [](const Solved& self) { return self.model.names(); },
          "Names of the unknowns, such as 'jointOffset@LKneePitch.o': the order of `unknowns`.")
      .def_property_readonly("units", [](const Solved& self) { return self.model.units(); })
      .def_property_readonly(
          "unknowns", [](const py::object& self) { return viewOf(self.cast<const Solved&>().fit.unknowns, self); },
          "Estimates under the model as given, (unknowns,), in `units`. A view.")
      .def_property_readonly("sigmas", listSigmas, "Standard errors of `unknowns`, (unknowns,). A copy.")
      .def_property_readonly(
          "covariance", [](const py::object& self) { return viewOf(self.cast<const Solved&>().fit.covariance, self); },
          "Covariance of `unknowns`, (unknowns, unknowns). A view.")
      .def_property_readonly("estimates", listEstimates, "Estimate by the unknown's name.")
      .def_property_readonly("effects", listEffects, "Labels of the model's effects.")
      .def_property_readonly("sightings", listSightings, "List of Sighting: every board in every capture.");
}

void bindFit(py::class_<Solved, SharedSolved>& result) {
  result
      .def_property_readonly(
          "verdict", [](const Solved& self) { return toString(self.fit.verdict); },
          "'good', 'cause-missing' (usable, but something is missing) or 'do-not-use'.")
      .def_property_readonly("usable", [](const Solved& self) { return self.fit.usable; })
      .def_property_readonly("converged", [](const Solved& self) { return self.fit.converged; })
      .def_property_readonly(
          "sentence", [](const Solved& self) { return self.fit.sentence; }, "The verdict in words.")
      .def_property_readonly(
          "suspicious", [](const Solved& self) { return self.fit.suspicious; }, "List of Suspicion.")
      .def_property_readonly(
          "set_ups", [](const Solved& self) { return labelsOf(self.fit.setUps); },
          "Labels of mistakes of the set-up that explain the misfit, such as 'reversedJoint@elbow'.")
      .def_property_readonly(
          "findings", [](const Solved& self) { return toDictionary(toJson(self.fit.findings)); },
          "Everything to know of it, most serious first: 'findings' of the file.")
      .def_property_readonly(
          "rms_px", [](const Solved& self) { return self.fit.rmsPx; },
          "Distance of the corners from `Sighting.predicted`, rms [px].")
      .def_property_readonly("median_px", [](const Solved& self) { return self.fit.medianPx; })
      .def_property_readonly(
          "noise_floor_px", [](const Solved& self) { return self.fit.noiseFloorPx; },
          "Expected rms distance under noise alone [px].")
      .def_property_readonly("chi2", [](const Solved& self) { return self.fit.chi2; })
      .def_property_readonly("dof", [](const Solved& self) { return self.fit.dof; })
      .def_property_readonly(
          "p_value", [](const Solved& self) { return self.fit.pValue; },
          "Probability that noise alone shows such strong evidence for a missing effect.")
      .def_property_readonly(
          "misfit", [](const Solved& self) { return self.fit.misfit; }, "chi2 / freedom between poses, at least 1.")
      .def_property_readonly(
          "task", [](const Solved& self) { return toDictionary(taskJson(self.fit)); },
          "Error at the task: {'what', 'unit', 'sigma', 'bound', 'tolerance'}, or None.")
      .def_property_readonly(
          "undetectable", [](const Solved& self) { return toDictionary(undetectableJson(self.fit)); },
          "The effect that can do most unnoticed: {'effect', 'bias', 'pose'}, or None.")
      .def_property_readonly("iterations", [](const Solved& self) { return self.fit.iterations; })
      .def_property_readonly("seconds", [](const Solved& self) { return self.fit.seconds; });
}

} // namespace

nlohmann::json Solved::json() const {
  return resultJson(fitted(), captures->sources);
}

void bindResult(py::module_& module) {
  bindEstimate(module);
  bindSighting(module);
  py::class_<Solved, SharedSolved> result(module, "Result", "A calibration: what 'naocal solve' writes.");
  bindFit(result);
  bindUnknowns(result);
  result
      .def(
          "to_dict", [](const Solved& self) { return toDictionary(self.json()); },
          "The file that 'naocal solve -o' writes, as a dictionary.")
      .def(
          "write", [](const Solved& self, const std::filesystem::path& file) { replaceJson(file, self.json()); },
          "file"_a,
          "Writes the file of 'naocal solve -o' whole or not at all. InputError if another kind of file is there.")
      .def("__repr__", [](const Solved& self) {
        return fmt::format("<naocal.Result: {}, {:.2f} px rms, {} unknowns>", toString(self.fit.verdict),
                           self.fit.rmsPx, self.model.unknownCount());
      });
  module.def("solve", solve, "captures"_a.none(false));
}

} // namespace naocal
