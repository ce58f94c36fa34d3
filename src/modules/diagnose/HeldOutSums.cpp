#include "diagnose/HeldOutSums.hpp"

#include "evidence/GramSum.hpp"
#include "evidence/ModelAlone.hpp"

#include <algorithm>

namespace naocal {

namespace {

constexpr std::size_t folds = 5;

/// Of every `folds`th pose from `first` on.
HeldOutSums sumsFrom(std::size_t first, std::size_t each, const ModelAlone& alone) {
  const std::vector<PoseRows>& poses = *alone.problem().poses;
  const double pixel = alone.noise().pixel;
  const Eigen::Index size = alone.problem().gram.cols();
  HeldOutSums result;
  result.gradient = result.plainGradient = Eigen::VectorXd::Zero(size);
  GramSum plain{size}, taken{size};
  for (std::size_t pose = first; pose < poses.size(); pose += each) {
    const PoseRows& rows = poses[pose];
    const ModelAlone::Whitener& whitener = alone.whitener(pose);
    plain.add(rows.unknowns, rows.byUnknowns);
    taken.add(rows.unknowns, whitener.unknowns);
    const Eigen::VectorXd gradient = rows.byUnknowns.transpose() * rows.residual;
    result.plainGradient(rows.unknowns) += gradient;
    result.gradient(rows.unknowns) +=
        gradient / (pixel * pixel) - whitener.unknowns.transpose() * (whitener.half * rows.residual) / pixel;
    result.squares += rows.squares;
    result.numbers += rows.numbers;
  }
  result.gram = plain.taken();
  result.hessian = result.gram / (pixel * pixel) - taken.taken();
  return result;
}

void add(const HeldOutSums& part, HeldOutSums& sums) {
  sums.hessian += part.hessian;
  sums.gram += part.gram;
  sums.gradient += part.gradient;
  sums.plainGradient += part.plainGradient;
  sums.squares += part.squares;
  sums.numbers += part.numbers;
}

void move(const Eigen::VectorXd& step, HeldOutSums& sums) {
  const Eigen::VectorXd moved = sums.gram * step;
  sums.squares += 2 * sums.plainGradient.dot(step) + step.dot(moved);
  sums.plainGradient += moved;
  sums.gradient += sums.hessian * step;
}

} // namespace

HeldOutParts heldOutSums(const Inquiry& inquiry, const Eigen::VectorXd& step) {
  const ModelAlone alone{inquiry.problem(), inquiry.noise()};
  const std::size_t parts = std::min(folds, inquiry.poses().size());
  HeldOutParts result;
  for (std::size_t part = 0; part < parts; ++part) {
    HeldOutSums& sums = result.parts.emplace_back(sumsFrom(part, parts, alone));
    move(step, sums);
    part == 0 ? void(result.all = sums) : add(sums, result.all);
  }
  return result;
}

} // namespace naocal
