#include "poses/Discrimination.hpp"

#include "math/LinearAlgebra.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace naocal {

Discrimination::Discrimination(const OpenQuestion& question, Eigen::Index own) : question_{question}, own_{own} {
  Eigen::Index column = 0;
  for (const Suspect& suspect : question.suspects) {
    first_.push_back(column);
    column += suspect.size.size();
  }
  double sum = 0;
  for (std::size_t one = 0; one < question.suspects.size(); ++one) {
    const double odds = question.suspects[one].odds;
    if (!question.rivals) {
      pairs_.push_back({one, std::nullopt, odds});
    }
    for (std::size_t other = 0; question.rivals && other < question.suspects.size(); ++other) {
      if (other != one) {
        pairs_.push_back({one, other, odds * question.suspects[other].odds});
      }
    }
  }
  for (const Pair& pair : pairs_) {
    sum += pair.weight;
  }
  for (Pair& pair : pairs_) {
    pair.weight /= sum;
  }
}

Eigen::VectorXd Discrimination::misfits(const Eigen::MatrixXd& hessian) const {
  const Eigen::Index suspects = hessian.rows() - own_;
  const Eigen::LLT<Eigen::MatrixXd> own{hessian.topLeftCorner(own_, own_)};
  const Eigen::MatrixXd half = own.matrixL().solve(hessian.topRightCorner(own_, suspects));
  const Eigen::MatrixXd kept = hessian.bottomRightCorner(suspects, suspects) - half.transpose() * half;
  const auto block = [&](std::size_t one, std::size_t other) {
    return kept.block(first_[one], first_[other], question_.suspects[one].size.size(),
                      question_.suspects[other].size.size());
  };
  Eigen::VectorXd result(at(pairs_.size()));
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    const Pair& pair = pairs_[i];
    const Eigen::VectorXd& size = question_.suspects[pair.one].size;
    result[at(i)] = size.dot(block(pair.one, pair.one) * size);
    if (pair.other) {
      Eigen::MatrixXd rival = block(*pair.other, *pair.other);
      rival.diagonal() += question_.suspects[*pair.other].plausible.cwiseAbs2().cwiseInverse();
      const Eigen::VectorXd imitated = block(*pair.other, pair.one) * size;
      result[at(i)] -= imitated.dot(rival.llt().solve(imitated));
    }
  }
  return result.cwiseMax(0);
}

double Discrimination::gain(const Eigen::VectorXd& before, const Eigen::VectorXd& after) const {
  double sum = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    sum += pairs_[i].weight * (1 - std::exp((before[at(i)] - after[at(i)]) / 8));
  }
  return sum;
}

double Discrimination::growth(const Eigen::VectorXd& before, const Eigen::VectorXd& after) const {
  constexpr double nothing = 1e-3; // a misfit that no one could see
  double sum = 0;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    sum += pairs_[i].weight * std::log((after[at(i)] + nothing) / (before[at(i)] + nothing));
  }
  return std::exp(sum);
}

} // namespace naocal
