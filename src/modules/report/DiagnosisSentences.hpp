#pragma once

#include "io/JsonReader.hpp"
#include "report/Sentences.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// The verdicts that a diagnosis can have, and what it can say of a candidate, as its file writes them.
const std::vector<std::string_view>& verdicts();
const std::vector<std::string_view>& candidateStates();

/// The verdict in a few plain words.
std::string verdictHeadline(const JsonPlace& diagnosis);

/// What makes the floor under the errors: noise, and the scatter of joints where the last model needs some.
std::string floorName(const JsonPlace& diagnosis);

/// What the verdict rests on: the error on poses not seen, the alarm, the lack of fit, scatter.
std::vector<Fact> diagnosisFacts(const JsonPlace& diagnosis);

} // namespace naocal
