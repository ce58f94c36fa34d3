#include "brain/CalibrationModel.hpp"

#include "estimation/Model.hpp"
#include "estimation/ModelBuilder.hpp"
#include "io/InputError.hpp"

#include <algorithm>

namespace naocal {
namespace {

bool isAccepted(const Measurements& measurements, const std::vector<std::string>& with,
                const std::vector<std::string>& without, const std::vector<Effect>& effects) {
  try {
    makeModel(measurements, with, without, effects);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

} // namespace

ModelFile calibrationModel(const std::filesystem::path& configuration, const Robot& drawing) {
  return readModelFile(configuration / "models" / (drawing.model + ".json"), drawing);
}

FittingModel modelFor(const Measurements& measurements, const ModelFile& model) {
  FittingModel fitting{{.effects = model.effects}, {}};
  const bool onOneFoot =
      std::all_of(measurements.standings.begin(), measurements.standings.end(), [](const Standing& standing) {
        return standing.supportFoot == SupportFoot::left || standing.supportFoot == SupportFoot::right;
      });
  if (!onOneFoot) {
    return fitting;
  }
  for (const std::string& pattern : model.with) {
    if (isAccepted(measurements, {pattern}, {}, model.effects)) {
      fitting.model.with.push_back(pattern);
    } else {
      fitting.leftOut.push_back("with " + pattern);
    }
  }
  for (const std::string& pattern : model.without) {
    if (isAccepted(measurements, fitting.model.with, {pattern}, model.effects)) {
      fitting.model.without.push_back(pattern);
    } else {
      fitting.leftOut.push_back("without " + pattern);
    }
  }
  return fitting;
}

} // namespace naocal
