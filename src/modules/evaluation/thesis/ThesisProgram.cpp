#include "evaluation/thesis/ThesisProgram.hpp"

#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string_view>

namespace naocal {

namespace {

constexpr std::array<std::string_view, 8> jointsOfPoses{"HeadYaw",   "HeadPitch",  "LHipYawPitch", "LHipRoll",
                                                        "LHipPitch", "LKneePitch", "LAnklePitch",  "LAnkleRoll"};

constexpr std::array<std::array<double, jointsOfPoses.size()>, 10> anglesOfPoses{
    {{-0.174533, 0.0261799, -0.123562, -0.01902, -0.654258, 0.916302, -0.1899, 0.196644},
     {1.0472, 0.0523599, 0.142225, -0.14458, -0.766157, 0.755831, -0.083519, 0.235835},
     {-0.349066, 0.0261799, 0.00913228, -0.148691, 0.384545, 0, -0.0325521, 0.219594},
     {1.0472, 0.0785398, 0.0694736, 0.0647809, 0.304606, 0.290918, -0.285679, 0.0861697},
     {1.0472, 0.15708, -0.126484, 0.153048, 0.290292, 0.399904, -0.269959, 0.0584966},
     {-0.349066, 0.15708, 0.0655356, 0.0556168, -0.222721, 0.982111, -0.446933, 0.095796},
     {1.0472, 0.0785398, 0.14228, -0.271922, -0.179201, 0, 0.156896, 0.181623},
     {-0.349066, 0.18326, 0.123656, -0.154815, -0.0522833, 0.131743, -0.0798576, 0.151017},
     {-0.349066, 0.0261799, -0.00482113, -0.17056, -0.151595, 0.769183, -0.254284, 0.24294},
     {1.0472, 0.0785398, 0.286167, -0.379435, -0.516853, 0, 0.27044, 0.324099}}};

} // namespace

const double programAngleNoise = radians(0.007);

Eigen::Matrix2Xd FloorPattern::points() const {
  Eigen::Matrix2Xd result(2, columns * rows);
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < rows; ++row) {
      result.col(column * rows + row) << (column - columns / 2.0) * spacing, (row - rows / 2.0) * spacing;
    }
  }
  return result;
}

FloorPattern programGrid() {
  return {.columns = 40, .rows = 40, .spacing = 0.05};
}

FloorPattern programBoard() {
  return {.columns = 10, .rows = 14, .spacing = 0.05};
}

std::vector<std::string> programJoints() {
  return {jointsOfPoses.begin(), jointsOfPoses.end()};
}

std::vector<Eigen::VectorXd> programPoses(const std::vector<std::string>& names) {
  std::vector<Eigen::VectorXd> result(anglesOfPoses.size(), Eigen::VectorXd(eigenIndex(names.size())));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto joint = std::find(jointsOfPoses.begin(), jointsOfPoses.end(), names[i]);
    if (joint == jointsOfPoses.end()) {
      throw InputError{
          fmt::format("the thesis's poses: expected joints of the head and the left leg, found {}", names[i])};
    }
    for (std::size_t pose = 0; pose < anglesOfPoses.size(); ++pose) {
      result[pose][eigenIndex(i)] = anglesOfPoses[pose][static_cast<std::size_t>(joint - jointsOfPoses.begin())];
    }
  }
  return result;
}

Eigen::VectorXd drawProgramStart(const std::vector<std::string>& names, RandomStream& chance) {
  Eigen::VectorXd offsets(eigenIndex(names.size()));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double drawn = chance.uniformWithin(radians(6.5));
    offsets[eigenIndex(i)] = names[i] == "HeadPitch" ? std::max(0.0, drawn / 2) : drawn;
  }
  return offsets;
}

Eigen::VectorXd drawProgramOffsets(const std::vector<std::string>& names, RandomStream& chance) {
  Eigen::VectorXd offsets = drawProgramStart(names, chance);
  if (const auto yaw = std::find(names.begin(), names.end(), "HeadYaw"); yaw != names.end()) {
    offsets[yaw - names.begin()] = radians(3.3 + chance.uniformWithin(3.2));
  }
  return offsets;
}

Eigen::VectorXd drawProgramSet(const std::vector<std::string>& names, std::uint64_t seed, std::size_t number) {
  RandomStream errors{seed, fmt::format("thesis set {}", number)};
  return drawProgramOffsets(names, errors);
}

bool passesHorizonTest(const SoleCamera<double>& camera, const SoleCamera<double>::Transform& cameraFromSole) {
  const CameraIntrinsics& lens = camera.lens();
  const auto axis = camera.floorPoint(cameraFromSole, lens.cx, lens.cy);
  const double row = 0.75 * lens.height;
  return axis && axis->norm() <= programReach && camera.floorPoint(cameraFromSole, 0, row) &&
         camera.floorPoint(cameraFromSole, lens.width - 1, row);
}

} // namespace naocal
