#include "dialects/SavedCalibration.hpp"

#include "TemporaryFolder.hpp"
#include "io/Files.hpp"
#include "math/Angles.hpp"
#include "robot/Robot.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// A laptop's copy of a robot's state folder, over the shipped configuration.
struct Laptop {
  Configuration open() const {
    return Configuration{{configurationDirectory(), folder.path()}, {"", "Ada", "Bob"}, writeAtomically};
  }
  nlohmann::json read(const std::string& file) const {
    const auto content = readConfiguration(folder.path() / "location/default" / file);
    return content ? *content : nlohmann::json{};
  }

  TemporaryFolder folder;
};

const std::string offsetsFile = "body/Bob/JointCalibrationProvider.json", camerasFile = "head/Ada/Projection.json";

StoredResult topTurned(double roll) {
  StoredResult mounts;
  mounts.terms = {"cameraRotation@top"};
  mounts.values = {{"cameraRotation@top.rx", roll}, {"cameraRotation@top.ry", 0.02}, {"cameraRotation@top.rz", 0.03}};
  return mounts;
}

} // namespace

TEST_CASE("a calibration is applied on a laptop and taken back as on the robot") {
  // Proves files, units and both hip yaw-pitches; that a second save leaves the first as the state to go back to; and
  // that undo restores both files, in a new process.
  const Laptop laptop;
  {
    Configuration configuration = laptop.open();
    mountCalibration(configuration);
    applyCalibration({{"LHipYawPitch", radians(3.0), 0, 1}}, topTurned(0.01), configuration);
    saveCalibration(configuration);
    applyCalibration({{"LHipYawPitch", radians(4.0), 0, 1}}, topTurned(0.05), configuration);
    saveCalibration(configuration);
  }
  CHECK(laptop.read(offsetsFile)["rHipYawPitch"].get<double>() == Approx(4.0));
  CHECK(laptop.read(offsetsFile).size() == 2);
  CHECK(laptop.read(camerasFile)["top_ext"] == nlohmann::json{0.05, 0.02, 0.03});
  CHECK_FALSE(laptop.read(camerasFile).contains("bottom_ext"));
  Configuration configuration = laptop.open();
  mountCalibration(configuration);
  undoCalibration(configuration);
  CHECK(laptop.read(offsetsFile)["lHipYawPitch"].get<double>() == Approx(3.0));
  CHECK(laptop.read(camerasFile)["top_ext"] == nlohmann::json{0.01, 0.02, 0.03});
  CHECK_THROWS_AS(undoCalibration(configuration), ConfigurationError); // one step back
}

TEST_CASE("an offset that no robot has is refused as a whole") {
  // Proves that after the refusal no value is set, not even those before it, and nothing is written.
  const Laptop laptop;
  Configuration configuration = laptop.open();
  mountCalibration(configuration);
  const std::string before = snapshotCalibration(configuration);
  CHECK_THROWS_WITH(applyCalibration({{"HeadYaw", radians(1.0), 0, 1}, {"LKneePitch", radians(31.0), 0, 1}},
                                     topTurned(0.01), configuration),
                    Catch::Contains("lKneePitch: expected an offset from -30 to 30 degrees"));
  CHECK(snapshotCalibration(configuration) == before);
  CHECK(laptop.read(offsetsFile).is_null());
}

TEST_CASE("a lens is set as shares of the picture") {
  // Proves both keys of the camera, and that the other camera keeps its lens.
  const Laptop laptop;
  Configuration configuration = laptop.open();
  mountCalibration(configuration);
  applyLens("top", CameraIntrinsics{640, 480, 608, 600, 320, 246, {}}, configuration);
  saveCalibration(configuration);
  CHECK(laptop.read(camerasFile) == nlohmann::json{{"top_fc", {0.95, 1.25}}, {"top_cc", {0.5, 0.5125}}});
}

} // namespace naocal
