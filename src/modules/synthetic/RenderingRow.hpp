#pragma once

#include "synthetic/RenderingFlats.hpp"

#include <array>

namespace naocal {

/// Paints flat things over a picture of the floor, row after row: the mean brightness over each pixel's area and the
/// time for which it is exposed.
class RenderingRow {
public:
  /// `rays`: (x, y) at z = 1 through the corners of all pixels, row after row; `width`: pixels in a row.
  RenderingRow(const std::vector<Flat>& flats, const std::vector<Eigen::Vector2f>& rays, int width);

  /// `brightness`: of the floor in the row's pixels, then of what is seen there. It is exposed from `begin` to `end`,
  /// shares of the span between the first and the last instant; all the same where nothing moves.
  void paint(int y, float begin, float end, float* brightness);

private:
  static constexpr int samples = 16; // one in each of 16 rows and 16 columns of the pixel, and in each 16th of the time

  /// One flat thing in the row: its cells seen through the pixels' corners when exposure begins and ends, above and
  /// below, and its place at each sample's time.
  struct Candidate {
    const Flat* flat;
    std::array<std::vector<std::size_t>, 4> cells;
    std::vector<Eigen::Matrix3f> planeFromRay; // one where nothing moves
  };
  /// What it shows all over a pixel, for all the time; absent where that varies.
  static std::optional<float> uniform(const Candidate& candidate, int x);
  void prepare(Candidate& candidate, int y, float begin, float end) const;
  float sampled(int x, int y, float floor) const;
  const Eigen::Vector2f& ray(int x, int y) const {
    return rays_[std::size_t(y) * std::size_t(width_ + 1) + std::size_t(x)];
  }

  const std::vector<Eigen::Vector2f>& rays_;
  int width_;
  bool moves_;
  std::vector<Candidate> all_;
  std::vector<const Candidate*> mixed_; // in the pixel that is sampled, from front to back
};

} // namespace naocal
