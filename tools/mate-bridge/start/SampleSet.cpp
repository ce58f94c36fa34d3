#include "start/SampleSet.hpp"

#include "io/InputError.hpp"
#include "io/Programs.hpp"
#include "protocol/BoundedJson.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace naocal {

namespace {

using Json = nlohmann::json;

constexpr std::uintmax_t largestTruth = 1 << 20; // [bytes]

} // namespace

SampleSet::SampleSet(boost::asio::io_context& context, std::function<void(const std::string& folder)> made,
                     std::function<void()> changed)
    : made_{std::move(made)}, changed_{std::move(changed)}, child_{context, "naocal", findProgram("naocal"),
                                                                   [this] { onChanged(); }} {}

std::filesystem::path SampleSet::set() const {
  return folder_->path() / "sample";
}

void SampleSet::make() {
  if (isMade_) {
    made_(set().string());
  } else if (!child_.isRunning()) {
    folder_ = std::make_unique<TemporaryDirectory>();
    child_.start({"simulate", set().string(), "--hidden-flaw", "--poses", "12", "--samples", "2", "--repeat-kind",
                  "reapproach", "--images", "--seed", "7"});
  }
}

void SampleSet::onChanged() {
  const bool isNew = !isMade_ && !child_.isRunning() && child_.exitCode() == 0;
  isMade_ = isMade_ || isNew;
  changed_();
  if (isNew) {
    made_(set().string());
  }
}

Json SampleSet::state() const {
  const std::string failure = child_.failure();
  const char* const state = isMade_ ? "made" : child_.isRunning() ? "making" : failure.empty() ? "none" : "failed";
  return {{"state", state}, {"sentence", failure}};
}

std::string SampleSet::truth() const {
  if (!isMade_) {
    throw InputError{"expected the sample set, whose truth is known; found none: open it first"};
  }
  const std::string file = set().string() + ".truth.json";
  const Json truth = parseBoundedJson(readFile(file, largestTruth)), hidden = truth.at("effects").back();
  return fmt::format("{}@{}", hidden.at("effect").get<std::string>(), hidden.at("at").get<std::string>());
}

} // namespace naocal
