#include "commands/Commands.hpp"
#include "console/print/PrintText.hpp"

#include "command-line/OptionChecks.hpp"
#include "io/Files.hpp"
#include "recordings/mcap/McapImport.hpp"
#include "recordings/table/ColumnGuess.hpp"
#include "recordings/table/TableImport.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

namespace naocal {

namespace {

/// Options that both kinds of recordings need.
struct SceneOptions {
  SceneSources sources;
  std::string output;
};

struct TableCommand {
  SceneOptions scene;
  std::string table, columns, pictures;
};

struct McapCommand {
  SceneOptions scene;
  std::string file;
  McapTopics topics;
  RestOptions rests;
};

void printNext(const ImportedSet& imported, const std::string& folder) {
  const bool hasPictures = !imported.set.cameras.empty();
  printText("written to {}; next: {} {}\n", folder, hasPictures ? "naocal detect" : "naocal diagnose", folder);
}

void importTableCommand(const TableCommand& command) {
  const ImportScene scene = readImportScene(command.scene.sources);
  const CsvTable table{readFile(command.table), command.table};
  ColumnMap map;
  if (command.columns.empty()) {
    const ColumnGuess guess = guessColumns(table, scene.robot);
    map = guess.map;
    printText(
        "columns as guessed; where they are wrong, save these lines as columns.json, correct them and import again "
        "with --columns columns.json:\n{}\n",
        columnMapJson(map).dump(2));
    if (!guess.unused.empty()) {
      printText("not used: {}\n", fmt::format("{}", fmt::join(guess.unused, ", ")));
    }
  } else {
    map = parseColumnMap(parseJson(readFile(command.columns), command.columns), command.columns, scene.robot);
  }
  const auto beside = std::filesystem::absolute(command.table).parent_path();
  const TableImport result =
      importTable(table, map, scene, command.pictures.empty() ? beside : std::filesystem::path{command.pictures});
  writeImport(result.imported, command.scene.output);
  for (const std::string& line : summarize(result)) {
    printText("{}\n", line);
  }
  printNext(result.imported, command.scene.output);
}

void importMcapCommand(const McapCommand& command) {
  const ImportScene scene = readImportScene(command.scene.sources);
  requireBoards(scene);
  const McapImport result = importMcap(command.file, scene, command.topics, command.rests);
  writeImport(result.imported, command.scene.output);
  printText("{} pictures, {} while all joints rested, in {} poses\n", result.pictures, result.rests, result.poses);
  printNext(result.imported, command.scene.output);
}

void addSceneOptions(CLI::App& app, SceneOptions& options) {
  app.add_option("--robot", options.sources.robot, "the robot's URDF")
      ->type_name("URDF")
      ->required()
      ->check(existingFile());
  app.add_option("--boards", options.sources.boards, "file with the boards in the pictures")
      ->type_name("FILE")
      ->check(existingFile());
  app.add_option("--board-link", options.sources.boardLink, "link that carries the boards, \"world\" or \"floor\"")
      ->type_name("LINK")
      ->capture_default_str();
  app.add_option("--camera", options.sources.camera, "the camera's name in the set")
      ->type_name("NAME")
      ->capture_default_str();
  app.add_option("--camera-model", options.sources.cameraModel,
                 "the camera's lens, as OpenCV, ROS, kalibr or mrcal has calibrated it")
      ->type_name("FILE")
      ->check(existingFile());
  app.add_option("--camera-link", options.sources.cameraLink,
                 "link with the camera's axes (x right, y down, z forward), or \"world\": it stands beside the robot")
      ->type_name("LINK");
  app.add_option("-o,--output", options.output, "write the set into this folder")->type_name("SET")->required();
}

void addTableImport(CLI::App& importer) {
  auto command = std::make_shared<TableCommand>();
  CLI::App* app =
      importer.add_subcommand("csv", "a table of joint angles, with names of pictures or measured positions");
  app->footer("Example: naocal import csv log.csv --robot arm.urdf --boards boards.json --camera-model lens.yaml "
              "--camera-link wrist_camera_optical -o captures");
  app->add_option("TABLE", command->table, "table with a row of names above one row per reading")
      ->type_name("TABLE.csv")
      ->required()
      ->check(existingFile());
  app->add_option("--columns", command->columns,
                  "file that says what the columns are; otherwise guessed, shown and saved")
      ->type_name("COLUMNS.json")
      ->check(existingFile());
  app->add_option("--pictures", command->pictures, "folder of the pictures that the table names; otherwise the table's")
      ->type_name("FOLDER")
      ->check(existingFolder());
  addSceneOptions(*app, command->scene);
  app->callback([command] { importTableCommand(*command); });
}

void addMcapImport(CLI::App& importer) {
  auto command = std::make_shared<McapCommand>();
  CLI::App* app = importer.add_subcommand("mcap", "a recording of ROS 2: joint states and pictures");
  app->footer("Example: naocal import mcap ride.mcap --robot arm.urdf --images /wrist/image_raw --boards boards.json "
              "-o captures");
  app->add_option("FILE", command->file, "recording")->type_name("FILE.mcap")->required()->check(existingFile());
  app->add_option("--joints", command->topics.joints, "topic of sensor_msgs/msg/JointState")
      ->type_name("TOPIC")
      ->capture_default_str();
  app->add_option("--images", command->topics.images, "topic of sensor_msgs/msg/Image or CompressedImage")
      ->type_name("TOPIC")
      ->required();
  app->add_option("--camera-info", command->topics.cameraInfo,
                  "topic of sensor_msgs/msg/CameraInfo; otherwise camera_info beside the pictures")
      ->type_name("TOPIC");
  app->add_option("--rest", command->rests.mostTravel,
                  "a joint rests while its readings differ by at most this [rad], [m]")
      ->type_name("TRAVEL")
      ->capture_default_str()
      ->check(number(1e-6, 1));
  addSceneOptions(*app, command->scene);
  app->callback([command] { importMcapCommand(*command); });
}

} // namespace

void addRecordingImports(CLI::App& importer) {
  addTableImport(importer);
  addMcapImport(importer);
}

} // namespace naocal
