#include "data/CaptureSetFile.hpp"
#include "fuzz/driver/Reader.hpp"

#include <stdexcept>

namespace naocal {
namespace {

/// A capture set, with all three readers of its text. What is accepted is written and read again.
void readCaptureSetText(std::string_view bytes) {
  const std::string text{bytes};
  const SurveyedCaptureSet survey = surveyCaptureSet(text, "captures.json");
  const CaptureSet set = parseCaptureSet(text, "captures.json", BadCapturePolicy::skip).set;
  const std::string written = formatCaptureSet(set);
  if (formatCaptureSet(parseCaptureSet(written, "written").set) != written) {
    throw std::logic_error{"a set that was written and read is another one"};
  }
  parseCaptureSet(text, "captures.json");
  if (!survey.refusals.empty()) {
    throw std::logic_error{"a set is accepted, and has refusals: " + survey.refusals.front()};
  }
}

const Reader captureSetReader{"capture-set", readCaptureSetText};

} // namespace
} // namespace naocal
