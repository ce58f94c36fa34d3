#include "library/naocal.hpp"
#include "recordings/table/ColumnGuess.hpp"
#include "recordings/table/TableImport.hpp"

#include "io/Files.hpp"
#include "math/Angles.hpp"
#include "robot/Kinematics.hpp"

#include "recordings/TestArm.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <random>
#include <sstream>

using namespace naocal;
using namespace naocal::testing;

namespace {

/// A log of the arm whose lift reads `offset` too much [rad]: a tracker that stands anywhere sees a marker on the
/// flange, with 0.3 mm of noise.
std::string logOfArm(const Robot& robot, double offset) {
  std::mt19937 chance{4};
  std::uniform_real_distribution<double> pan{-2, 2}, lift{-1, 1}, slide{0, 0.3};
  std::normal_distribution<double> noise{0, 0.3};
  const Eigen::Isometry3d trackerFromBase =
      Eigen::Translation3d{2, 0.5, -0.3} * Eigen::AngleAxisd{2.1, Eigen::Vector3d{0.36, 0.48, 0.8}};
  const Eigen::Vector3d marker{0.02, 0.03, 0.06};
  std::string log = "Shoulder Pan [deg],Shoulder Lift [deg],slide [mm],hand x [mm],hand y [mm],hand z [mm]\n";
  const auto indexOf = [&](const char* joint) { return static_cast<Eigen::Index>(*robot.jointIndex(joint)); };
  for (int row = 0; row < 60; ++row) {
    Eigen::VectorXd q = Eigen::VectorXd::Zero(4);
    const std::array reading{pan(chance), lift(chance), slide(chance)};
    q[indexOf("shoulder_pan")] = reading[0];
    q[indexOf("shoulder_lift")] = reading[1];
    q[indexOf("slide")] = reading[2];
    const RigidTransform baseFromFlange = forwardKinematics(robot, q)[*robot.linkIndex("flange")];
    const Eigen::Vector3d seen =
        1000 * (trackerFromBase * (baseFromFlange.rotation * marker + baseFromFlange.translation));
    log += fmt::format("{},{},{},{},{},{}\n", degrees(reading[0]), degrees(reading[1] + offset), 1000 * reading[2],
                       seen.x() + noise(chance), seen.y() + noise(chance), seen.z() + noise(chance));
  }
  return log;
}

} // namespace

TEST_CASE("a table of an arm and a tracker tells the zero that is off") {
  // Proves the way from a stranger's table to a calibration: guessed columns and units, a set on disk, the estimate;
  // the table is made with the arm's kinematics, and no file of naocal's.
  const ImportScene scene = armScene();
  const CsvTable table{logOfArm(scene.robot, 0.03), "log.csv"};
  const TableImport import = importTable(table, guessColumns(table, scene.robot).map, scene, ".");
  const TemporaryDirectory folder;
  writeImport(import.imported, folder.path() / "captures");
  const Captures captures =
      readCaptures({folder.path() / "captures"}, std::filesystem::path{NAOCAL_SOURCE_DIR} / "home/configuration");
  const Calibrated calibrated = calibrate(captures);
  const Term* const lift = calibrated.model.find("jointOffset@shoulder_lift");
  REQUIRE(lift != nullptr);
  const Estimate& estimate = calibrated.result.estimates[lift->first];
  CAPTURE(calibrated.result.sentence, estimate.value, estimate.sigma);
  CHECK(calibrated.result.usable);
  CHECK(std::abs(estimate.best() - 0.03) < 4 * estimate.bestSigma());
  CHECK(estimate.bestSigma() < 3e-3);
  const Term* const slide = calibrated.model.find("jointOffset@slide");
  REQUIRE(slide != nullptr);
  CHECK(slide->effect.unknowns.front().unit == "m");
  REQUIRE(calibrated.result.readings.metres.contains("tracker"));
  CHECK(calibrated.result.readings.metres.at("tracker").rms == Approx(0.3e-3 * std::sqrt(3)).epsilon(0.2));
}

TEST_CASE("a table's readings that are none are left out, and named by their rows") {
  // Proves it for positions at exactly 0, 0, 0, for empty cells, and for a value that stood still while the arm moved;
  // the rows are counted as a spreadsheet does.
  const ImportScene scene = armScene();
  std::vector<std::string> lines;
  std::istringstream log{logOfArm(scene.robot, 0)};
  for (std::string line; std::getline(log, line);) {
    lines.push_back(line);
  }
  const auto position = [&](std::size_t line) {
    std::size_t at = lines[line].size();
    for (int i = 0; i < 3; ++i) {
      at = lines[line].rfind(',', at - 1);
    }
    return at;
  };
  const auto set = [&](std::size_t row, const std::string& xyz) {
    lines[row - 1].replace(position(row - 1), 999, xyz);
  };
  set(7, ",0,0,0");
  set(25, ",0.000,0.000,-0.0");
  set(30, ",,nan,");
  set(41, lines[39].substr(position(39)));
  const CsvTable table{fmt::format("{}\n", fmt::join(lines, "\n")), "log.csv"};
  const TableImport import = importTable(table, guessColumns(table, scene.robot).map, scene, ".");
  CHECK(import.imported.set.captures.size() == 56);
  const std::vector<std::string> told = summarize(import);
  REQUIRE(told.size() == 6);
  CHECK(told[2].starts_with("marker hand was taken to be on link "));
  CHECK(told[3].starts_with("no column gives the time"));
  CHECK(told[1] == "1 rows passed over: no picture, no measured position (row 30)");
  CHECK(told[4].starts_with("2 of 59 readings of hand by tracker are exactly 0, 0, 0"));
  CHECK(told[4].ends_with("left out: rows 7, 25"));
  CHECK(told[5].ends_with("left out: row 41"));
}
