#include "writer/Corruption.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace blind {

namespace {

using nlohmann::json;

/// Index of a random capture with corners or an image.
std::size_t someCapture(const json& captures, RandomStream& chance) {
  while (true) {
    const auto index = static_cast<std::size_t>(chance.below(static_cast<int>(captures.size())));
    if (captures[index].contains("image") || !captures[index]["corners"].empty()) {
      return index;
    }
  }
}

std::string swapSign(int side, json& set, RandomStream& chance) {
  const std::vector<std::string> candidates{"HeadPitch", side == 0 ? "LHipPitch" : "RHipPitch",
                                            side == 0 ? "LKneePitch" : "RKneePitch",
                                            side == 0 ? "LAnklePitch" : "RAnklePitch"};
  const std::string joint = candidates[chance.below(static_cast<int>(candidates.size()))];
  std::size_t index = 0;
  while (set["jointNames"][index] != joint) {
    ++index;
  }
  for (json& capture : set["captures"]) {
    for (const char* list : {"measured", "commanded", "velocity"}) {
      capture["joints"][list][index] = -capture["joints"][list][index].get<double>();
    }
  }
  return joint;
}

/// Stale image buffer: a capture has the image of another pose.
std::string repeatPicture(json& captures, RandomStream& chance) {
  while (true) {
    json& from = captures[someCapture(captures, chance)];
    json& to = captures[someCapture(captures, chance)];
    if (from["pose"] != to["pose"] && from["camera"] == to["camera"]) {
      const char* what = from.contains("image") ? "image" : "corners";
      to[what] = from[what];
      return fmt::format("capture {}", to["id"].get<int>());
    }
  }
}

/// Robot touched during one image: shifts its corners.
std::string shakeCapture(json& captures, RandomStream& chance) {
  json& capture = captures[someCapture(captures, chance)];
  const double angle = chance.uniformWithin(3.14), distance = chance.between(8, 20); // [px]
  for (json& board : capture["corners"]) {
    for (json& uv : board["uv"]) {
      uv[0] = uv[0].get<double>() + distance * std::cos(angle);
      uv[1] = uv[1].get<double>() + distance * std::sin(angle);
    }
  }
  return fmt::format("capture {}", capture["id"].get<int>());
}

int boardSeenMost(const Session& session) {
  std::vector<int> seen(session.boards.size(), 0);
  for (const BoardSight& sight : session.sights) {
    ++seen[static_cast<std::size_t>(sight.board)];
  }
  return static_cast<int>(std::max_element(seen.begin(), seen.end()) - seen.begin());
}

/// Times of selected sights, sorted: a displacement outside them is unobservable.
template <typename Which> std::vector<double> timesOf(const Session& session, Which which) {
  std::vector<double> result;
  for (const BoardSight& sight : session.sights) {
    if (which(sight)) {
      result.push_back(session.readings[static_cast<std::size_t>(sight.reading)].time);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

const std::vector<std::string>& absorbedKinds() {
  static const std::vector<std::string> kinds{"one-sided gap", "one-sided approach", "constant temperature",
                                              "constant angle", "no motion"};
  return kinds;
}

const std::vector<std::string>& corruptions() {
  static const std::vector<std::string> kinds{"swapped sign", "swapped cameras", "repeated picture", "kicked board",
                                              "board size",   "board pattern",   "bad capture",      "slipped robot"};
  return kinds;
}

const std::vector<std::string>& eventKinds() {
  static const std::vector<std::string> kinds{"kicked board", "slipped robot", "offset step"};
  return kinds;
}

void corruptSession(const std::string& kind, Session& session, RandomStream& chance) {
  if (kind != "kicked board" && kind != "slipped robot") {
    return;
  }
  const bool board = kind == "kicked board";
  Displacement displacement;
  displacement.which = board ? boardSeenMost(session) : 0; // the first stance
  const std::vector<double> seen = timesOf(session, [&](const BoardSight& sight) {
    return displacement.which ==
           (board ? sight.board : session.readings[static_cast<std::size_t>(sight.reading)].stance);
  });
  displacement.time = seen.front() + (seen.back() - seen.front()) * chance.between(0.3, 0.7);
  const double direction = chance.uniformWithin(3.14), distance = chance.between(0.015, 0.04);
  displacement.by = {distance * std::cos(direction), distance * std::sin(direction), chance.uniformWithin(0.05)};
  (board ? session.kickedBoard : session.slippedStance) = displacement;
}

std::string corruptFile(const std::string& kind, int side, json& set, RandomStream& chance) {
  if (kind == "swapped sign") {
    return swapSign(side, set, chance);
  }
  if (kind == "swapped cameras") {
    for (json& capture : set["captures"]) {
      capture["camera"] = capture["camera"] == "top" ? "bottom" : "top";
    }
  } else if (kind == "repeated picture") {
    return repeatPicture(set["captures"], chance);
  } else if (kind == "bad capture") {
    return shakeCapture(set["captures"], chance);
  } else if (kind == "board size") {
    const double factor = chance.sign() < 0 ? 0.9 : 1.1;
    for (json& board : set["boards"]) {
      board["squareLength"] = factor * board["squareLength"].get<double>();
      board["markerLength"] = factor * board["markerLength"].get<double>();
    }
    return fmt::format("{}", factor);
  } else if (kind == "board pattern") {
    for (json& board : set["boards"]) {
      std::swap(board["squaresX"], board["squaresY"]);
    }
  }
  return {};
}

} // namespace blind
