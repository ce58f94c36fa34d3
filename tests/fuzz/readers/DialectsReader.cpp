#include "dialects/Dialects.hpp"
#include "fuzz/driver/Reader.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"

#include <nlohmann/json.hpp>

namespace naocal {
namespace {

/// The input as a file of every dialect, and as CALIBRATION.json; what is accepted is written. Refused if all refuse
/// it.
void readAsDialects(std::string_view bytes) {
  static const Robot robot = loadRobot(configurationDirectory(), "V6");
  const std::string text{bytes};
  bool isRead = false;
  for (const Dialect& dialect : dialects()) {
    try {
      const ParsedCalibration parsed = dialect.parse(text, "top.cfg", robot);
      calibrationJson(parsed.calibration);
      dialect.write(parsed.calibration, robot);
      isRead = true;
    } catch (const InputError&) { // refused; another dialect may read it
    }
  }
  try {
    parseCalibration(parseJson(text, "calibration.json"), "calibration.json");
  } catch (const InputError&) {
    if (!isRead) {
      throw;
    }
  }
}

const Reader dialectsReader{"dialects", readAsDialects};

} // namespace
} // namespace naocal
