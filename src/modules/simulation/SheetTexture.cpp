#include "simulation/SheetTexture.hpp"

#include "detect/MarkerDetector.hpp"

#include <algorithm>

namespace naocal {

namespace {

constexpr std::size_t strips = 5; // outside, margin, pattern, margin, outside

std::size_t strip(float place, float margin, float length) {
  if (place < 0) {
    return place < -margin ? 0 : 1;
  }
  return place < length ? 2 : place < length + margin ? 3 : 4;
}

/// Finds the cells of a texture with a `cellAt`, without a virtual call for each.
template <class Texture> class CellSearch : public FlatTexture {
public:
  void findCells(std::span<const Eigen::Matrix3f> planeFromRay, std::span<const Eigen::Vector2f> rays,
                 std::span<std::size_t> cells) const final {
    const bool single = planeFromRay.size() == 1;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      cells[i] = cellSeen(planeFromRay[single ? 0 : i], rays[i]);
    }
  }
  /// Looks at every eighth ray, and between two of them where they see different cells.
  void findCellsOfRow(const Eigen::Matrix3f& planeFromRay, std::span<const Eigen::Vector2f> rays,
                      std::span<std::size_t> cells) const final {
    constexpr std::size_t step = 8;
    cells.front() = cellSeen(planeFromRay, rays.front());
    for (std::size_t begin = 0; begin + 1 < rays.size(); begin += step) {
      const std::size_t count = std::min(step + 1, rays.size() - begin);
      cells[begin + count - 1] = cellSeen(planeFromRay, rays[begin + count - 1]);
      findCellsBetween(planeFromRay, rays.subspan(begin, count), cells.subspan(begin, count));
    }
  }

private:
  std::size_t cellSeen(const Eigen::Matrix3f& planeFromRay, const Eigen::Vector2f& ray) const {
    const Eigen::Vector3f p = planeFromRay.leftCols<2>() * ray + planeFromRay.col(2);
    return p.z() > 0 ? static_cast<const Texture&>(*this).cellAt(p.x() / p.z(), p.y() / p.z()) : behindCamera;
  }
  /// The cells between the first and the last, which are known.
  void findCellsBetween(const Eigen::Matrix3f& planeFromRay, std::span<const Eigen::Vector2f> rays,
                        std::span<std::size_t> cells) const {
    if (cells.front() == cells.back()) {
      std::fill(cells.begin(), cells.end(), cells.front());
    } else if (const std::size_t half = rays.size() / 2; rays.size() > 2) {
      cells[half] = cellSeen(planeFromRay, rays[half]);
      findCellsBetween(planeFromRay, rays.first(half + 1), cells.first(half + 1));
      findCellsBetween(planeFromRay, rays.subspan(half), cells.subspan(half));
    }
  }
};

class Sheet final : public CellSearch<Sheet> {
public:
  Sheet(const CharucoPattern& pattern, double margin)
      : squaresX_{pattern.squaresX}, squaresY_{pattern.squaresY}, squareLength_{float(pattern.squareLength)},
        margin_{float(margin)}, gap_{float((1 - pattern.markerLength / pattern.squareLength) / 2)} {
    const auto modules = std::size_t(markerCells(pattern.dictionary, pattern.firstMarkerId).rows());
    modulesPerSquare_ = float(double(modules) * pattern.squareLength / pattern.markerLength);
    parts_ = modules + 2;
    for (std::size_t y = 0; y < strips; ++y) {
      for (std::size_t x = 0; x < strips; ++x) {
        const bool beyond = x % (strips - 1) == 0 || y % (strips - 1) == 0;
        brightness_.push_back(beyond ? -1 : 1);
      }
    }
    const bool firstIsWhite = pattern.legacyPattern && pattern.squaresY % 2 == 0;
    int marker = pattern.firstMarkerId;
    for (int row = 0; row < squaresY_; ++row) {
      for (int column = 0; column < squaresX_; ++column) {
        const bool isWhite = ((row + column) % 2 != 0) != firstIsWhite;
        addSquare(isWhite ? markerCells(pattern.dictionary, marker++) : Eigen::MatrixXi{});
      }
    }
  }

  std::size_t cellAt(float x, float y) const override {
    const float down = -y;
    const std::size_t stripX = strip(x, margin_, float(squaresX_) * squareLength_),
                      stripY = strip(down, margin_, float(squaresY_) * squareLength_);
    if (stripX != 2 || stripY != 2) {
      return stripX + strips * stripY;
    }
    const float column = x / squareLength_, row = down / squareLength_;
    // clamps rounding errors
    const int squareX = std::min(int(column), squaresX_ - 1), squareY = std::min(int(row), squaresY_ - 1);
    const auto square = std::size_t(squareY * squaresX_ + squareX);
    const std::size_t first = strips * strips + square * parts_ * parts_;
    return merged_[first + part(column - float(squareX)) + parts_ * part(row - float(squareY))];
  }

private:
  /// A square's parts: the modules of its marker, and the white before and after them. A black square has one
  /// brightness.
  void addSquare(const Eigen::MatrixXi& modules) {
    const Eigen::Index count = modules.rows();
    const std::size_t first = brightness_.size();
    for (Eigen::Index y = -1; y + 1 < Eigen::Index(parts_); ++y) {
      for (Eigen::Index x = -1; x + 1 < Eigen::Index(parts_); ++x) {
        const bool inside = x >= 0 && y >= 0 && x < count && y < count;
        brightness_.push_back(count == 0 ? 0 : inside ? float(modules(y, x)) : 1);
      }
    }
    mergeParts(first);
  }
  /// Merges a square's parts of the same brightness to rectangles: the fewer cells, the fewer pixels see several.
  void mergeParts(std::size_t first) {
    constexpr std::size_t none = behindCamera;
    merged_.resize(brightness_.size(), none);
    const auto isFree = [&](std::size_t x, std::size_t y, float brightness) {
      const std::size_t cell = first + x + parts_ * y;
      return merged_[cell] == none && brightness_[cell] == brightness;
    };
    for (std::size_t i = 0; i < parts_ * parts_; ++i) {
      const std::size_t left = i % parts_, top = i / parts_, cell = first + i;
      if (merged_[cell] != none) {
        continue;
      }
      std::size_t right = left, bottom = top;
      while (right < parts_ && isFree(right, top, brightness_[cell])) {
        ++right;
      }
      const auto isFreeRow = [&](std::size_t y) {
        for (std::size_t x = left; x < right; ++x) {
          if (!isFree(x, y, brightness_[cell])) {
            return false;
          }
        }
        return true;
      };
      while (bottom < parts_ && isFreeRow(bottom)) {
        ++bottom;
      }
      for (std::size_t y = top; y < bottom; ++y) {
        std::fill_n(merged_.begin() + std::ptrdiff_t(first + left + parts_ * y), right - left, cell);
      }
    }
  }
  std::size_t part(float inSquare) const {
    const float module = (inSquare - gap_) * modulesPerSquare_;
    return module < 0 ? 0 : std::min(std::size_t(module) + 1, parts_ - 1);
  }

  int squaresX_, squaresY_;
  float squareLength_, margin_;     // [m]
  float gap_;                       // between a square's edge and its marker, in units of the square
  float modulesPerSquare_ = 0;      // including the black border
  std::size_t parts_ = 0;           // along a square's side
  std::vector<std::size_t> merged_; // by cell: the first cell of its rectangle
};

class PatchPainting final : public CellSearch<PatchPainting> {
public:
  PatchPainting(double halfX, double halfY, double brightness) : halfX_{float(halfX)}, halfY_{float(halfY)} {
    brightness_.assign(9, -1);
    brightness_[4] = float(brightness);
  }
  std::size_t cellAt(float x, float y) const override {
    const auto third = [](float place, float half) -> std::size_t { return place < -half ? 0 : place <= half ? 1 : 2; };
    return third(x, halfX_) + 3 * third(y, halfY_);
  }

private:
  float halfX_, halfY_; // [m]
};

} // namespace

std::shared_ptr<const FlatTexture> makeBoardTexture(const CharucoPattern& pattern, double margin) {
  return std::make_shared<Sheet>(pattern, margin);
}

std::shared_ptr<const FlatTexture> makePatchTexture(double halfX, double halfY, double brightness) {
  return std::make_shared<PatchPainting>(halfX, halfY, brightness);
}

} // namespace naocal
