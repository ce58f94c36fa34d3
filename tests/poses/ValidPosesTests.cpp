#include "PlainRobot.hpp"
#include "QuickPlan.hpp"
#include "poses/PoseFile.hpp"
#include "poses/criteria/PlanOptions.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace naocal;

namespace {

plain::Json fileOf(const PlanOptions& options) {
  return plain::Json::parse(planJson(quickPlan(options), v6()).dump());
}

/// POSES.json of small plans: for both legs in turn, and on both feet.
const plain::Json& inTurn() {
  static const plain::Json file = [] {
    PlanOptions options = quickOptions(8);
    options.mirrored = true;
    return fileOf(options);
  }();
  return file;
}
const plain::Json& onBoth() {
  static const plain::Json file = fileOf(quickOptions(8, SupportFoot::both));
  return file;
}

plain::Angles anglesOf(const plain::Json& joints) {
  plain::Angles angles;
  for (const auto& [name, angle] : joints.items()) {
    angles[name] = angle.get<double>();
  }
  return angles;
}

/// Adds an error of up to 6.5 degrees to every motor; one motor drives both hip yaw-pitch joints.
plain::Angles withErrors(plain::Angles angles, std::mt19937& random) {
  std::uniform_real_distribution<double> error{-6.5 * plain::degree, 6.5 * plain::degree};
  for (auto& [name, angle] : angles) {
    angle += name == "RHipYawPitch" ? 0 : error(random);
  }
  angles["RHipYawPitch"] = angles["LHipYawPitch"];
  return angles;
}

/// Number of inner corners of an A2 board (7 x 5 squares of 80 mm) in the image of a camera of 640 x 480 px.
int cornersInPicture(const plain::Json& robot, const plain::Json& pose, const plain::Json& board,
                     const std::string& camera) {
  const auto links = plain::posture(robot, anglesOf(pose["joints"]));
  const plain::Json& mount = robot["cameras"][camera];
  Eigen::Isometry3d torsoFromCamera = links.at(mount["link"].get<std::string>());
  torsoFromCamera.translate(plain::metres(mount["originMillimetres"]));
  torsoFromCamera.rotate(
      Eigen::AngleAxisd{mount["pitchDegrees"].get<double>() * plain::degree, Eigen::Vector3d::UnitY()});
  const std::string side = pose["supportFoot"] == "right" ? "right" : "left";
  const Eigen::Isometry3d cameraFromSole =
      torsoFromCamera.inverse() * links.at(robot["soles"][side]["link"].get<std::string>());
  const plain::Json& place = board["placement"];
  const double yaw = place["yaw"].get<double>(), y = place["y"].get<double>() + (side == "right" ? 0.1 : 0);
  int count = 0;
  for (int i = 0; i < 24; ++i) {
    const double along = 0.08 * (i % 6 + 1), across = -0.08 * (i / 6 + 1);
    const Eigen::Vector3d p =
        cameraFromSole * Eigen::Vector3d{place["x"].get<double>() + std::cos(yaw) * along - std::sin(yaw) * across,
                                         y + std::sin(yaw) * along + std::cos(yaw) * across, 0};
    const double u = 319.5 - 598 * p.y() / p.x(), v = 239.5 - 598 * p.z() / p.x();
    count += p.x() > 0 && u > 5 && u < 634 && v > 5 && v < 474 ? 1 : 0;
  }
  return count;
}

} // namespace

TEST_CASE("every pose that is written keeps to the limits, stands on its feet despite errors, and sees its boards",
          "[slow]") {
  // Proves it for plans of both legs in turn and on both feet, with kinematics, masses and pinhole model reimplemented
  // from the drawing: only the file is taken from the generator. On both feet the right sole is flat, 10 cm beside the
  // left one, in every pose. Collisions are tested in CollisionLibraryTests.
  const plain::Json robot = plain::drawing("V6");
  std::mt19937 random{1};
  REQUIRE(inTurn()["poses"].size() == 16);
  REQUIRE(onBoth()["poses"].size() == 8);
  CHECK(inTurn()["support"] == "both");
  const bool both = GENERATE(false, true);
  const plain::Json& file = both ? onBoth() : inTurn();
  for (const plain::Json& pose : file["poses"]) {
    const plain::Angles angles = anglesOf(pose["joints"]);
    const std::string side = pose["supportFoot"].get<std::string>();
    CAPTURE(pose["id"].get<std::string>());
    CHECK(angles.at("LHipYawPitch") == angles.at("RHipYawPitch"));
    CHECK(plain::withinLimits(robot, angles, 6.5 * plain::degree));
    CHECK(plain::stands(robot, side, angles));
    if (both) {
      CHECK(side == "both");
      const auto there = plain::rightSole(robot, angles), drawn = plain::outline(robot, "right");
      for (std::size_t i = 0; i < there.size(); ++i) {
        CHECK((there[i] - drawn[i] - Eigen::Vector3d{0, -0.1, 0}).norm() < 1e-6);
      }
    }
    int standing = 0;
    for (int draw = 0; draw < 500; ++draw) {
      standing += plain::stands(robot, side, withErrors(angles, random)) ? 1 : 0;
    }
    CHECK(standing >= 485); // 99 % required by the generator, on 200 other draws
    REQUIRE_FALSE(pose["observes"].empty());
    for (const plain::Json& board : file["boards"]) {
      const auto& observed = pose["observes"];
      if (std::find(observed.begin(), observed.end(), board["id"]) != observed.end()) {
        CHECK(std::max(cornersInPicture(robot, pose, board, "top"), cornersInPicture(robot, pose, board, "bottom")) >=
              8);
      }
    }
  }
}

TEST_CASE("no robot as drawn falls on its way between neighbours of a plan, and few with joint errors do", "[slow]") {
  // Proves it at 1000 random times on the plans' paths, with the same plain robot: joints move proportionally between
  // stops. The plan requires 97 % of robots with errors; three sigmas of 1000 draws below that are accepted. On both
  // feet the right sole moves by at most 3 mm.
  const plain::Json robot = plain::drawing("V6");
  std::mt19937 random{2};
  const plain::Json& all = (GENERATE(false, true) ? onBoth() : inTurn())["poses"];
  int standing = 0;
  for (int draw = 0; draw < 1000;) {
    const std::size_t i = std::uniform_int_distribution<std::size_t>{1, all.size() - 1}(random);
    if (!all[i].contains("secondsToReach")) {
      continue; // the first pose on the other foot, or one without a safe path
    }
    std::vector<plain::Angles> stops{anglesOf(all[i - 1]["joints"])};
    for (const plain::Json& via : all[i].value("via", plain::Json::array())) {
      stops.push_back(anglesOf(via));
    }
    stops.push_back(anglesOf(all[i]["joints"]));
    const std::size_t leg = std::uniform_int_distribution<std::size_t>{1, stops.size() - 1}(random);
    const double share = std::uniform_real_distribution{0.0, 1.0}(random);
    plain::Angles between;
    for (const auto& [name, angle] : stops[leg - 1]) {
      between[name] = angle + share * (stops[leg].at(name) - angle);
    }
    const std::string side = all[i]["supportFoot"].get<std::string>();
    CHECK(plain::stands(robot, side, between));
    if (side == "both") {
      const auto there = plain::rightSole(robot, between), before = plain::rightSole(robot, stops.front());
      for (std::size_t corner = 0; corner < there.size(); ++corner) {
        CHECK((there[corner] - before[corner]).norm() <= 0.0031); // slightly more between the planner's steps
      }
    }
    standing += plain::stands(robot, side, withErrors(between, random)) ? 1 : 0;
    ++draw;
  }
  CHECK(standing >= 954);
}
