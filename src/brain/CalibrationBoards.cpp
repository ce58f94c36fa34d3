#include "brain/CalibrationBoards.hpp"

#include "data/BoardFile.hpp"
#include "io/JsonReader.hpp"

#include <nlohmann/json.hpp>

namespace naocal {

void from_json(const nlohmann::json& json, CalibrationBoards& boards) {
  boards.boards.clear();
  for (const JsonPlace& place : JsonPlace{json, "boards"}.elements()) {
    boards.boards.push_back(readBoard(place));
  }
  requireDistinctMarkers(boards.boards, JsonPlace{json, "boards"});
}

} // namespace naocal
