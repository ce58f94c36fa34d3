#include "detect/SetDetection.hpp"

#include "captures/InputError.hpp"
#include "captures/PictureFile.hpp"

#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <mutex>
#include <opencv2/core/utility.hpp>
#include <optional>
#include <thread>

namespace naocal {
namespace {

/// What was found in one picture; neither: it was not reached.
struct Outcome {
  std::optional<Detection> detection;
  std::string unreadable;
};

Outcome outcome(const Capture& capture, const CaptureSet& set, const std::filesystem::path& folder) {
  try {
    const Detection detection = detect(readPicture(folder / capture.image), set.boards, set.cameras.at(capture.camera));
    for (const Finding& finding : detection.findings) {
      if (finding.kind == FindingKind::wrongImageSize) {
        return {std::nullopt, fmt::format("capture {}: {}: {}", capture.id, capture.image, finding.sentence)};
      }
    }
    return {detection, {}};
  } catch (const InputError& error) {
    return {std::nullopt, fmt::format("capture {}: {}", capture.id, error.what())};
  }
}

/// The corners that stay: those of targets that cannot be found in pictures.
std::vector<BoardCorners> kept(const Capture& capture, const CaptureSet& set) {
  std::vector<BoardCorners> result;
  for (const BoardCorners& corners : capture.corners.value_or(std::vector<BoardCorners>{})) {
    const auto board = std::find_if(set.boards.begin(), set.boards.end(),
                                    [&](const Board& candidate) { return candidate.id == corners.board; });
    if (board != set.boards.end() && !board->pattern) {
      result.push_back(corners);
    }
  }
  return result;
}

} // namespace

SetDetection detectInSet(CaptureSet& set, const std::filesystem::path& folder, unsigned threads,
                         const DetectionProgress& progress) {
  std::vector<std::size_t> withImage;
  for (std::size_t i = 0; i < set.captures.size(); ++i) {
    if (!set.captures[i].image.empty()) {
      withImage.push_back(i);
    }
  }
  cv::setNumThreads(1); // pictures are what is done in parallel
  std::vector<Outcome> outcomes(withImage.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> goOn = true;
  std::size_t done = 0;
  std::mutex mutex; // of `done` and `progress`
  const auto work = [&] {
    for (std::size_t i = next++; i < withImage.size() && goOn; i = next++) {
      outcomes[i] = outcome(set.captures[withImage[i]], set, folder);
      const std::lock_guard lock{mutex};
      goOn = progress(++done, withImage.size()) && goOn;
    }
  };
  {
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < std::max(1u, threads); ++i) {
      workers.emplace_back(work);
    }
  }
  SetDetection result;
  for (std::size_t i = 0; i < withImage.size(); ++i) {
    Capture& capture = set.captures[withImage[i]];
    if (!outcomes[i].unreadable.empty()) {
      result.unreadable.push_back(outcomes[i].unreadable);
    }
    if (const auto& detection = outcomes[i].detection) {
      ++result.pictures;
      auto corners = kept(capture, set);
      corners.insert(corners.end(), detection->boards.begin(), detection->boards.end());
      capture.corners = corners;
      for (const Finding& finding : detection->findings) {
        result.findings.push_back({capture.id, finding});
      }
    }
  }
  return result;
}

} // namespace naocal
