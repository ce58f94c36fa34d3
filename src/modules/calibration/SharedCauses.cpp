#include "calibration/SharedCauses.hpp"

#include "calibration/Fit.hpp"
#include "inference/Thresholds.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Statistics.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <string>

namespace naocal {

namespace {

constexpr int permutations = 999; // p-values down to 0.001, a tenth of the level

/// What a view or reading is of: a board in a camera, or a target of a tracker.
struct ViewKind {
  std::string board, camera;

  auto operator<=>(const ViewKind&) const = default;
};

/// Views of one kind in one pose.
struct ViewCount {
  double rejected = 0, all = 0;

  bool isRejected() const { return 2 * rejected > all; }
};

/// One pose with the values that rejections may follow.
struct JudgedPose {
  std::map<ViewKind, ViewCount> cells;
  std::vector<double> drivers;

  double rejectedShare() const {
    double rejected = 0;
    for (const auto& [cell, count] : cells) {
      rejected += count.isRejected() ? 1 : 0;
    }
    return rejected / std::max<double>(1, static_cast<double>(cells.size()));
  }
};

bool isRejected(const BoardObservation& observation) {
  double kept = 0;
  for (std::size_t i = 0; i < observation.ids.size(); ++i) {
    kept += observation.corners[i / 4].present[static_cast<Eigen::Index>(i % 4)] >= outlierWeight ? 1 : 0;
  }
  return 2 * kept < static_cast<double>(observation.ids.size());
}

/// Names of the drivers of `JudgedPose`, in their order.
std::vector<std::string> nameDrivers(const Measurements& measurements) {
  std::vector<std::string> names;
  for (const std::size_t joint : measurements.joints) {
    const std::string& name = measurements.robot.joints[joint].name;
    names.insert(names.end(), {name, name, "approach of " + name});
  }
  names.push_back("time");
  return names;
}

JudgedPose judgePose(const Measurements& measurements, const PoseGroup& pose) {
  JudgedPose result;
  const ImageObservation& first = measurements.pictures[pose.readings.front().pictures.front()];
  for (const EncoderSample& reading : pose.readings) {
    for (const std::size_t index : reading.pictures) {
      const ImageObservation& picture = measurements.pictures[index];
      for (const BoardObservation& observation : picture.observations) {
        ViewCount& count = result.cells[{measurements.targets[observation.view.board()].name,
                                         measurements.robot.cameras[picture.camera].name}];
        ++count.all;
        count.rejected += isRejected(observation) ? 1 : 0;
      }
      for (const WitnessObservation& observation : picture.witnesses) {
        if (observation.view) {
          ViewCount& count = result.cells[{observation.witness->target(), {}}];
          ++count.all;
          count.rejected += observation.weight < outlierWeight ? 1 : 0;
        }
      }
    }
  }
  for (const std::size_t joint : measurements.joints) {
    const double angle = first.instant.q[eigenIndex(joint)], approach = first.instant.approach[eigenIndex(joint)];
    result.drivers.insert(result.drivers.end(), {angle, angle, std::isnan(approach) ? 0 : approach});
  }
  result.drivers.push_back(1e6 * static_cast<double>(first.set) + first.instant.time.count()); // sets in their order
  return result;
}

/// Ranks, equal values sharing their mean rank, centred and of unit length; zero if all values are equal.
Eigen::VectorXd rank(const Eigen::VectorXd& values) {
  const Eigen::Index count = values.size();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return values[a] < values[b]; });
  Eigen::VectorXd ranks(count);
  for (Eigen::Index from = 0; from < count;) {
    Eigen::Index to = from + 1;
    while (to < count && values[order[static_cast<std::size_t>(to)]] == values[order[static_cast<std::size_t>(from)]]) {
      ++to;
    }
    for (Eigen::Index i = from; i < to; ++i) {
      ranks[order[static_cast<std::size_t>(i)]] = 0.5 * static_cast<double>(from + to - 1);
    }
    from = to;
  }
  ranks.array() -= ranks.mean();
  const double length = ranks.norm();
  return length > 0 ? Eigen::VectorXd{ranks / length} : ranks;
}

/// Ranks of every driver: one column each. Of a joint's three, the second is the distance of its angle from the median.
Eigen::MatrixXd rankDrivers(const std::vector<JudgedPose>& poses) {
  const std::size_t count = poses.front().drivers.size();
  Eigen::MatrixXd result(eigenIndex(poses.size()), eigenIndex(count));
  for (std::size_t driver = 0; driver < count; ++driver) {
    Eigen::VectorXd values(eigenIndex(poses.size()));
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
      values[eigenIndex(pose)] = poses[pose].drivers[driver];
    }
    if (driver + 1 < count && driver % 3 == 1) {
      values = (values.array() - medianOf({values.begin(), values.end()})).abs().eval();
    }
    result.col(eigenIndex(driver)) = rank(values);
  }
  return result;
}

/// The statistics of a family, and how often the largest of a permuted family reaches each.
struct Family {
  std::vector<std::string> names;
  Eigen::VectorXd seen;

  /// `draw`: the statistics of one permutation.
  template <class Draw> void appendCauses(const Draw& draw, std::vector<SharedCause>& causes) const {
    constexpr double families = 2;
    Eigen::VectorXd reached = Eigen::VectorXd::Zero(seen.size());
    for (int i = 0; i < permutations; ++i) {
      const double most = draw().maxCoeff();
      reached.array() += (most >= seen.array() - 1e-12).template cast<double>();
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      const double p = families * (1 + reached[eigenIndex(i)]) / (1 + permutations);
      if (p < threshold::sharedCause) {
        causes.push_back({names[i], p});
      }
    }
  }
};

void appendDrivers(const Measurements& measurements, const std::vector<JudgedPose>& poses,
                   std::vector<SharedCause>& causes) {
  Eigen::VectorXd shares(eigenIndex(poses.size()));
  for (std::size_t pose = 0; pose < poses.size(); ++pose) {
    shares[eigenIndex(pose)] = poses[pose].rejectedShare();
  }
  Eigen::VectorXd ranks = rank(shares);
  const Eigen::MatrixXd drivers = rankDrivers(poses);
  const auto correlate = [&] { return Eigen::VectorXd{(drivers.transpose() * ranks).cwiseAbs()}; };
  const Family family{nameDrivers(measurements), correlate()};
  std::mt19937_64 random{1};
  family.appendCauses(
      [&] {
        std::shuffle(ranks.data(), ranks.data() + ranks.size(), random);
        return correlate();
      },
      causes);
}

/// The cells of one pose: the categories (boards, then cameras) of each, and whether it is rejected.
struct PoseViews {
  std::vector<std::array<std::size_t, 2>> categories;
  std::vector<char> rejected;
};

/// Excess of rejections over what chance leaves to each category, in standard deviations (hypergeometric).
Eigen::VectorXd countExcess(const std::vector<PoseViews>& poses, std::size_t categories) {
  Eigen::VectorXd excess = Eigen::VectorXd::Zero(eigenIndex(categories)), variance = excess;
  for (const PoseViews& pose : poses) {
    const auto all = static_cast<double>(pose.rejected.size());
    const auto rejected = static_cast<double>(std::count(pose.rejected.begin(), pose.rejected.end(), char{1}));
    std::map<std::size_t, double> members;
    for (std::size_t cell = 0; cell < pose.rejected.size(); ++cell) {
      for (const std::size_t category : pose.categories[cell]) {
        ++members[category];
        excess[eigenIndex(category)] += pose.rejected[cell];
      }
    }
    for (const auto& [category, count] : members) {
      const double share = count / all;
      excess[eigenIndex(category)] -= rejected * share;
      variance[eigenIndex(category)] += all > 1 ? rejected * share * (1 - share) * (all - rejected) / (all - 1) : 0;
    }
  }
  return (variance.array() > 0).select(excess.array() / variance.array().sqrt(), 0);
}

void appendPlaces(const std::vector<JudgedPose>& poses, std::vector<SharedCause>& causes) {
  std::map<std::string, std::size_t> categories;
  std::vector<PoseViews> all;
  for (const JudgedPose& pose : poses) {
    PoseViews& cells = all.emplace_back();
    for (const auto& [cell, count] : pose.cells) {
      const auto categoryOf = [&](const std::string& name) {
        return categories.try_emplace(name, categories.size()).first->second;
      };
      cells.categories.push_back({categoryOf("board " + cell.board), categoryOf("camera " + cell.camera)});
      cells.rejected.push_back(count.isRejected() ? 1 : 0);
    }
  }
  Family family{std::vector<std::string>(categories.size()), countExcess(all, categories.size())};
  for (const auto& [name, index] : categories) {
    family.names[index] = name;
  }
  std::mt19937_64 random{2};
  family.appendCauses(
      [&] {
        for (PoseViews& pose : all) {
          std::shuffle(pose.rejected.begin(), pose.rejected.end(), random);
        }
        return countExcess(all, categories.size());
      },
      causes);
}

} // namespace

std::vector<SharedCause> findSharedCauses(const Measurements& weighed) {
  std::vector<JudgedPose> poses;
  for (const PoseGroup& pose : weighed.poses) {
    poses.push_back(judgePose(weighed, pose));
  }
  const auto isHit = [](const JudgedPose& pose) { return pose.rejectedShare() > 0; };
  if (std::count_if(poses.begin(), poses.end(), isHit) < 2) {
    return {};
  }
  std::vector<SharedCause> causes;
  appendDrivers(weighed, poses, causes);
  appendPlaces(poses, causes);
  std::stable_sort(causes.begin(), causes.end(), [](const SharedCause& a, const SharedCause& b) { return a.p < b.p; });
  causes.erase(std::unique(causes.begin(), causes.end(),
                           [](const SharedCause& a, const SharedCause& b) { return a.driver == b.driver; }),
               causes.end());
  return causes;
}

} // namespace naocal
