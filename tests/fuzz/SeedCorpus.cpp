#include "data/CaptureSetFile.hpp"
#include "data/GoodRobotSet.hpp"
#include "data/GoodSet.hpp"
#include "diagnosis/Session.hpp"
#include "dialects/Dialects.hpp"
#include "dialects/HeadExamples.hpp"
#include "dialects/ModelCalibration.hpp"
#include "estimation/ModelBuilder.hpp"
#include "estimation/ModelFile.hpp"
#include "hardware/nao/LolaTwin.hpp"
#include "io/Files.hpp"
#include "io/GreyImage.hpp"
#include "io/JsonReader.hpp"
#include "protocol/Frames.hpp"
#include "simulation/Simulation.hpp"
#include "simulation/StandingPoses.hpp"

#include "recordings/McapWriter.hpp"
#include "recordings/TestArm.hpp"

#include <catch2/catch.hpp>

namespace naocal {
namespace {

using Json = nlohmann::json;

const std::filesystem::path source{NAOCAL_SOURCE_DIR};

void writeSeed(const std::string& reader, const std::string& name, const std::string& content) {
  const auto folder = source / "tests/fuzz/corpus" / reader;
  std::filesystem::create_directories(folder);
  writeAtomically(folder / ("seed-" + name), content);
}

Json readJson(const std::string& file) {
  return parseJson(readFile(source / file), file);
}

CaptureSet smallSet(const Robot& robot) {
  SimulationPlan plan;
  plan.poses = planStandingPoses(robot, plan, SupportFoot::left, 3, 1);
  plan.samples = 1;
  return simulate(robot, plan, 1).set;
}

void writeCaptureSets(CaptureSet set) {
  set.captures.resize(2);
  writeSeed("capture-set", "simulated", formatCaptureSet(set));
  writeSeed("capture-set", "every-feature", goodSet().dump());
  writeSeed("capture-set", "any-robot", goodRobotSet().dump());
}

/// Result, session and calibrations of a set.
void writeAnswers(const CaptureSet& set, const Robot& robot) {
  const std::vector<CaptureSet> sets{set};
  const Measurements measurements = buildMeasurements(sets, robot);
  const Model model = buildModel(measurements, {"elasticity@LKneePitch"});
  const CalibrationResult fit = calibrate(measurements, model);
  const ResultSources inputs{{"captures"}, {std::string(64, '0')}};
  Json document = resultJson({measurements, model, fit}, inputs);
  for (const char* unread : {"sightings", "explanations", "doubtful", "weak"}) {
    document.erase(unread);
  }
  writeSeed("result", "solved", document.dump(1));

  Session session{.ladder = {{.rmsPx = fit.rmsPx}}, .inputs = inputs};
  session.add({"elasticity@LKneePitch"}, [] { return std::vector<std::string>{}; });
  session.current().questioned = SelectionStep{.rmsPx = 0.5, .noiseFloorPx = 0.31};
  session.drop("jointOffset@HeadYaw", [] { return std::vector<std::string>{"jointOffset@HeadYaw"}; });
  writeSeed("session", "three-models", sessionJson(session).dump(1));

  const RobotCalibration calibration = calibrationFromValues(parseResult(document, "result.json").values, set.cameras);
  writeSeed("dialects", "calibration.json", calibrationJson(calibration).dump(1));
  for (const Dialect& dialect : dialects()) {
    for (const DialectFile& file : dialect.write(calibration, robot)) {
      writeSeed("dialects", std::string{dialect.name} + "-" + std::filesystem::path{file.name}.filename().string(),
                file.text);
    }
  }
}

void writeHeads() {
  const char* const names[]{"hulks-k1", "hulks-k1-at-top", "bit-bots", "nubots-nugus", "nubots-k1", "nubots-k1-angles"};
  const std::vector<HeadExample> examples = headExamples();
  for (std::size_t i = 0; i < examples.size(); ++i) {
    writeSeed("heads", names[i], examples[i].text);
  }
}

void writeModels() {
  const Json cable{
      {"name", "kneeCable"},
      {"at", "LKneePitch"},
      {"correction", "a*sin(3*q) + b*abs(tau)"},
      {"unknowns", {{"a", {{"unit", "rad"}, {"sigma", 0.01}}}, {"b", {{"unit", "rad/Nm"}, {"sigma", 0.005}}}}}};
  writeSeed("model", "own-effect",
            modelFileJson({"kneeCable@LKneePitch"}, {"jointOffset@HeadYaw"}, Json::array({cable})).dump(1));
  writeSeed("expression", "sine", "a*sin(3*q) + b*abs(tau)");
  writeSeed("expression", "drivers", "a*(qd + approach*T - t/current) + b*(LHipPitch + tau_LAnklePitch)*(imu_x+com_y)");
  writeSeed("expression", "choice", "q > 0.1 && tau < 2 ? a*min(q, 1, exp(b)) : a^2 - -b*_pi");
}

void writePosesAndDrawings() {
  Json poses = readJson("home/configuration/poses/V6.json");
  poses["poses"].erase(poses["poses"].begin() + 2, poses["poses"].end());
  poses.erase("comparison");
  writeSeed("poses", "two", poses.dump(1));
  std::string angles;
  for (int joint = 0; joint < 26; ++joint) {
    angles += std::to_string(0.01 * joint) + "\n";
  }
  writeSeed("poses", "angles", angles);
  for (const char* model : {"V5", "V6"}) {
    writeSeed("drawing", model, readJson(std::string{"home/configuration/drawings/Nao"} + model + ".json").dump());
  }
}

void writeScenes() {
  writeSeed("scene", "all",
            R"({"format": "naocal-scene", "version": 1, "base": "base_link", "supportLinks": ["foot"],
 "cameras": {"side": {"link": "world", "about": {"x": 1.6, "z": 0.4, "roll": -1.57}, "width": 640, "height": 480, "fx": 600,
  "fy": 600, "cx": 320, "cy": 240, "distortion": [0, 0, 0, 0, 0]}},
 "boards": [{"id": "badge", "link": "hand", "points": [[0, 0, 0], [0.03, 0, 0], [0, 0.03, 0]], "about": {"z": 0.05}}],
 "trackers": {"laser": {"sigma": 0.0002, "about": {"x": 2, "z": 1, "yaw": 3.1}}},
 "markers": [{"id": "ball", "link": "hand", "about": [0.1, 0.05, 0.02]}],
 "frames": [{"id": "tool", "link": "hand", "placement": {"z": 0.1}}], "slipSteps": {"elbow": 0.3},
 "ranges": {"elbow": [0.2, 1.5]}, "noise": {"pixel": 0.3, "encoder": 0.0001, "pose": 0}}
)");
}

void writeConfigurations() {
  writeSeed("configuration", "two-layers",
            "// for all robots\n{\"factor\": 0.5, \"list\": [1, {\"deep\": 2}], \"a.b\": {\"c\": true}}\n----\n"
            "{\"factor\": 0.6 /* of this one */}\n----\n"
            "{\"idmap.nao\": [{\"name\": \"Bob\", \"headid\": \"head\", \"bodyid\": \"body\"}]}\n----\nlist[1].deep");
  const std::string layers = "location/default/";
  writeSeed("configuration", "shipped",
            readFile(source / "home/configuration" / (layers + "head/default/Projection.json")) + "\n----\n{}\n----\n" +
                readFile(source / "home/configuration" / (layers + "id_map.json")) + "\n----\ntop_ext[2]");
}

void writeFrames() {
  writeSeed("debug-frames", "all-requests",
            encodeDebugFrame(DebugType::requestList) + encodeDebugFrame(DebugType::subscribe, "Brain.count") +
                encodeDebugFrame(DebugType::subscribeBulk, R"({"keys": ["Brain.count", "Brain.none"]})") +
                encodeDebugFrame(DebugType::unsubscribe, "Brain.count"));
  writeSeed("debug-frames", "of-a-robot", encodeDebugFrame(DebugType::update, "[]"));
  writeSeed("config-frames", "all-requests",
            encodeConfigFrame(ConfigType::getMounts) + encodeConfigFrame(ConfigType::getKeys, "Brain.Cam") +
                encodeConfigFrame(ConfigType::set, R"([{"mp": "Brain.Cam", "key": "list[1].deep", "value": 3}])") +
                encodeConfigFrame(ConfigType::save));
  writeSeed("config-frames", "extensions",
            encodeConfigFrame(ConfigType::set,
                              R"([{"mp": "naocal.access", "key": "secret", "value": "x"},
{"mp": "naocal.configuration", "key": "lastWill", "value": [{"mp": "Brain.Cam", "key": "factor", "value": 0}]},
{"mp": "naocal.configuration", "key": "undo", "value": "Brain.Cam"}])"));
  writeSeed("lola", "two-states", twin::state(1) + twin::state(2));
  writeSeed("lola", "out-of-step", twin::state(1).substr(1));
}

void writeBrowsers() {
  writeSeed("panel", "all-verbs",
            R"({"do": "stand", "number": 1, "angles": [0, 0.1, 0.2]}
{"do": "stand", "number": 2, "angles": {"HeadYaw": 0.1, "LKneePitch": 0.4}}
{"do": "check", "number": 3, "effect": {"name": "cable", "at": "*", "correction": "a*q", "unknowns": {"a": {"unit": "1", "sigma": 0.1}}}}
{"do": "add", "labels": ["elasticity@LKneePitch"]}
{"do": "goTo", "rung": 0}
{"do": "define", "effect": {"name": "cable"}}
{"do": "drop", "label": "jointOffset@HeadYaw"}
{"do": "propose", "count": 3}
{"do": "make", "file": "result.json"}
{"do": "watch", "robot": "nao21"}
{"do": "subscribe", "robot": "nao21", "key": "Brain.count"}
{"do": "set", "robot": "nao21", "settings": [{"mp": "Brain.Cam", "key": "factor", "value": 1}]}
{"do": "disconnect", "robot": "nao21"}
{"do": "endRun"}
)");
  const std::string effect =
      R"("effect": {"name": "cable", "at": "LKneePitch", "correction": "a*q", "unknowns": {"a": {"unit": "1", "sigma": 0.1}}}})";
  writeSeed("analysis", "effect-of-ones-own", R"({"do": "check", )" + effect + "\n" + R"({"do": "define", )" + effect);
  writeSeed("analysis", "add-and-drop", R"({"do": "add", "labels": ["elasticity@LKneePitch"]}
{"do": "drop", "label": "jointOffset@HeadYaw"})");
  writeSeed("analysis", "back", R"({"do": "drop", "label": "cameraRotation@top"}
{"do": "goTo", "rung": 0})");
  writeSeed("analysis", "file", R"({"do": "goTo", "rung": 0}
{"do": "make", "file": "result.json"})");
  writeSeed("http", "page",
            "GET {path}picture/a%20b?x=1 HTTP/1.1\r\nHost: {host}\r\nSec-Fetch-Site: same-origin\r\n\r\n");
  writeSeed("http", "live",
            std::string{"GET {path}live HTTP/1.1\r\nHost: {host}\r\nOrigin: http://{host}\r\nConnection: Upgrade\r\n"
                        "Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
                        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n"} +
                "\x81\x85\x01\x02\x03\x04\x69\x67\x6f\x68\x6e\x88\x80\x01\x02\x03\x04"); // "hello", masked; close
}

void writePictures() {
  GreyPicture picture{24, 16, {}};
  for (int i = 0; i < 24 * 16; ++i) {
    picture.pixels.push_back(static_cast<std::uint8_t>(i * 7));
  }
  writeSeed("picture", "grey.png", encodePng(picture));
  writeSeed("picture", "grey.jpg", encodeJpeg(picture.pixels, 24, 16, 80));
  writeSeed("picture", "colour.jpg", encodeJpeg(picture.pixels, 8, 16, 50));
}

} // namespace

void writeRecordings() {
  writeSeed("urdf", "arm", testing::armUrdf);
  writeSeed("table", "tracked",
            "t,q1,q2,q3,pose,hand_x_mm,hand_y_mm,hand_z_mm\n10,90,0,0.1,A,1000,0,500\n"
            "11,45,,0.2,\"B, again\",,,\n");
  writeSeed("table", "frames", "q1;q2;q3;x;y;z;qw;qx;qy;qz\n0,1;0;0,1;1;0;0,5;1;0;0;0\n");
  for (const std::string compression : {"none", "zstd", "lz4"}) {
    testing::McapWriter writer{compression};
    const int joints = writer.addChannel("/joint_states", "sensor_msgs/msg/JointState");
    writer.addMessage(joints, 1, testing::jointStateMessage(1, {"shoulder_pan", "slide"}, {0.5, 0.1}));
    writer.endChunk();
    const int images = writer.addChannel("/eye/image_raw", "sensor_msgs/msg/Image");
    writer.addMessage(images, 2, testing::imageMessage(2, "eye", 2, 2, "mono8", 2, {1, 2, 3, 4}));
    writeSeed("mcap", compression, writer.finish());
  }
}

TEST_CASE("the seeds of the corpora are written with the project's own writers", "[.seeds]") {
  // Proves nothing; run it by hand after a format has changed: build/desk/tests/test_fuzz "[.seeds]". Regressions
  // beside the seeds stay.
  const Robot robot = loadRobot(configurationDirectory(), "V6");
  const CaptureSet set = smallSet(robot);
  writeCaptureSets(set);
  writeAnswers(set, robot);
  writeHeads();
  writeModels();
  writePosesAndDrawings();
  writeScenes();
  writeConfigurations();
  writeFrames();
  writeBrowsers();
  writePictures();
  writeRecordings();
  SUCCEED();
}

} // namespace naocal
