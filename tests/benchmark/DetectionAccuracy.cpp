#include "detect/BoardDetector.hpp"
#include "math/Angles.hpp"
#include "simulation/Renderer.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fmt/format.h>
#include <random>
#include <string>

namespace naocal {
namespace {

/// A row of the table: board geometry and picture quality.
struct Condition {
  int width = 640;      // image width [px]; height = 3/4 width, focal length = 7/8 width
  double square = 0.08; // side of a square [m]; markers: 3/4 of it
  double distance = 1;  // along the floor [m]
  double tilt = 0;      // about the x axis, towards the camera [deg]
  Appearance appearance;
  std::string remark;
};

CameraIntrinsics camera(int width) {
  return {width, width * 3 / 4, width * 0.875, width * 0.875, (width - 1) / 2., (width * 3 / 4 - 1) / 2., {}};
}

/// A 7x5 board at `distance` from a camera 0.5 m above the floor that points approximately at it.
RenderedBoard placedBoard(const Condition& condition, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit{-1, 1};
  CharucoPattern pattern;
  pattern.squareLength = condition.square;
  pattern.markerLength = 0.75 * condition.square;
  const Eigen::Matrix3d rotation = rotationX(radians(condition.tilt)) * rotationZ(radians(40) * unit(random));
  const Eigen::Vector3d centre{3.5 * condition.square, -2.5 * condition.square, 0};
  const RigidTransform worldFromBoard{rotation, Eigen::Vector3d{0, condition.distance, 0} - rotation * centre};
  const Eigen::Vector3d eye{0, 0, 0.5};
  const Eigen::Vector3d aim{0.05 * unit(random), condition.distance + 0.05 * unit(random), 0.02 * unit(random)};
  const Eigen::Vector3d forward = (aim - eye).normalized(),
                        right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  RigidTransform opticalFromWorld;
  opticalFromWorld.rotation << right.transpose(), forward.cross(right).transpose(), forward.transpose();
  opticalFromWorld.translation = -(opticalFromWorld.rotation * eye);
  return {"A", pattern, opticalFromWorld * worldFromBoard, 0.01};
}

struct Statistics {
  int possible = 0, found = 0, gross = 0, frames = 0, framesFound = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero(), squares = Eigen::Vector2d::Zero();
  double seconds = 0, largest = 0;
};

Statistics measured(const Condition& condition, int frames) {
  const Renderer renderer{camera(condition.width)};
  std::mt19937_64 random{1};
  Statistics statistics;
  for (int frame = 0; frame < frames; ++frame) {
    const RenderedBoard rendered = placedBoard(condition, random);
    const GreyPicture picture = renderer.render({{rendered}, {}}, condition.appearance, std::uint64_t(frame));
    const BoardCorners truth = trueCorners(rendered, renderer.intrinsics());
    Board board;
    board.id = std::string{"A"};
    board.pattern = rendered.pattern;
    const std::clock_t start = std::clock();
    const Detection detection = detectBoards(picture, {board}, renderer.intrinsics());
    statistics.seconds += double(std::clock() - start) / CLOCKS_PER_SEC;
    statistics.possible += int(truth.ids.size());
    ++statistics.frames;
    for (const BoardCorners& corners : detection.boards) {
      ++statistics.framesFound;
      for (std::size_t i = 0; i < corners.ids.size(); ++i) {
        const auto at = std::find(truth.ids.begin(), truth.ids.end(), corners.ids[i]) - truth.ids.begin();
        const Eigen::Vector2d error =
            corners.uv[i] -
            (at < std::ptrdiff_t(truth.ids.size()) ? truth.uv[std::size_t(at)] : Eigen::Vector2d{1e3, 1e3});
        ++statistics.found;
        statistics.largest = std::max(statistics.largest, error.norm());
        if (error.norm() > 1) {
          ++statistics.gross;
        } else {
          statistics.sum += error;
          statistics.squares += error.cwiseAbs2();
        }
      }
    }
  }
  return statistics;
}

/// Prints a row. Returns whether any corner was found.
bool print(const Condition& condition, int frames) {
  const Statistics s = measured(condition, frames);
  std::string line =
      fmt::format("| {:4} | {:3.0f} mm | {:.1f} m | {:2.0f} deg | {:18} | {:3.0f} % | {:3.0f} %", condition.width,
                  condition.square * 1e3, condition.distance, condition.tilt, condition.remark,
                  100. * s.framesFound / s.frames, 100. * s.found / std::max(1, s.possible));
  if (s.found > s.gross) {
    const Eigen::Vector2d bias = s.sum / (s.found - s.gross);
    const Eigen::Vector2d rms = (s.squares / (s.found - s.gross)).cwiseSqrt();
    line += fmt::format(" | {:+.3f} {:+.3f} | {:.3f} {:.3f} | {:4.2f} | {:.2f} %", bias.x(), bias.y(), rms.x(), rms.y(),
                        s.largest, 100. * s.gross / s.found);
  } else {
    line += " |      -        |      -      |  -   |   -   ";
  }
  std::puts(fmt::format("{} | {:5.1f} |", line, 1e3 * s.seconds / s.frames).c_str());
  std::fflush(stdout);
  return s.found > 0;
}

} // namespace
} // namespace naocal

/// Prints the errors of detected corners. Usage: [frames per row (20)]
int main(int argc, char** argv) {
  using namespace naocal;
  const int frames = argc > 1 ? std::stoi(argv[1]) : 20;
  std::puts(
      "| width | square | distance | tilt | remark | boards | corners | bias x y [px] | rms x y [px] | largest [px] "
      "| above 1 px | CPU ms |");
  std::puts("|---|---|---|---|---|---|---|---|---|---|---|---|");
  for (const int width : {640, 1280}) {
    for (const double tilt : {0., 30., 60.}) {
      for (const double square : {0.04, 0.06, 0.08, 0.1, 0.12}) {
        bool seen = true; // stops at the first distance without detections
        for (const double distance : {0.6, 0.8, 1., 1.3, 1.6, 2., 2.5, 3., 4.}) {
          seen = seen && print({width, square, distance, tilt, {}, "standard"}, frames);
        }
      }
    }
  }
  Appearance blur, moreBlur, noise, faint, dim, jpeg80, jpeg50, jpeg30;
  blur.blur = 1.2;
  blur.noise = 6;
  moreBlur.blur = 1.5;
  moreBlur.noise = 5;
  noise.noise = 10;
  faint.black = 60;
  faint.white = 130;
  faint.noise = 4;
  dim.vignetting = 0.5;
  jpeg80.jpegQuality = 80;
  jpeg50.jpegQuality = 50;
  jpeg30.jpegQuality = 30;
  for (const int width : {640, 1280}) {
    for (const double distance : {0.8, 1., 1.3}) {
      print({width, 0.08, distance, 0, blur, "blur 1.2, noise 6"}, frames);
      print({width, 0.08, distance, 0, moreBlur, "blur 1.5, noise 5"}, frames);
      print({width, 0.08, distance, 0, noise, "noise 10"}, frames);
      print({width, 0.08, distance, 0, faint, "60/130, noise 4"}, frames);
      print({width, 0.08, distance, 0, dim, "vignetting 0.5"}, frames);
      print({width, 0.08, distance, 0, jpeg80, "JPEG 80"}, frames);
      print({width, 0.08, distance, 0, jpeg50, "JPEG 50"}, frames);
      print({width, 0.08, distance, 0, jpeg30, "JPEG 30"}, frames);
    }
  }
}
