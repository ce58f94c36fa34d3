#include "python/Bindings.hpp"
#include "python/Documents.hpp"
#include "python/Keywords.hpp"
#include "python/LongCall.hpp"
#include "python/SharedCaptures.hpp"
#include "python/Views.hpp"

#include "diagnosis/DiagnosisFile.hpp"
#include "diagnosis/DiagnosisWording.hpp"
#include "estimation/ModelFile.hpp"
#include "io/FileKind.hpp"
#include "io/InputError.hpp"
#include "poses/PoseFile.hpp"
#include "scenes/SceneNextPoses.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace naocal {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

/// A diagnosis with what it was made from: Python's `Diagnosis`.
struct Diagnosed {
  SharedCaptures captures;
  Diagnosis diagnosis;
  NextPoses next;

  /// DIAGNOSIS.json.
  nlohmann::json json(bool full) const {
    nlohmann::json json = diagnosisJson(diagnosis, full ? allOfThem : drawable);
    json["next"] = nextPosesJson(next, captures->measurements.robot);
    json["inputs"] = {{"sets", captures->sources.sets}, {"sha256", captures->sources.sha256}};
    return json;
  }
};

using SharedDiagnosed = std::shared_ptr<Diagnosed>;

/// Parts of a diagnosis, which stays alive with them.
struct CandidateHandle {
  SharedDiagnosed diagnosed;
  const CandidateFinding* finding;
};
struct CurveHandle {
  SharedDiagnosed diagnosed;
  const DriverCurve* curve;
};

DiagnosisOptions readOptions(const Keywords& given, const Robot& robot) {
  DiagnosisOptions options;
  given.take("effects", options.with);
  given.take("without", options.without);
  given.take("seed", options.calibration.candidateTests.seed);
  given.take("draws", options.calibration.candidateTests.draws, Eigen::Index{19}, Eigen::Index{100'000});
  std::filesystem::path path;
  given.take("model", path);
  if (!path.empty()) {
    ModelFile file = readModelFile(path, robot);
    options.with.insert(options.with.end(), file.with.begin(), file.with.end());
    options.without.insert(options.without.end(), file.without.begin(), file.without.end());
    options.calibration.effects = std::move(file.effects);
  }
  return options;
}

SharedDiagnosed diagnoseCaptures(const std::shared_ptr<Captures>& captures, const py::kwargs& keywords) {
  const Keywords given{keywords};
  const Measurements& measurements = captures->measurements;
  DiagnosisOptions options = readOptions(given, measurements.robot);
  std::size_t count = NextPosesOptions{}.count;
  given.take("next_count", count, std::size_t{0}, std::size_t{100});
  LongCall call{given.object("progress")};
  const std::size_t most = 2 + measurements.poses.size() / 4; // models tested
  std::size_t done = 0;
  options.shouldContinue = [&](std::size_t) {
    call.report(std::min(++done, most - 1), most);
    return true;
  };
  return call.run([&] {
    Diagnosis diagnosis = diagnose(measurements, options);
    NextPoses next = proposeSceneNextPoses(measurements, diagnosis, options,
                                           {.count = count, .seed = options.calibration.candidateTests.seed});
    call.report(most, most);
    return std::make_shared<Diagnosed>(Diagnosed{captures, std::move(diagnosis), std::move(next)});
  });
}

std::vector<CandidateHandle> listCandidates(const SharedDiagnosed& diagnosed) {
  std::vector<CandidateHandle> list;
  for (const CandidateFinding& finding : diagnosed->diagnosis.ranking) {
    list.push_back({diagnosed, &finding});
  }
  return list;
}

std::vector<CurveHandle> listCurves(const SharedDiagnosed& diagnosed) {
  std::vector<CurveHandle> list;
  for (const DriverCurve& curve : diagnosed->diagnosis.driverCurves) {
    list.push_back({diagnosed, &curve});
  }
  return list;
}

/// Name -> (value, sigma, unit) of a candidate's unknowns; empty where it was not tested.
py::dict listUnknowns(const CandidateHandle& self) {
  const auto& [owner, finding] = self;
  const auto& unknowns = finding->term.effect.unknowns;
  py::dict list;
  for (Eigen::Index i = 0; i < std::min(finding->evidence.estimate.size(), Eigen::Index{std::ssize(unknowns)}); ++i) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(i)];
    list[py::str(unknown.name)] =
        py::make_tuple(finding->evidence.estimate[i], std::sqrt(finding->evidence.covariance(i, i)), unknown.unit);
  }
  return list;
}

/// A property of the finding.
template <class Get> auto get(const Get& get) {
  return [get](const CandidateHandle& self) { return get(*self.finding); };
}

void bindCandidate(py::module_& module) {
  using Finding = const CandidateFinding&;
  py::class_<CandidateHandle>(module, "Candidate", "An effect at one place, and whether the captures require it.")
      .def_property_readonly("label", get([](Finding it) { return it.term.label(); }), "'elasticity@LKneePitch'.")
      .def_property_readonly("effect", get([](Finding it) { return it.term.effect.name; }))
      .def_property_readonly("at", get([](Finding it) { return it.term.placeName; }))
      .def_property_readonly("state", get([](Finding it) { return toString(it.state); }),
                             "'present', 'aliased', 'trivial', 'absent', 'inconclusive', 'absorbed' or 'no-data'.")
      .def_property_readonly("why", get([](Finding it) { return it.why; }), "Reason for 'no-data'.")
      .def_property_readonly("unknowns", listUnknowns, "Name -> (value, sigma, unit), linearised.")
      .def_property_readonly("evidence", get([](Finding it) { return it.evidence.bayes; }), "2 ln(Bayes factor).")
      .def_property_readonly("likelihood_ratio", get([](Finding it) { return it.evidence.likelihoodRatio; }),
                             "Decrease of chi2 if it is added.")
      .def_property_readonly("p_value", get([](Finding it) { return it.evidence.pValue; }),
                             "As if it were the only candidate.")
      .def_property_readonly("kept_fraction", get([](Finding it) { return it.evidence.keptFraction; }),
                             "Share of its information that the model's unknowns do not absorb.")
      .def_property_readonly("power", get([](Finding it) { return it.power; }),
                             "Probability to detect it at its plausible size.")
      .def_property_readonly("minimal_detectable", get([](Finding it) { return it.minimalDetectable; }),
                             "Per unknown: the size detected with 90 % power, in its unit.")
      .def_property_readonly("held_out_px_before", get([](Finding it) { return it.heldOutBefore; }), "[px], or None.")
      .def_property_readonly("held_out_px_after", get([](Finding it) { return it.heldOutAfter; }), "[px], or None.")
      .def_property_readonly("plausible", get([](Finding it) { return it.plausible; }))
      .def_property_readonly("equivalent", get([](Finding it) { return it.equivalent; }),
                             "Labels of effects that these captures cannot tell from it.")
      .def("__repr__", [](const CandidateHandle& self) {
        return fmt::format("<naocal.Candidate: {}, {}>", self.finding->term.label(), toString(self.finding->state));
      });
}

void bindCurve(py::module_& module) {
  py::class_<CurveHandle>(module, "Curve", "What would explain the misfit: a joint's, camera's or board's curve.")
      .def_property_readonly("at", [](const CurveHandle& self) { return self.curve->place; })
      .def_property_readonly("driver", [](const CurveHandle& self) { return self.curve->driver; })
      .def_property_readonly(
          "what", [](const CurveHandle& self) { return self.curve->what; }, "The driver in words.")
      .def_property_readonly("unit", [](const CurveHandle& self) { return self.curve->unit; })
      .def_property_readonly(
          "share", [](const CurveHandle& self) { return self.curve->share; },
          "Share of the variance that it explains there.")
      .def_property_readonly("evidence", [](const CurveHandle& self) { return self.curve->bayes; })
      .def_property_readonly(
          "expression", [](const CurveHandle& self) { return self.curve->expression; },
          "A small expression that follows it; empty if there is none.")
      .def_property_readonly(
          "points", [](const py::object& self) { return viewOf(self.cast<const CurveHandle&>().curve->curve, self); },
          "Rows of (driver, deflection, standard error), (n, 3). A view.")
      .def("__repr__", [](const CurveHandle& self) {
        return fmt::format("<naocal.Curve: {} over {}>", self.curve->place, self.curve->driver);
      });
}

void bindSteps(py::module_& module) {
  py::class_<SelectionStep>(module, "Step", "A model revision: the model with one more effect.")
      .def_readonly("added", &SelectionStep::added, "Its label; empty for the model as given.")
      .def_readonly("dropped", &SelectionStep::dropped)
      .def_readonly("rms_px", &SelectionStep::rmsPx, "[px].")
      .def_readonly("noise_floor_px", &SelectionStep::noiseFloorPx, "[px].")
      .def_readonly("held_out_px", &SelectionStep::heldOutPx,
                    "Error on poses that neither the fit nor the choice has seen [px], or None.")
      .def_readonly("alarm", &SelectionStep::alarm, "p-value of the model being complete.")
      .def("__repr__", [](const SelectionStep& self) {
        return fmt::format("<naocal.Step: {}, {:.2f} px rms>", self.added.empty() ? "base model" : "+ " + self.added,
                           self.rmsPx);
      });
  py::class_<DataAnomaly>(module, "Suspicion", "A suspicious capture, board or setting.")
      .def_readonly("capture", &DataAnomaly::capture, "Id of the capture, or None.")
      .def_readonly("why", &DataAnomaly::why)
      .def_readonly("odds", &DataAnomaly::odds, "Against the best other explanation, or None.")
      .def("__repr__", [](const DataAnomaly& self) { return fmt::format("<naocal.Suspicion: {}>", self.why); });
}

} // namespace

void bindDiagnosis(py::module_& module) {
  bindCandidate(module);
  bindCurve(module);
  bindSteps(module);
  py::class_<Diagnosed, SharedDiagnosed>(module, "Diagnosis", "What is missing: what 'naocal diagnose' finds.")
      .def_property_readonly(
          "verdict", [](const Diagnosed& self) { return toString(self.diagnosis.verdict); },
          "'adequate', 'effect-missing', 'unknown-effect', 'scatter', 'inconclusive' or "
          "'bad-captures'.")
      .def_property_readonly("sentence", [](const Diagnosed& self) { return self.diagnosis.sentence; })
      .def_property_readonly(
          "findings", [](const Diagnosed& self) { return toDictionary(toJson(self.diagnosis.findings)); },
          "Everything to know of it, most serious first: 'findings' of the file.")
      .def_property_readonly(
          "tentative", [](const Diagnosed& self) { return self.diagnosis.isTentative; },
          "Whether what is suggested may be chance: take more poses before you add it.")
      .def_property_readonly(
          "suggested", [](const Diagnosed& self) { return self.diagnosis.suggested; },
          "Labels of the effects to add, in this order.")
      .def_property_readonly(
          "rms_px", [](const Diagnosed& self) { return self.diagnosis.rmsPx; }, "Of the model as given [px].")
      .def_property_readonly(
          "noise_floor_px", [](const Diagnosed& self) { return self.diagnosis.lackOfFit.noiseFloorPx; },
          "Expected rms distance under noise alone [px].")
      .def_property_readonly(
          "alarm", [](const Diagnosed& self) { return self.diagnosis.alarm; },
          "p-value of the given model being complete.")
      .def_property_readonly(
          "pose_scatter", [](const Diagnosed& self) { return self.diagnosis.scatter; },
          "Random deflection of a joint per pose [rad].")
      .def_property_readonly("ranking", listCandidates, "List of Candidate, best first.")
      .def_property_readonly(
          "steps", [](const Diagnosed& self) { return self.diagnosis.steps; }, "List of Step.")
      .def_property_readonly("curves", listCurves, "List of Curve, best first ('drivers' in the file).")
      .def_property_readonly(
          "suspicious", [](const Diagnosed& self) { return self.diagnosis.anomalies; }, "List of Suspicion.")
      .def_property_readonly("seconds", [](const Diagnosed& self) { return self.diagnosis.seconds; })
      .def(
          "to_dict", [](const Diagnosed& self, bool full) { return toDictionary(self.json(full)); }, "full"_a = false,
          "The file that 'naocal diagnose --json' writes, as a dictionary; `full`: as with --full.")
      .def(
          "write",
          [](const Diagnosed& self, const std::filesystem::path& file, bool full) {
            replaceJson(file, self.json(full));
          },
          "file"_a, "full"_a = false,
          "Writes that file whole or not at all. InputError if another kind of file is there.")
      .def("__repr__", [](const Diagnosed& self) {
        return fmt::format("<naocal.Diagnosis: {}>", toString(self.diagnosis.verdict));
      });
  module.def("diagnose", diagnoseCaptures, "captures"_a.none(false));
}

} // namespace naocal
