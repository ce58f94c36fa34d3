#include "setups/LeftOut.hpp"

#include "io/InputError.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>

namespace naocal {

namespace {

constexpr char prefix[] = "leftOut@";

/// One part of captures: "capture", "pose" or "board", and its name, of all sets or of one.
struct Part {
  std::string kind, name;
};

/// "leftOut@capture:17,18" names two.
std::vector<Part> parseParts(const std::string& label) {
  const std::string rest = label.substr(sizeof prefix - 1);
  const std::size_t colon = std::min(rest.find(':'), rest.size());
  std::istringstream names{rest.substr(std::min(colon + 1, rest.size()))};
  std::vector<Part> parts;
  for (std::string name; std::getline(names, name, ',');) {
    parts.push_back({rest.substr(0, colon), name});
  }
  if (parts.empty()) {
    parts.push_back({rest.substr(0, colon), ""});
  }
  return parts;
}

/// The part's name, alone and with its set.
bool isNamed(const std::string& name, const std::string& own, const CaptureSet& set) {
  return name == own || name == set.name + "/" + own;
}

/// Takes away what a capture measured, or its corners of one board. False if it is not concerned.
bool takeAway(const Part& part, const CaptureSet& set, Capture& capture) {
  if (part.kind == "board") {
    const auto isIt = [&](const BoardCorners& corners) { return isNamed(part.name, corners.board, set); };
    return capture.corners && std::erase_if(*capture.corners, isIt) > 0;
  }
  if (!isNamed(part.name, part.kind == "pose" ? capture.pose : std::to_string(capture.id), set)) {
    return false;
  }
  if (capture.corners) {
    capture.corners->clear();
  }
  capture.points.clear();
  capture.frames.clear();
  capture.contacts.clear();
  return true;
}

/// Whether anything is left of what a capture measured, or is still to be detected.
bool measures(const Capture& capture) {
  return !capture.corners || !capture.corners->empty() || !capture.points.empty() || !capture.frames.empty() ||
         !capture.contacts.empty();
}

/// Names that a label of this kind may have.
std::vector<std::string> namesOf(const std::string& kind, const std::vector<CaptureSet>& sets) {
  std::vector<std::string> names;
  for (const CaptureSet& set : sets) {
    for (const Board& board : set.boards) {
      if (kind == "board") {
        names.push_back(board.id);
      }
    }
    for (const Capture& capture : set.captures) {
      if (kind != "board") {
        names.push_back(kind == "pose" ? capture.pose : std::to_string(capture.id));
      }
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

} // namespace

bool isLeftOut(const std::string& label) {
  return label.starts_with(prefix);
}

std::string leaveOutLabel(const std::string& capture) {
  return fmt::format("{}capture:{}", prefix, capture);
}

void leaveOut(const std::string& label, std::vector<CaptureSet>& sets) {
  for (const Part& part : parseParts(label)) {
    if (part.kind != "capture" && part.kind != "pose" && part.kind != "board") {
      throw InputError{fmt::format("'{}': expected leftOut@capture:ID, leftOut@pose:NAME or leftOut@board:ID", label)};
    }
    bool isFound = false;
    for (CaptureSet& set : sets) {
      for (Capture& capture : set.captures) {
        isFound |= takeAway(part, set, capture);
      }
    }
    if (!isFound) {
      const std::vector<std::string> near = closestNames(part.name, namesOf(part.kind, sets));
      throw InputError{
          fmt::format("'{}': '{}' is no {} of these captures; {}", label, part.name, part.kind,
                      near.empty() ? "they have none" : fmt::format("near it are {}", fmt::join(near, ", ")))};
    }
  }
  if (std::none_of(sets.begin(), sets.end(), [](const CaptureSet& set) {
        return std::any_of(set.captures.begin(), set.captures.end(), measures);
      })) {
    throw InputError{fmt::format("'{}' leaves nothing to calibrate with: all captures are left out", label)};
  }
}

} // namespace naocal
