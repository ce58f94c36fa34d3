#include "writer/Writing.hpp"
#include "writer/machines/WorkcellWriting.hpp"

#include <CLI/CLI.hpp>
#include <exception>
#include <fmt/core.h>

int main(int argc, char** argv) {
  CLI::App app{"blind-writer: writes capture sets of robots with hidden flaws, and seals what it hid.", "blind-writer"};
  app.footer("Example: blind-writer /tmp/blind --seed 1 --first 0 --count 10");
  std::string out, drawingFile = BLIND_DRAWING;
  std::uint64_t seed = 1;
  int first = 0, count = -1;
  bool onlySize = false, robots = false;
  blind::DesignCounts counts;
  app.add_option("OUT", out, "the folder to write into: sets, locked, truth, manifest")->required();
  app.add_option("--seed", seed, "another benchmark for every seed")->capture_default_str();
  app.add_option("--controls", counts.controls, "sets without effect, per noise regime")->capture_default_str();
  app.add_option("--sets", counts.sets, "sets per effect and size, per case otherwise")->capture_default_str();
  app.add_option("--pictures", counts.pictureShare, "share of sets that are rendered")->check(CLI::Range(0.0, 0.9));
  app.add_option(
      "--only", counts.only,
      "one group: control, decoy, catalogue, pair, outside, absorbed, corrupted, sized, camera, twin, event, jitter; "
      "with --robot: control, catalogue, setup, event, reading");
  app.add_option("--first", first, "number of the first set to write")->capture_default_str();
  app.add_option("--count", count, "how many sets to write; -1: all that follow")->capture_default_str();
  app.add_option("--drawing", drawingFile, "the robot's drawing")->capture_default_str();
  app.add_flag("--robot", robots, "robots with a URDF instead of NAOs");
  app.add_flag("--size", onlySize, "only print how many sets there are");
  CLI11_PARSE(app, argc, argv);
  try {
    const std::vector<blind::DesignItem> items =
        robots ? std::vector<blind::DesignItem>{} : blind::drawDesign(counts, seed);
    const std::vector<blind::WorkcellItem> cells =
        robots ? blind::drawWorkcellDesign(counts.controls, counts.sets, counts.only, seed)
               : std::vector<blind::WorkcellItem>{};
    const int size = static_cast<int>(items.size() + cells.size());
    if (onlySize) {
      fmt::print("{}\n", size);
      return 0;
    }
    const int end = count < 0 ? size : std::min(size, first + count);
    if (robots) {
      for (int number = first; number < end; ++number) {
        blind::writeWorkcellItem(cells[static_cast<std::size_t>(number)], seed, number, out);
      }
      return 0;
    }
    const blind::Drawing drawing = blind::parseRobot(drawingFile);
    for (int number = first; number < end; ++number) {
      blind::writeItem(drawing, items[static_cast<std::size_t>(number)], seed, number, out);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "blind-writer: {}\n", error.what());
    return 2;
  }
  return 0;
}
