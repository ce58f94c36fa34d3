#include "RobotV6.hpp"
#include "TemporaryFolder.hpp"
#include "evaluation/Proportion.hpp"
#include "evaluation/thesis/ThesisFiles.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"

#include <catch2/catch.hpp>

namespace naocal {

using Catch::Matchers::Contains;

namespace {

/// A file with this text, and the columns that are read from it.
struct Table {
  TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "table.csv";
  JointColumns columns{v6(), programJoints(), 0.5};

  explicit Table(const std::string& text) { writeAtomically(file, text); }
};

/// 26 zeros, apart from the first two and the ninth.
std::string programLine() {
  return "-0.1 -0.02 0 0 0 0 0 0 0.05 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0";
}

const std::string jointHeads = "HeadYaw,HeadPitch,LHipYawPitch,LHipRoll,LHipPitch,LKneePitch,LAnklePitch,LAnkleRoll";

} // namespace

TEST_CASE("error sets, poses and features are read as they were written") {
  // Proves it to nine digits, for three error sets and for the thesis's poses and features.
  const std::vector<std::string> names = programJoints();
  std::vector<Eigen::VectorXd> sets;
  for (std::size_t set = 0; set < 3; ++set) {
    sets.push_back(drawProgramSet(names, 1, set));
  }
  const Table errors{formatJointTable(errorsKind, names, sets)};
  const std::vector<Eigen::VectorXd> read = readErrorSets(errors.file, errors.columns);
  REQUIRE(read.size() == 3);
  for (std::size_t set = 0; set < 3; ++set) {
    CHECK((read[set] - sets[set]).norm() < 1e-8);
  }
  Table poses{formatJointTable(posesKind, names, programPoses(names))};
  poses.columns.range = 3.2;
  CHECK((readPoses(poses.file, poses.columns).at(9) - programPoses(names)[9]).norm() < 1e-8);
  const Table features{formatFeatures({programGrid(), {10, 14, 0.05, 0.5, -0.25, 0.1}})};
  const std::vector<FloorPattern> patterns = readFeatures(features.file);
  REQUIRE(patterns.size() == 2);
  CHECK(patterns[0].columns == 40);
  CHECK(patterns[1].rows == 14);
  CHECK(patterns[1].y == -0.25);
  CHECK(patterns[1].yaw == 0.1);
}

TEST_CASE("columns may come in any order, with those of other joints between") {
  // Proves that columns are found by name.
  const Table table{"LAnkleRoll,LAnklePitch,LKneePitch,LHipPitch,LHipRoll,LHipYawPitch,HeadPitch,RHipRoll,HeadYaw\n"
                    "0.8,0.7,0.6,0.5,0.4,0.3,0.2,9,0.1\n"};
  JointColumns columns = table.columns;
  columns.range = 1;
  const Eigen::VectorXd row = readErrorSets(table.file, columns).at(0);
  for (Eigen::Index i = 0; i < row.size(); ++i) {
    CHECK(row[i] == Approx(0.1 * static_cast<double>(i + 1)));
  }
}

TEST_CASE("files of the thesis's own program are read as well") {
  // Proves the order of its joints, that its errors have the opposite sign, and its features' units.
  const Table errors{programLine() + " \n" + programLine() + "\n"};
  const Eigen::VectorXd row = readErrorSets(errors.file, errors.columns).at(1);
  CHECK(row[0] == 0.1);
  CHECK(row[1] == 0.02);
  CHECK(row[2] == -0.05);
  Table poses{"NaoPoseAndRawAngles NaoPoseV2 42 1 53.7 -10 1.5 -0.05 0 0.31 -10 0 -5 0.02 -0.11 0.1 0 0 0 " +
              programLine() + "\n"};
  CHECK(readPoses(poses.file, poses.columns).at(0)[0] == -0.1);
  const Table features{"GroundGrid 40 0.05 0 0 0\nChessBoardPatternOnFloor 10 14 0.05 1.5 -0.6 90\n"};
  CHECK(readFeatures(features.file).at(0).rows == 40);
  CHECK(readFeatures(features.file).at(1).yaw == Approx(radians(90)));
}

TEST_CASE("bad files are refused with line, expectation and finding") {
  // Proves the sentence for every kind of mistake.
  const auto refusal = [](const std::string& text) {
    const Table table{text};
    try {
      readErrorSets(table.file, table.columns);
    } catch (const InputError& error) {
      return std::string{error.what()};
    }
    return std::string{};
  };
  CHECK_THAT(refusal(""), Contains("expected rows of numbers, found none"));
  CHECK_THAT(refusal("# only a comment\n"), Contains("expected rows of numbers, found none"));
  CHECK_THAT(refusal(jointHeads + "\n"), Contains("line 1: expected rows below the names of the joints, found none"));
  CHECK_THAT(refusal("HeadYaw,Tail\n1,2\n"), Contains("line 1: expected names of joints, such as HeadYaw"));
  CHECK_THAT(refusal("HeadYaw,HeadYaw\n1,2\n"), Contains("every joint once, found HeadYaw twice"));
  CHECK_THAT(refusal("HeadYaw,HeadPitch\n0,0\n"), Contains("expected a column LHipYawPitch, found none"));
  CHECK_THAT(refusal(jointHeads + "\n0,0,0\n"), Contains("line 2: expected 8 columns, found 3"));
  CHECK_THAT(refusal(jointHeads + "\n0,0,0,0,0,0,0,six\n"), Contains("column 8, found six"));
  CHECK_THAT(refusal(jointHeads + "\n0,0,0,0,0,0,0,\n"), Contains("column 8, found nothing"));
  CHECK_THAT(refusal(jointHeads + "\n0,0,0,0,0,0,0,nan\n"), Contains("column 8, found nan"));
  CHECK_THAT(refusal(jointHeads + "\n0,0,0,0,0,0,0,6.5\n"), Contains("a number between -0.5 and 0.5"));
  CHECK_THAT(refusal("0 1 2\n"), Contains("expected 26 columns, found 3"));
  for (const char* text : {"columns,rows,spacing,x,y,yaw\n", "columns,rows,spacing,x,y,yaw\n4,4.5,0.1,0,0,0\n",
                           "columns,rows,spacing,x,y,yaw\n4,4,0,0,0,0\n", "Circle 1 2 3\n", "GroundGrid 4 0.05\n",
                           "columns,rows,spacing,x,y,yaw\n300,300,0.1,0,0,0\n300,300,0.1,0,0,0\n"}) {
    CHECK_THROWS_AS(readFeatures(Table{text}.file), InputError);
  }
  const Table right{"NaoPoseAndRawAngles NaoPoseV2 42 -1 53.7 -10 1.5 -0.05 0 0.31 -10 0 -5 0.02 -0.11 0.1 0 0 0 " +
                    programLine() + "\n"};
  CHECK_THROWS_WITH(readPoses(right.file, right.columns), Contains("the left support foot"));
}

TEST_CASE("rows have a status, errors, and residual and injected offsets") {
  // Proves order and content for two solvers, one of which failed.
  ThesisSetting setting{.feature = ThesisFeature::programGrid, .poses = 4, .noise = ThesisNoise::joint};
  setting.jointNoise = AngleNoise::unrounded;
  ThesisSolution good{.solved = true, .rms = 0.25, .rmsTolerance = 1, .errors = Eigen::Vector2d{0.001, 0}};
  good.heldOut = HeldOutError{.mean = 0.5, .norm = 1, .normAtZero = 2, .points = 4};
  const Eigen::Vector2d offsets{0.05, -0.1};
  const std::string text =
      formatRows({{setting, 7, ThesisSolver::program, {}, offsets}, {setting, 3, ThesisSolver::ours, good, offsets}},
                 {"HeadYaw", "HeadPitch"}, radians(0.2));
  CHECK(text == std::string{rowsKind} +
                    "\nfeature,poses,noise,jointNoise,samples,solver,set,status,calibrationRmsPx,testErrorPx,residual "
                    "HeadYaw,residual HeadPitch,injected HeadYaw,injected HeadPitch\n"
                    "program-grid,4,joint,0.007deg-unrounded,1,ours,3,success,0.25,0.5,0.001,0,0.05,-0.1\n"
                    "program-grid,4,joint,0.007deg-unrounded,1,lm-program,7,solverFailure,,,,,0.05,-0.1\n");
}

TEST_CASE("a proportion has Wilson's interval") {
  // Proves it for two published examples and no trials.
  CHECK(proportion(8, 10).low == Approx(0.4901625).margin(1e-6));
  CHECK(proportion(8, 10).high == Approx(0.9433178).margin(1e-6));
  CHECK(proportion(229, 229).low == Approx(0.9835).margin(1e-4));
  CHECK(proportion(229, 229).high == 1);
  CHECK(proportion(0, 0).high == 1);
}

TEST_CASE("a map of residuals adds up by squares of the floor") {
  // Proves that points are counted in the nearest square, that maps add up, and that far points are ignored.
  ResidualMap one, other;
  one.add(Eigen::Vector2d{0.51, -0.24}, 2);
  one.add(Eigen::Vector2d{9, 0}, 2);
  other.add(Eigen::Vector2d{0.49, -0.26}, 4);
  other.add(Eigen::Vector2d{-0.5, 0}, 1);
  one.add(other);
  const std::vector<ResidualMap::Square> squares = one.squares();
  REQUIRE(squares.size() == 2);
  CHECK(squares[0].x == -10);
  CHECK(squares[1].x == 10);
  CHECK(squares[1].y == -5);
  CHECK(squares[1].count == 2);
  CHECK(squares[1].sum == 6);
}

} // namespace naocal
