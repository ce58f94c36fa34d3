#include "calibration/result/ResultFile.hpp"
#include "fuzz/driver/Reader.hpp"
#include "io/JsonReader.hpp"

#include <nlohmann/json.hpp>

namespace naocal {
namespace {

void readResultText(std::string_view bytes) {
  parseResult(parseJson(std::string{bytes}, "result.json"), "result.json");
}

const Reader resultReader{"result", readResultText};

} // namespace
} // namespace naocal
