#include "diagnose/LeftJson.hpp"

#include "diagnose/Shortened.hpp"
#include "diagnose/Thinned.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace naocal {

using Json = nlohmann::json;

namespace {

/// What was recorded at every picture and varied; four digits of what it varied by.
Json recordedJson(const Figures& figures) {
  Json result = Json::array();
  for (const DriverValues& driver : figures.recorded) {
    Json values = Json::array();
    const auto [least, most] = std::minmax_element(driver.atPicture.begin(), driver.atPicture.end());
    const double scale = std::pow(10.0, 4 - std::floor(std::log10(*most - *least)));
    for (const double value : driver.atPicture) {
      values.push_back(std::round(value * scale) / scale);
    }
    result.push_back({{"driver", driver.name}, {"what", driver.what}, {"unit", driver.unit}, {"values", values}});
    if (driver.motor) {
      result.back()["at"] = figures.taken.joints[*driver.motor];
    }
  }
  return result;
}

Json whatIfsJson(const Figures& figures, const Figures::Left& left, std::size_t mostPoints) {
  Json result = Json::array();
  for (const WhatIfs& joint : left.whatIfs) {
    Json points = Json::array();
    for (const WhatIf& point : thinned(joint.points, mostPoints)) {
      points.push_back({{"pictures", point.pictures},
                        {"deflection", shortened(point.deflection, 4)},
                        {"sigma", shortened(point.sigma, 3)}});
    }
    result.push_back({{"joint", figures.taken.joints[joint.motor]}, {"points", std::move(points)}});
    if (joint.points.size() > mostPoints) {
      result.back()["of"] = joint.points.size();
    }
  }
  return result;
}

/// Three numbers [m] to the micrometre.
Json micrometres(const Eigen::Vector3d& metres) {
  Json result = Json::array();
  for (const double value : metres) {
    result.push_back(std::round(value * 1e6) / 1e6);
  }
  return result;
}

Json shapesJson(const Figures& figures, const Figures::Left& left) {
  Json result = Json::array();
  for (const BoardShape& shape : left.shapes) {
    Json corners = Json::array();
    for (const BoardShape::Corner& corner : shape.corners) {
      corners.push_back({{"id", corner.id},
                         {"place", micrometres(corner.place)},
                         {"off", micrometres(corner.off)},
                         {"sigma", micrometres(corner.sigma)}});
    }
    result.push_back({{"board", figures.taken.boards[shape.board]},
                      {"p", shortened(shape.pValue, 3)},
                      {"corners", std::move(corners)}});
  }
  return result;
}

Json leftJson(const Figures& figures, const Figures::Left& left, std::size_t mostPoints) {
  Json cells = Json::array(), boards = Json::array();
  for (const Leftover::Cell& cell : left.leftover.cells) {
    cells.push_back({{"camera", figures.taken.pictures[cell.worstPicture].camera},
                     {"u", shortened(cell.u, 4)},
                     {"v", shortened(cell.v, 4)},
                     {"du", shortened(cell.du, 3)},
                     {"dv", shortened(cell.dv, 3)},
                     {"sigma", shortened(cell.sigma, 3)},
                     {"corners", cell.corners},
                     {"worstPicture", cell.worstPicture}});
  }
  for (const Leftover::Seen& seen : thinned(left.leftover.boards, mostPoints)) {
    boards.push_back({{"picture", seen.picture},
                      {"board", figures.taken.boards[seen.board]},
                      {"distance", shortened(seen.distance, 4)},
                      {"rmsPx", shortened(seen.rmsPx, 3)}});
  }
  return {{"whatIf", whatIfsJson(figures, left, mostPoints)},
          {"boardShapes", shapesJson(figures, left)},
          {"withinPictures", {{"noisePx", left.leftover.noisePx}, {"cells", cells}, {"boards", boards}}}};
}

} // namespace

void addLeft(const Figures& figures, std::size_t mostPoints, Json& file) {
  file["recorded"] = recordedJson(figures);
  file["left"] = {{"asGiven", leftJson(figures, figures.given, mostPoints)}};
  if (!figures.last.whatIfs.empty()) {
    file["left"]["withSuggested"] = leftJson(figures, figures.last, mostPoints);
  }
}

} // namespace naocal
