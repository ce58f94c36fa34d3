#include "estimation/NormalEquations.hpp"

#include <algorithm>

namespace naocal {

namespace {

/// Loss of four corners and its derivative, their weight, for a non-quadratic loss.
void weigh(const Double4& squaredDistance, const Loss& loss, Double4& rho, Double4& weight) {
  for (int i = 0; i < 4; ++i) {
    const auto [value, slope] = loss(squaredDistance[i]);
    rho[i] *= value;
    weight[i] *= slope;
  }
}

/// Set of numbers below `end`, listed in ascending order.
class Numbers {
public:
  explicit Numbers(std::size_t end) : has_(end, 0) {}
  void add(const std::vector<std::size_t>& numbers) {
    for (std::size_t number : numbers) {
      has_[number] = 1;
    }
  }
  std::vector<std::size_t> list() const {
    std::vector<std::size_t> result;
    result.reserve(has_.size());
    for (std::size_t number = 0; number < has_.size(); ++number) {
      if (has_[number] != 0) {
        result.push_back(number);
      }
    }
    return result;
  }

private:
  std::vector<char> has_;
};

/// Ordered set of numbers below `end`, in order of insertion.
template <typename Number> class Listed {
public:
  Listed(std::size_t end, std::vector<Number>& list) : known_(end, -1), list_{list} {}
  /// Index of `number` in the list; appends it if new.
  Eigen::Index indexOf(Number number) {
    Eigen::Index& place = known_[static_cast<std::size_t>(number)];
    if (place < 0) {
      place = static_cast<Eigen::Index>(list_.size());
      list_.push_back(number);
    }
    return place;
  }

private:
  std::vector<Eigen::Index> known_;
  std::vector<Number>& list_;
};

/// Quantities and columns that affect a measurement. `concerns`: whether a quantity does.
template <typename Concerns>
PreparedImage::Group groupOf(const StateLayout& quantities, const std::vector<std::size_t>& unknowns,
                             const PreparedImage& prepared, const Concerns& concerns) {
  PreparedImage::Group group;
  const std::vector<StateDerivative>& slopes = prepared.slopes.entries();
  const std::size_t most = slopes.size() + prepared.joints.size();
  group.quantities.reserve(most);
  group.columns.reserve(most);
  group.shares.reserve(most);
  const std::vector<std::size_t>& deflections = prepared.deflections;
  const std::size_t columns =
      unknowns.size() + (deflections.empty() ? 0 : 1 + *std::max_element(deflections.begin(), deflections.end()));
  Listed columnPlaces{columns, group.columns};
  Listed quantityPlaces{quantities.size(), group.quantities};
  const auto add = [&](Eigen::Index column, std::size_t quantity, std::size_t slope) {
    if (concerns(quantity)) {
      group.shares.push_back({static_cast<std::int32_t>(columnPlaces.indexOf(column)),
                              static_cast<std::int32_t>(quantityPlaces.indexOf(quantity)),
                              static_cast<std::int32_t>(slope)});
    }
  };
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    add(std::lower_bound(unknowns.begin(), unknowns.end(), slopes[i].unknown) - unknowns.begin(), slopes[i].quantity,
        i);
  }
  for (std::size_t i = 0; i < prepared.joints.size(); ++i) {
    add(static_cast<Eigen::Index>(unknowns.size() + prepared.deflections[i]), quantities.angle(prepared.joints[i]),
        slopes.size() + i);
  }
  group.quantities.shrink_to_fit();
  group.columns.shrink_to_fit();
  group.shares.shrink_to_fit();
  return group;
}

/// The same for the corners of a board, with the quantities that are extras.
PreparedImage::Group groupOf(const ObservationChain& view, const StateLayout& quantities,
                             const std::vector<std::size_t>& unknowns, const PreparedImage& prepared) {
  PreparedImage::Group group = groupOf(quantities, unknowns, prepared, [&](std::size_t quantity) {
    const auto board = quantities.boardOf(quantity);
    return board ? *board == view.board() : !quantities.isOfInstrument(quantity);
  });
  for (std::size_t quantity : group.quantities) {
    if (const auto extra = view.extraIndex(quantity)) {
      group.extras.push_back(*extra);
    }
  }
  return group;
}

/// The same for a witness; its own quantities are extras.
PreparedImage::Group groupOf(const WitnessObservation& observation, const StateLayout& quantities,
                             const std::vector<std::size_t>& unknowns, const PreparedImage& prepared) {
  const std::vector<std::size_t>& own = observation.witness->own();
  PreparedImage::Group group = groupOf(quantities, unknowns, prepared, [&](std::size_t quantity) {
    const bool isOfRobot = !quantities.boardOf(quantity) && !quantities.isOfInstrument(quantity);
    return isOfRobot ? observation.view.has_value() : std::find(own.begin(), own.end(), quantity) != own.end();
  });
  group.extras.resize(own.size());
  return group;
}

} // namespace

void NormalEquations::clear(Eigen::Index columns) {
  gram_.setZero(columns, columns);
  gradient_.setZero(columns);
}

void NormalEquations::add(const ImageNormalEquations::Square& gram, const ImageNormalEquations::Column& gradient,
                          const Eigen::MatrixXd& motion, const PreparedImage::Group& group, const double* slopeValues) {
  if (group.extras.empty()) {
    addRows<6>(gram, gradient, motion, group, slopeValues);
  } else {
    addRows<Eigen::Dynamic>(gram, gradient, motion, group, slopeValues);
  }
}

/// `Rows`: rows of the motion, six without extras.
template <int Rows>
void NormalEquations::addRows(const ImageNormalEquations::Square& gram, const ImageNormalEquations::Column& gradient,
                              const Eigen::MatrixXd& motion, const PreparedImage::Group& group,
                              const double* slopeValues) {
  const std::size_t rows = Rows == Eigen::Dynamic ? static_cast<std::size_t>(motion.rows()) : Rows;
  const std::size_t columns = group.columns.size(), fours = (columns + 3) / 4;
  moving_.assign(rows * fours, Four{});
  half_.resize(rows * fours);
  for (const PreparedImage::Group::Share& share : group.shares) {
    Four* const four = &moving_[share.column / 4 * rows];
    const double slope = slopeValues[share.slope];
    for (std::size_t row = 0; row < rows; ++row) {
      four[row].columns[share.column % 4] += slope * motion(row, share.quantity);
    }
  }
  dispatchSimd([&]() __attribute__((always_inline)) {
    for (std::size_t four = 0; four < fours; ++four) {
      for (std::size_t i = 0; i < rows; ++i) {
        Double4 sum{};
        for (std::size_t row = 0; row < rows; ++row) {
          sum += gram(row, i) * moving_[four * rows + row].lane();
        }
        half_[four * rows + i].lane() = sum;
      }
    }
    for (std::size_t column = 0; column < columns; ++column) {
      const Four* const own = &moving_[column / 4 * rows];
      const std::size_t lane = column % 4;
      double* const sums = &gram_(0, group.columns[column]);
      double sumOfGradient = 0;
      for (std::size_t row = 0; row < rows; ++row) {
        sumOfGradient += gradient[row] * own[row].columns[lane];
      }
      gradient_[group.columns[column]] += sumOfGradient;
      for (std::size_t four = 0; four < fours; ++four) {
        Double4 sum{};
        for (std::size_t row = 0; row < rows; ++row) {
          sum += own[row].columns[lane] * half_[four * rows + row].lane();
        }
        Four taken;
        taken.lane() = sum;
        for (std::size_t i = 4 * four; i < std::min(4 * four + 4, columns); ++i) {
          sums[group.columns[i]] += taken.columns[i % 4];
        }
      }
    }
  });
}

void ImageNormalEquations::clear(std::size_t extras) {
  width_ = 6 + extras;
  std::fill_n(products_, width_ * (width_ + 1) / 2, Double4{});
  std::fill_n(gradient_, width_, Double4{});
  squares_ = cost_ = corners_ = freedom_ = Double4{};
}

void ImageNormalEquations::add(const CornerBlocks& corners, const ProjectedBlocks& projected,
                               const std::vector<CornerShift>& extraShifts, double pixelNoise,
                               const ObservationWeight& weight, const Loss& loss) {
  const double share = weight.share, freedom = weight.freedom();
  const double information = share / (pixelNoise * pixelNoise);
  const std::size_t blocks = corners.size();
  const bool quadratic = loss.scale == 0;
  dispatchSimd([ =, this, &corners, &projected, &extraShifts, &loss ]() __attribute__((always_inline)) {
    Double4 squares{}, cost{}, counted{};
    for (std::size_t block = 0; block < blocks; ++block) {
      const ProjectedBlock& seen = projected[block];
      const Double4 ru = seen.u - corners[block].u, rv = seen.v - corners[block].v;
      const Double4 rr = ru * ru + rv * rv;
      Double4 w = corners[block].present, rho = w;
      if (quadratic) {
        rho *= information * rr;
      } else {
        weigh(information * rr, loss, rho, w);
      }
      counted += w > 0 ? Double4{} + 1 : Double4{};
      w *= share;
      squares += w * rr;
      cost += rho;
      Double4* product = products_;
#pragma GCC unroll 6
      for (std::size_t i = 0; i < 6; ++i) {
        const Double4 wu = w * seen.rowsU[i], wv = w * seen.rowsV[i];
        gradient_[i] = gradient_[i] + wu * ru + wv * rv;
#pragma GCC unroll 6
        for (std::size_t j = 0; j <= i; ++j, ++product) {
          *product = *product + wu * seen.rowsU[j] + wv * seen.rowsV[j];
        }
      }
      for (std::size_t i = 6; i < width_; ++i) {
        const CornerShift& row = extraShifts[(i - 6) * blocks + block];
        const Double4 wu = w * row.u, wv = w * row.v;
        gradient_[i] += wu * ru + wv * rv;
        for (std::size_t j = 0; j < 6; ++j) {
          *product++ += wu * seen.rowsU[j] + wv * seen.rowsV[j];
        }
        for (std::size_t j = 6; j <= i; ++j) {
          const CornerShift& other = extraShifts[(j - 6) * blocks + block];
          *product++ += wu * other.u + wv * other.v;
        }
      }
    }
    squares_ += squares;
    cost_ += cost;
    corners_ += share * counted;
    freedom_ += freedom * counted;
  });
}

ImageNormalEquations::Square ImageNormalEquations::gram() const {
  const auto width = static_cast<Eigen::Index>(width_);
  Square result(width, width);
  const Double4* product = products_;
  for (Eigen::Index i = 0; i < width; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      result(i, j) = result(j, i) = sum(*product++);
    }
  }
  return result;
}

ImageNormalEquations::Column ImageNormalEquations::gradient() const {
  Column result(static_cast<Eigen::Index>(width_));
  for (std::size_t i = 0; i < width_; ++i) {
    result[static_cast<Eigen::Index>(i)] = sum(gradient_[i]);
  }
  return result;
}

void prepareImage(const Measurements& measurements, const ImageObservation& picture,
                  const std::vector<std::size_t>& unknowns, PreparedImage& prepared) {
  Numbers links{measurements.robot.links.size()};
  const std::vector<StateDerivative>& slopes = prepared.slopes.entries();
  prepared.slopeValues.clear();
  for (const StateDerivative& slope : slopes) {
    prepared.slopeValues.push_back(slope.value);
  }
  for (const std::size_t joint : prepared.joints) {
    prepared.slopeValues.push_back(measurements.robot.joints[joint].ratio);
  }
  const bool boardsMove = std::any_of(slopes.begin(), slopes.end(), [&](const StateDerivative& slope) {
    return measurements.quantities.boardOf(slope.quantity).has_value();
  });
  prepared.groups.clear();
  for (std::size_t i = 0; i < picture.observations.size(); ++i) {
    const ObservationChain& view = picture.observations[i].view;
    links.add(view.links());
    const auto known = std::find_if(prepared.groups.begin(), prepared.groups.end(), [&](const auto& group) {
      return !boardsMove && picture.observations[group.observations.front()].view.sharesPath(view);
    });
    PreparedImage::Group& group =
        known != prepared.groups.end()
            ? *known
            : prepared.groups.emplace_back(groupOf(view, measurements.quantities, unknowns, prepared));
    group.observations.push_back(i);
  }
  prepared.floors.clear();
  for (const ObservationChain& sole : picture.otherSoles) {
    links.add(sole.links());
    prepared.floors.push_back(groupOf(sole, measurements.quantities, unknowns, prepared));
    prepared.floors.back().extras.clear();
  }
  if (prepared.torso) {
    links.add(prepared.torso->links());
    prepared.imu = groupOf(*prepared.torso, measurements.quantities, unknowns, prepared);
    prepared.imu.extras = {extraCount, extraCount + 1}; // roll and pitch of the IMU
  }
  for (const WitnessObservation& witness : picture.witnesses) {
    if (witness.view) {
      links.add(witness.view->links());
    }
    prepared.witnesses.push_back(groupOf(witness, measurements.quantities, unknowns, prepared));
  }
  prepared.links = links.list();
}

} // namespace naocal
