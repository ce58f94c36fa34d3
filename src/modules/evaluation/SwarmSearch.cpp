#include "evaluation/GlobalSearch.hpp"

#include <pagmo/algorithms/pso.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

namespace naocal {

namespace {

using Numbers = std::vector<double>;

/// The cost function in pagmo's interface.
struct Problem {
  const CostFunction* cost = nullptr;
  Eigen::Index unknowns = 1;
  double range = 1;

  Numbers fitness(const Numbers& numbers) const {
    return {(*cost)(Eigen::Map<const Eigen::VectorXd>{numbers.data(), unknowns})};
  }
  std::pair<Numbers, Numbers> get_bounds() const {
    const auto count = static_cast<std::size_t>(unknowns);
    return {Numbers(count, -range), Numbers(count, range)};
  }
};

} // namespace

Eigen::VectorXd minimizeWithSwarm(const CostFunction& cost, Eigen::Index unknowns, double range, std::size_t calls,
                                  std::uint64_t seed) {
  constexpr unsigned particles = 40;
  const auto own = static_cast<unsigned>(seed);
  const pagmo::population start{pagmo::problem{Problem{&cost, unknowns, range}}, particles, own};
  const pagmo::population end =
      pagmo::pso{static_cast<unsigned>(calls / particles), 0.7298, 2.05, 2.05, 0.5, 5, 2, 4, false, own}.evolve(start);
  const Numbers best = end.champion_x();
  return Eigen::Map<const Eigen::VectorXd>{best.data(), unknowns};
}

} // namespace naocal
