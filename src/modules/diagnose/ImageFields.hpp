#pragma once

#include "diagnose/FreedErrors.hpp"

#include <optional>
#include <vector>

namespace naocal {

/// Errors within pictures as a field: of one board, wherever it is seen, or of one camera, wherever boards appear.
struct ImageField {
  enum class Of { corners, sheet, camera };
  Of of = Of::corners;
  std::size_t at = 0; // which board or camera
  FieldFit fit;
};

/// Columns of a board's shape: every corner off in three directions [m], in the board's axes.
ImageField cornerField(const FreedErrors& errors, const Measurements& measurements, std::size_t board);

/// The same as polynomials of degree 3 over the board: few numbers, that tell smooth shapes from noise sooner [m].
ImageField sheetField(const FreedErrors& errors, const Measurements& measurements, std::size_t board);

/// Columns of a lens: errors to the right and down as polynomials of degree 4 over the picture [px].
ImageField cameraField(const FreedErrors& errors, const Measurements& measurements, std::size_t camera);

/// The same field in other errors.
ImageField again(const ImageField& field, const FreedErrors& errors, const Measurements& measurements);

/// The field that explains most, if any does beyond chance and beyond what a lens or a detector is known to [px].
std::optional<ImageField> strikingField(const Measurements& measurements, const Model& model,
                                        const CalibrationResult& fit);

} // namespace naocal
