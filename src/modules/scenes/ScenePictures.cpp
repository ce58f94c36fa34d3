#include "scenes/ScenePictures.hpp"

#include "effects/Catalogue.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace naocal {

void requireRenderable(const CaptureSet& set, const Model& model) {
  if (set.cameras.empty()) {
    throw InputError{
        "expected a scene with cameras, to render what they see, found none; simulate without --images, or "
        "name a scene with cameras (--scene)"};
  }
  for (const Board& board : set.boards) {
    if (!board.pattern) {
      throw InputError{fmt::format("board {}: expected a ChArUco board, to be rendered, found single points; simulate "
                                   "without --images",
                                   board.id)};
    }
  }
  for (const Term& term : model.terms()) {
    const bool isShape = term.effect.placeKind == PlaceKind::board && !term.isPlacement;
    if (isShape || term.effect.name == rollingShutter().name) {
      throw InputError{fmt::format("'{}' is not rendered: boards are flat and true to size, and all rows of a picture "
                                   "are taken at once; simulate without --images",
                                   term.label())};
    }
  }
}

CameraIntrinsics lensIn(const ModelState& state, const CameraIntrinsics& drawn) {
  CameraIntrinsics lens = drawn;
  lens.fx = state.lens()[0];
  lens.fy = state.lens()[1];
  lens.cx = state.lens()[2];
  lens.cy = state.lens()[3];
  std::copy(state.lens().begin() + 4, state.lens().end(), lens.distortion.begin());
  return lens;
}

RenderedScene boardsBefore(const ImageObservation& picture, const Measurements& measurements, const PosedRobot& posed) {
  RenderedScene scene;
  for (const BoardObservation& observation : picture.observations) {
    const Board& board = measurements.targets[observation.view.board()].board;
    scene.boards.push_back({board.id, *board.pattern, observation.view.cameraFrames(posed).opticalFromBoard});
  }
  return scene;
}

} // namespace naocal
