#pragma once

#include "writer/Session.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace blind {

/// One kind of hidden flaw and where it can sit.
struct Family {
  struct Unknown {
    std::string name, unit;
    double physical;      // a size to be expected of a used robot
    double plausible = 0; // how large it may plausibly be (1 sigma), where that differs
    double wide() const { return plausible > 0 ? plausible : physical; }
  };
  std::string effect; // the contract's name, or one of our own where the catalogue has none
  std::vector<Unknown> unknowns;
  std::vector<std::string> places; // of joints of a leg without the side's letter
  std::function<void(Flaws&, const Drawing&, const std::string& place, std::span<const double>)> apply;
  std::vector<std::string> drivers; // outside the catalogue: what the misfit varies with, in any of these words
};

/// Effects that every user of the catalogue may find.
const std::vector<Family>& catalogue();
/// A joint that stands otherwise from a time on.
const Family& offsetStep();
/// Physics that no catalogue lists; `physical` is 0.3 degrees at a joint's usual extreme.
const std::vector<Family>& outside();

/// The cameras' own families: shift, focal length, principal point, radial distortion.
const std::vector<std::string>& cameraFamilies();

/// The places of a family for a robot that stands on this foot (0 left, 1 right), as files name them.
std::vector<std::string> placesFor(const Family& family, int side, std::size_t boards);

} // namespace blind
