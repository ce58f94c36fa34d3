#include "world/machines/Workcell.hpp"

#include "world/Mechanism.hpp"
#include "world/Pictures.hpp"

#include <cmath>

namespace blind {

namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Pixel of a point in the frame of a camera that looks along z.
Eigen::Vector2d pixelOf(const Vector3d& inCamera) {
  return projectPoint({inCamera.z(), -inCamera.x(), -inCamera.y()}, {});
}

Transform standAt(const Workcell& cell, double time) {
  const bool moved = cell.moved && time >= cell.moved->time;
  return moved ? cell.worldFromStand * cell.moved->by : cell.worldFromStand;
}

VectorXd pixels(const Workcell& cell, const Transform& cameraFromBoard, const std::vector<int>& seen) {
  VectorXd result{2 * static_cast<Index>(seen.size())};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Vector3d& point = cell.points[static_cast<std::size_t>(seen[i])];
    result.segment<2>(2 * static_cast<Index>(i)) = pixelOf(cameraFromBoard * point);
  }
  return result;
}

} // namespace

Vector3d rotationVector(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  const Eigen::AngleAxisd turn{Eigen::Matrix3d{from.transpose() * to}};
  return turn.angle() * turn.axis();
}

bool carriesCamera(Witness witness) {
  return witness == Witness::wristCamera || witness == Witness::footAndHead;
}

bool seesBoard(Witness witness) {
  return carriesCamera(witness) || witness == Witness::cameraBeside;
}

MachineBody bodyOf(const Workcell& cell) {
  return {*cell.machine, cell.flaws, cell.worldFromSole};
}

VectorXd linkAngles(const Workcell& cell, const WorkcellReading& reading) {
  const VectorXd read = reading.measured + reading.unread - cell.offsets;
  VectorXd links = read;
  for (Index i = 0; i < read.size(); ++i) {
    const JointFlaws& flaws = cell.flaws.joints[static_cast<std::size_t>(i)];
    const double approach = reading.excursion[i] > 0 ? -1 : 1;
    const int before = cell.machine->joints[static_cast<std::size_t>(i)].parent;
    const double pulled = before < 0 ? 0 : cell.flaws.links[static_cast<std::size_t>(i)].coupling * read[before];
    links[i] =
        linkAngle(read[i], flaws) + flaws.creep * reading.time - flaws.lag / 2 * approach + pulled + reading.stuck[i];
  }
  bool loose = false;
  for (const JointFlaws& joint : cell.flaws.joints) {
    loose = loose || joint.gap != 0;
  }
  if (loose) {
    const MachineBody body = bodyOf(cell);
    const VectorXd load = body.torques(body.settled(links));
    for (Index i = 0; i < links.size(); ++i) {
      const JointFlaws& flaws = cell.flaws.joints[static_cast<std::size_t>(i)];
      const double approach = reading.excursion[i] > 0 ? -1 : 1;
      const double side = std::abs(load[i]) > flaws.gapFriction ? std::copysign(1.0, load[i]) : -approach;
      links[i] += flaws.gap / 2 * side;
    }
  }
  return links;
}

Transform standFromHand(const Workcell& cell, const MachineBody& body, const WorkcellReading& reading,
                        const VectorXd& angles) {
  Transform result =
      standAt(cell, reading.time).inverse() * body.worldFromAttached(body.settled(angles), 0) * cell.handFromTool;
  result.shift *= 1 + cell.flaws.trackerScale;
  return result;
}

VectorXd measure(const Workcell& cell, const MachineBody& body, const WorkcellReading& reading,
                 const VectorXd& angles) {
  if (cell.witness == Witness::touch) {
    const Vector3d ball = body.worldFromAttached(body.settled(angles), 0) * cell.points.front();
    return ball - cell.places[static_cast<std::size_t>(reading.seen.front())];
  }
  if (cell.witness == Witness::trackedFrame) {
    const Transform seen = standFromHand(cell, body, reading, angles);
    VectorXd result{6};
    result << seen.shift, rotationVector(reading.about, seen.turn);
    return result;
  }
  const Transform stand = standAt(cell, reading.time);
  const Transform hand = body.worldFromAttached(body.settled(angles), 0);
  if (cell.witness == Witness::trackedPoints) {
    VectorXd result{3 * static_cast<Index>(reading.seen.size())};
    for (std::size_t i = 0; i < reading.seen.size(); ++i) {
      const Vector3d point = hand * cell.points[static_cast<std::size_t>(reading.seen[i])];
      result.segment<3>(3 * static_cast<Index>(i)) = (1 + cell.flaws.trackerScale) * (stand.inverse() * point);
    }
    return result;
  }
  const Transform tool = hand * cell.handFromTool;
  const Transform cameraFromBoard = carriesCamera(cell.witness) ? tool.inverse() * stand : stand.inverse() * tool;
  return pixels(cell, cameraFromBoard, reading.seen);
}

VectorXd placeDistances(const Workcell& cell) {
  VectorXd result{static_cast<Index>(cell.distances.size())};
  for (std::size_t i = 0; i < cell.distances.size(); ++i) {
    const auto [first, second] = cell.distances[i];
    result[static_cast<Index>(i)] =
        (cell.places[static_cast<std::size_t>(first)] - cell.places[static_cast<std::size_t>(second)]).norm();
  }
  return result;
}

} // namespace blind
