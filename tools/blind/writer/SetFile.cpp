#include "writer/SetFile.hpp"

#include <cmath>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>

namespace blind {

namespace {

using nlohmann::json;

const std::array<const char*, 2> cameraNames{"top", "bottom"}, sideNames{"left", "right"};

double rounded(double value, double digits) {
  return std::round(value * digits) / digits;
}

std::vector<int> recordedJoints(const Drawing& drawing) {
  std::vector<int> joints;
  for (std::size_t i = 0; i < drawing.joints.size(); ++i) {
    const std::string& name = drawing.joints[i].name;
    const bool arm =
        name.find("Shoulder") != name.npos || name.find("Elbow") != name.npos || name.find("Wrist") != name.npos;
    if (!arm) {
      joints.push_back(static_cast<int>(i));
    }
  }
  return joints;
}

json jointLists(const std::vector<int>& joints, const Reading& reading) {
  const auto list = [&](const Eigen::VectorXd& values, double digits) {
    json entries = json::array();
    for (const int joint : joints) {
      entries.push_back(rounded(values[joint], digits));
    }
    return entries;
  };
  json approach = json::array();
  for (const int joint : joints) {
    approach.push_back(reading.excursion[joint] > 0 ? -1 : 1);
  }
  return {{"measured", list(reading.measured, 1e8)},
          {"commanded", list(reading.commanded, 1e6)},
          {"velocity", list(reading.velocity, 1e6)},
          {"approach", std::move(approach)},
          {"temperature", list(reading.temperature, 1)}};
}

json cornersOf(const BoardSight& sight, const std::vector<Eigen::Vector2d>& seen) {
  json ids = json::array(), uv = json::array();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Eigen::Vector2d& corner = seen[i];
    if (corner.x() > 1 && corner.x() < LensDistortion::width - 2 && corner.y() > 1 &&
        corner.y() < LensDistortion::height - 2) {
      ids.push_back(sight.ids[i]);
      uv.push_back({rounded(corner.x(), 1e4), rounded(corner.y(), 1e4)});
    }
  }
  return {{"board", std::string(1, static_cast<char>('A' + sight.board))}, {"ids", ids}, {"uv", uv}};
}

json header(const Drawing& drawing, const Session& session, const std::string& robotName) {
  const json camera{{"width", LensDistortion::width}, {"height", LensDistortion::height}, {"fx", LensDistortion::focal},
                    {"fy", LensDistortion::focal},    {"cx", LensDistortion::cx},         {"cy", LensDistortion::cy},
                    {"distortion", {0, 0, 0, 0, 0}}};
  json set{{"format", "naocal-captures"},
           {"version", 1},
           {"robot", {{"model", "V6"}, {"bodyId", robotName}, {"headId", robotName}}},
           {"cameras", {{"top", camera}, {"bottom", camera}}},
           {"jointNames", json::array()},
           {"boards", json::array()},
           {"stances", json::array()},
           {"captures", json::array()}};
  for (const int joint : recordedJoints(drawing)) {
    set["jointNames"].push_back(drawing.joints[joint].name);
  }
  for (std::size_t board = 0; board < session.boards.size(); ++board) {
    constexpr int markersPerBoard = Sheet::squaresX * Sheet::squaresY / 2;
    set["boards"].push_back({{"id", std::string(1, static_cast<char>('A' + board))},
                             {"dictionary", "DICT_4X4_100"},
                             {"squaresX", Sheet::squaresX},
                             {"squaresY", Sheet::squaresY},
                             {"squareLength", Sheet::square},
                             {"markerLength", Sheet::marker},
                             {"firstMarkerId", markersPerBoard * board},
                             {"legacyPattern", false}});
  }
  for (std::size_t stance = 0; stance < session.stances.size(); ++stance) {
    set["stances"].push_back({{"id", stance}, {"supportFoot", sideNames[session.stances[stance].side]}});
  }
  return set;
}

} // namespace

ObservedCorners noisyCorners(const TruePictures& pictures, const Session& session, const NoiseRegime& noise,
                             RandomStream& chance) {
  std::map<std::pair<int, int>, Eigen::Vector2d> biases;
  ObservedCorners seen;
  for (const BoardSight& sight : session.sights) {
    const auto [bias, isNew] = biases.try_emplace({sight.reading, sight.camera}, Eigen::Vector2d::Zero());
    if (isNew && noise.pictureBias > 0) {
      bias->second = {chance.normal(noise.pictureBias), chance.normal(noise.pictureBias)};
    }
    seen.push_back(pictures.corners(sight));
    for (Eigen::Vector2d& corner : seen.back()) {
      for (double& coordinate : corner) {
        coordinate += noise.heavyTails ? chance.studentFour(sight.sigma) : chance.normal(sight.sigma);
      }
      corner += bias->second;
    }
  }
  return seen;
}

std::string imageName(int reading, int camera) {
  return fmt::format("images/{:04}-{}.png", reading, cameraNames[camera]);
}

json captureSetJson(const Drawing& drawing, const Session& session, const ObservedCorners& seen, bool pictures,
                    const std::string& robotName) {
  json set = header(drawing, session, robotName);
  const std::vector<int> joints = recordedJoints(drawing);
  const std::array<const char*, 3> kinds{"rest", "reapproach", "restand"};
  std::map<std::pair<int, int>, json> corners;
  for (std::size_t i = 0; i < session.sights.size(); ++i) {
    const BoardSight& sight = session.sights[i];
    if (json entry = cornersOf(sight, seen[i]); !entry["ids"].empty()) {
      corners[{sight.reading, sight.camera}].push_back(std::move(entry));
    }
  }
  for (int i = 0; i < static_cast<int>(session.readings.size()); ++i) {
    const Reading& reading = session.readings[i];
    for (int camera = 0; camera < 2; ++camera) {
      json capture{{"id", 2 * i + camera},
                   {"pose", fmt::format("P{:02}", reading.pose)},
                   {"repeat", reading.repeat},
                   {"repeatKind", kinds[static_cast<std::size_t>(reading.kind)]},
                   {"time", rounded(reading.time, 1e4)},
                   {"camera", cameraNames[camera]},
                   {"supportFoot", sideNames[session.stances[reading.stance].side]},
                   {"stance", reading.stance},
                   {"joints", jointLists(joints, reading)}};
      if (pictures) {
        capture["image"] = imageName(i, camera);
      } else {
        const auto found = corners.find({i, camera});
        capture["corners"] = found == corners.end() ? json::array() : std::move(found->second);
      }
      set["captures"].push_back(std::move(capture));
    }
  }
  return set;
}

} // namespace blind
