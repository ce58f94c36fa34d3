#include "synthetic/RenderingRow.hpp"

#include <limits>

namespace naocal {

namespace {

constexpr std::size_t behindCamera = std::numeric_limits<std::size_t>::max();

std::size_t cellSeen(const Painting& painting, const Eigen::Matrix3f& planeFromRay, const Eigen::Vector2f& ray) {
  const Eigen::Vector3f p = planeFromRay.leftCols<2>() * ray + planeFromRay.col(2);
  return p.z() > 0 ? painting.cell(p.x() / p.z(), p.y() / p.z()) : behindCamera;
}

float shown(const Flat& flat, std::size_t cell) {
  return cell == behindCamera ? -1 : flat.painting->brightness(cell, flat.fromBehind);
}

/// A number in [0, 1) that looks random, from a pixel's place: it shifts the pixel's samples so that no edge meets the
/// same ones in all pixels.
float scatter(unsigned x, unsigned y) {
  unsigned hash = x * 0x9e3779b1u ^ y * 0x85ebca77u;
  hash = (hash ^ (hash >> 15)) * 0x2c1b3c6du;
  return float((hash ^ (hash >> 13)) >> 8) / float(1u << 24);
}

} // namespace

RenderingRow::RenderingRow(const std::vector<Flat>& flats, const std::vector<Eigen::Vector2f>& rays, int width)
    : rays_{rays}, width_{width}, moves_{!flats.empty() && flats.front().planeFromRay.size() > 1} {
  for (const Flat& flat : flats) {
    Candidate& candidate = all_.emplace_back(Candidate{&flat, {}, {}});
    candidate.cells.fill(std::vector<std::size_t>(std::size_t(width + 1), behindCamera));
    candidate.planeFromRay.assign(moves_ ? samples : 1, flat.planeFromRay.front());
  }
}

void RenderingRow::prepare(Candidate& candidate, int y, float begin, float end) const {
  const Flat& flat = *candidate.flat;
  if (moves_) {
    constexpr std::array<int, samples> times{6, 13, 2, 9, 0, 11, 4, 15, 7, 12, 3, 8, 1, 10, 5, 14};
    for (std::size_t i = 0; i < samples; ++i) {
      candidate.planeFromRay[i] = flat.at(begin + (end - begin) * (float(times[i]) + 0.5f) / samples);
    }
  }
  const auto look = [&](std::vector<std::size_t>& cells, int row, const Eigen::Matrix3f& planeFromRay) {
    for (int x = flat.left; x <= flat.right + 1; ++x) {
      cells[std::size_t(x)] = cellSeen(*flat.painting, planeFromRay, ray(x, row));
    }
  };
  const Eigen::Matrix3f first = moves_ ? flat.at(begin) : flat.planeFromRay.front();
  const Eigen::Matrix3f last = moves_ ? flat.at(end) : first;
  if (!moves_ && y > flat.top) {
    candidate.cells[0].swap(candidate.cells[1]); // what was below is above now
  } else {
    look(candidate.cells[0], y, first);
  }
  look(candidate.cells[1], y + 1, first);
  if (moves_) {
    look(candidate.cells[2], y, last);
    look(candidate.cells[3], y + 1, last);
  }
}

std::optional<float> RenderingRow::uniform(const Candidate& candidate, int x) {
  const Flat& flat = *candidate.flat;
  if (x < flat.left || x > flat.right) {
    return -1;
  }
  const auto place = std::size_t(x);
  const std::size_t cell = candidate.cells[0][place];
  const std::size_t corners = candidate.planeFromRay.size() > 1 ? 4 : 2;
  for (std::size_t i = 0; i < corners; ++i) {
    if (candidate.cells[i][place] != cell || candidate.cells[i][place + 1] != cell) {
      return std::nullopt;
    }
  }
  return shown(flat, cell);
}

/// The mean over samples of the pixel's area and time; those that hit nothing see the floor.
float RenderingRow::sampled(int x, int y, float floor) const {
  constexpr std::array<int, samples> rows{0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};
  const Eigen::Vector2f& corner = ray(x, y);
  const Eigen::Vector2f right = ray(x + 1, y) - corner, down = ray(x, y + 1) - corner;
  const float shift = scatter(unsigned(x), unsigned(y));
  float sum = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const Eigen::Vector2f through =
        corner + (float(i) + shift) / samples * right + (float(rows[i]) + shift) / samples * down;
    float seen = -1;
    for (std::size_t k = 0; k < mixed_.size() && seen < 0; ++k) {
      const Candidate& candidate = *mixed_[k];
      const Eigen::Matrix3f& planeFromRay = candidate.planeFromRay[moves_ ? i : 0];
      seen = shown(*candidate.flat, cellSeen(*candidate.flat->painting, planeFromRay, through));
    }
    sum += seen < 0 ? floor : seen;
  }
  return sum / samples;
}

void RenderingRow::paint(int y, float begin, float end, float* brightness) {
  std::vector<const Candidate*> here;
  int left = width_, right = -1;
  for (Candidate& candidate : all_) {
    if (y >= candidate.flat->top && y <= candidate.flat->bottom) {
      prepare(candidate, y, begin, end);
      here.push_back(&candidate);
      left = std::min(left, candidate.flat->left);
      right = std::max(right, candidate.flat->right);
    }
  }
  for (int x = left; x <= right; ++x) {
    mixed_.clear();
    std::optional<float> whole;
    for (std::size_t k = 0; k < here.size() && !(whole && *whole >= 0); ++k) {
      whole = uniform(*here[k], x);
      if (!whole || *whole >= 0) {
        mixed_.push_back(here[k]);
      }
    }
    if (mixed_.size() == 1 && whole && *whole >= 0) {
      brightness[x] = *whole;
    } else if (!mixed_.empty()) {
      brightness[x] = sampled(x, y, brightness[x]);
    }
  }
}

} // namespace naocal
