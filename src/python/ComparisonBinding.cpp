#include "python/Bindings.hpp"
#include "python/Documents.hpp"
#include "python/LongCall.hpp"
#include "python/Solved.hpp"

#include "calibration/Prediction.hpp"
#include "io/FileKind.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <variant>

namespace naocal {

namespace py = pybind11;
using namespace pybind11::literals;

namespace {

/// A result as an object, or its file.
using AnyResult = std::variant<std::shared_ptr<Solved>, std::filesystem::path>;

/// A result measured on captures, and beside another one.
struct Compared {
  Comparison comparison;
  std::optional<double> weightedPx, againstPx, againstWeightedPx; // if compared against another result [px]

  /// COMPARISON.json.
  nlohmann::json json() const {
    nlohmann::json json = comparisonJson(comparison);
    if (weightedPx) {
      json["against"] = {{"rmsPx", *againstPx}, {"weightedPx", *againstWeightedPx}};
      json["weightedPx"] = *weightedPx;
    }
    return json;
  }
};

StoredResult store(const AnyResult& result) {
  if (const auto* file = std::get_if<std::filesystem::path>(&result)) {
    return readKnownResult(*file);
  }
  return parseResult(std::get<std::shared_ptr<Solved>>(result)->json(), "the result");
}

Compared compareResults(const AnyResult& result, const std::shared_ptr<Captures>& captures, bool samePlace,
                        const std::optional<AnyResult>& against) {
  return LongCall{}.run([&] {
    const std::vector<CaptureSet>& sets = *captures->measurements.sets;
    const Robot& robot = captures->measurements.robot;
    const StoredResult own = store(result);
    Compared compared{compare(own, sets, robot, samePlace), {}, {}, {}};
    if (against) {
      const StoredResult other = store(*against);
      compared.weightedPx = weightedError(own, sets, robot, samePlace, own.noise);
      compared.againstWeightedPx = weightedError(other, sets, robot, samePlace, own.noise);
      compared.againstPx = compare(other, sets, robot, samePlace).all.rmsPx;
    }
    return compared;
  });
}

void bindSummary(py::module_& module) {
  py::class_<ResidualSummary>(module, "ResidualSummary", "Distances of corners from their predictions.")
      .def_readonly("rms_px", &ResidualSummary::rmsPx, "sqrt(mean(du^2 + dv^2)) [px].")
      .def_readonly("median_px", &ResidualSummary::medianPx, "[px].")
      .def_readonly("corners", &ResidualSummary::corners, "Number of corners.")
      .def("__repr__", [](const ResidualSummary& self) {
        return fmt::format("<naocal.ResidualSummary: {:.2f} px rms of {} corners>", self.rmsPx, self.corners);
      });
}

} // namespace

void bindComparison(py::module_& module) {
  bindSummary(module);
  py::class_<Compared>(module, "Comparison", "The prediction error of a result: what 'naocal compare' measures.")
      .def_property_readonly(
          "rms_px", [](const Compared& self) { return self.comparison.all.rmsPx; }, "[px].")
      .def_property_readonly(
          "median_px", [](const Compared& self) { return self.comparison.all.medianPx; }, "[px].")
      .def_property_readonly("corners", [](const Compared& self) { return self.comparison.all.corners; })
      .def_property_readonly(
          "nominal", [](const Compared& self) { return self.comparison.nominal; },
          "ResidualSummary with the robot's drawing alone.")
      .def_property_readonly("by_board", [](const Compared& self) { return self.comparison.byBoard; })
      .def_property_readonly("by_camera", [](const Compared& self) { return self.comparison.byCamera; })
      .def_property_readonly("by_pose", [](const Compared& self) { return self.comparison.byPose; })
      .def_property_readonly(
          "ignored", [](const Compared& self) { return self.comparison.ignored; },
          "Effects of the result that do not apply to these captures.")
      .def_readonly("weighted_px", &Compared::weightedPx,
                    "Error with the joints' random errors allowed for [px]; None without `against`.")
      .def_readonly("against_px", &Compared::againstPx, "rms error of the other result [px]; None without `against`.")
      .def_readonly("against_weighted_px", &Compared::againstWeightedPx,
                    "`weighted_px` of the other result; None without `against`.")
      .def(
          "to_dict", [](const Compared& self) { return toDictionary(self.json()); },
          "The file that 'naocal compare --json' writes, as a dictionary.")
      .def(
          "write", [](const Compared& self, const std::filesystem::path& file) { replaceJson(file, self.json()); },
          "file"_a, "Writes that file whole or not at all. InputError if another kind of file is there.")
      .def("__repr__", [](const Compared& self) {
        return fmt::format("<naocal.Comparison: {:.2f} px rms, {:.2f} px by the drawing alone>",
                           self.comparison.all.rmsPx, self.comparison.nominal.rmsPx);
      });
  module.def("compare", compareResults, "result"_a.none(false), "captures"_a.none(false), "same_place"_a, "against"_a);
}

} // namespace naocal
