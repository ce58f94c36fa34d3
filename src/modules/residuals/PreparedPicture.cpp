#include "residuals/PreparedPicture.hpp"

#include <algorithm>

namespace naocal {

namespace {

/// Numbers below `end`, each once, ascending.
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

/// A list of numbers below `end`, each once, in the order they came.
template <typename Number> class Listed {
public:
  Listed(std::size_t end, std::vector<Number>& list) : known_(end, -1), list_{list} {}
  /// Where it stands in the list, to which it is added where it is new.
  Eigen::Index of(Number number) {
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

/// The board whose placement or shape a quantity is, if it is one.
std::optional<std::size_t> boardOf(const Quantities& quantities, std::size_t quantity) {
  const std::size_t first = quantities.board(0);
  return quantity >= first ? std::optional{(quantity - first) / (quantities.board(1) - first)} : std::nullopt;
}

/// What moves the corners that `view` sees.
PreparedPicture::Group groupOf(const View& view, const Quantities& quantities, const std::vector<std::size_t>& unknowns,
                               const PreparedPicture& prepared) {
  PreparedPicture::Group group;
  const std::vector<Slope>& slopes = prepared.slopes.list();
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
    const auto board = boardOf(quantities, quantity);
    if (!board || *board == view.board()) {
      group.shares.push_back({columnPlaces.of(column), quantityPlaces.of(quantity), slope});
    }
  };
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    add(std::lower_bound(unknowns.begin(), unknowns.end(), slopes[i].unknown) - unknowns.begin(), slopes[i].quantity,
        1 + i);
  }
  for (std::size_t i = 0; i < prepared.joints.size(); ++i) {
    add(static_cast<Eigen::Index>(unknowns.size() + prepared.deflections[i]), quantities.angle(prepared.joints[i]), 0);
  }
  for (std::size_t quantity : group.quantities) {
    if (const auto extra = view.extra(quantity)) {
      group.extras.push_back(*extra);
    }
  }
  return group;
}

} // namespace

void prepare(const Measurements& measurements, const Picture& picture, const std::vector<std::size_t>& unknowns,
             PreparedPicture& prepared) {
  Numbers links{measurements.robot.links.size()};
  const std::vector<Slope>& slopes = prepared.slopes.list();
  prepared.slopeValues = {1};
  for (const Slope& slope : slopes) {
    prepared.slopeValues.push_back(slope.value);
  }
  const bool boardsMove = std::any_of(slopes.begin(), slopes.end(), [&](const Slope& slope) {
    return boardOf(measurements.quantities, slope.quantity).has_value();
  });
  prepared.groups.clear();
  for (std::size_t i = 0; i < picture.sightings.size(); ++i) {
    const View& view = picture.sightings[i].view;
    links.add(view.links());
    const auto known = std::find_if(prepared.groups.begin(), prepared.groups.end(), [&](const auto& group) {
      return !boardsMove && picture.sightings[group.sightings.front()].view.sharesPath(view);
    });
    PreparedPicture::Group& group =
        known != prepared.groups.end()
            ? *known
            : prepared.groups.emplace_back(groupOf(view, measurements.quantities, unknowns, prepared));
    group.sightings.push_back(i);
  }
  if (picture.otherSole) {
    links.add(picture.otherSole->links());
    prepared.floor = groupOf(*picture.otherSole, measurements.quantities, unknowns, prepared);
    prepared.floor.extras.clear();
  }
  if (prepared.torso) {
    links.add(prepared.torso->links());
    prepared.imu = groupOf(*prepared.torso, measurements.quantities, unknowns, prepared);
    prepared.imu.extras = {extraCount, extraCount + 1}; // roll and pitch of the unit
  }
  prepared.links = links.list();
}

} // namespace naocal
