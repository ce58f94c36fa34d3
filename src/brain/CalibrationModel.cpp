#include "brain/CalibrationModel.hpp"

#include <algorithm>

namespace naocal {

ModelFile calibrationModel(const std::filesystem::path& configuration, const Robot& drawing) {
  return readModelFile(configuration / "models" / (drawing.model + ".json"), drawing);
}

ModelFile modelFor(const Measurements& measurements, const ModelFile& model) {
  const bool onOneFoot =
      std::all_of(measurements.standings.begin(), measurements.standings.end(), [](const Standing& standing) {
        return standing.supportFoot == SupportFoot::left || standing.supportFoot == SupportFoot::right;
      });
  return onOneFoot ? model : ModelFile{.effects = model.effects};
}

} // namespace naocal
