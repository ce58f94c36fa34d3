#include "inspection/CaptureSetCheck.hpp"

#include "data/CaptureSetFile.hpp"
#include "inspection/UnknownKeys.hpp"
#include "io/Files.hpp"
#include "io/GreyImage.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "measurements/JointMotion.hpp"
#include "measurements/Measurements.hpp"
#include "robot/RobotOfSet.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

namespace naocal {

namespace {

constexpr double limitMargin = radians(10); // a joint's offset and the stop's softness; more is no reading of it [rad]
constexpr double beyondEveryLimit = 2.2;    // no joint of a NAO reaches 126 degrees [rad]
constexpr double degreesShare = 0.3;        // of readings beyond that: an arm may be recorded wrongly, not a third
constexpr double cornerMargin = 3;          // of noise beyond the image's edge [px]
constexpr double onePoint = 1;              // smaller than a marker that any detector reads [px]
constexpr std::size_t fewPoses = 4;         // fewer leave most offsets of a leg undetermined

/// The set under check, and its problems so far.
struct Check {
  const std::filesystem::path& folder;
  std::string file;
  SurveyedCaptureSet survey;
  std::vector<SetProblem> problems = {};

  const CaptureSet& set() const { return survey.set; }
  void add(Severity severity, std::string kind, std::string_view place, std::string_view sentence) {
    problems.push_back({severity, std::move(kind), fmt::format("{}: {}: {}", file, place, sentence)});
  }
  /// "captures[3] (capture 12)"
  std::string placeOf(const Capture& capture) const {
    const nlohmann::json& first = (*set().source)["captures"].front();
    return fmt::format("captures[{}] (capture {})", capture.source.get() - &first, capture.id);
  }
};

void addRefusals(Check& check) {
  for (const std::string& sentence : check.survey.refusals) {
    check.problems.push_back({Severity::refused, "refused", sentence});
  }
}

void addUnknownKeys(Check& check) {
  for (const auto& [path, key, closest] : findUnknownKeys(*check.set().source, check.survey.asked)) {
    check.add(closest.empty() ? Severity::remark : Severity::doubtful, "unknown-key", path.empty() ? "top level" : path,
              closest.empty()
                  ? fmt::format("\"{}\" is no key of the format and is ignored", key)
                  : fmt::format("\"{}\" is no key of the format and is ignored; if \"{}\" is meant, rename it", key,
                                closest));
  }
}

/// Whether the measured angles are degrees: many lie beyond every joint's limit, and all within a full turn.
bool suspectsDegrees(const nlohmann::json& document) {
  std::size_t moved = 0, beyond = 0;
  double largest = 0;
  for (const nlohmann::json& capture : document.value("captures", nlohmann::json::array())) {
    if (!capture.is_object() || !capture.contains("joints") || !capture["joints"].is_object() ||
        !capture["joints"].contains("measured")) {
      continue;
    }
    for (const nlohmann::json& angle : capture["joints"]["measured"]) {
      const double size = angle.is_number() ? std::abs(angle.get<double>()) : 0;
      moved += size > 0 ? 1 : 0;
      beyond += size > beyondEveryLimit ? 1 : 0;
      largest = std::max(largest, size);
    }
  }
  return double(beyond) > degreesShare * double(moved) && largest <= 360;
}

/// The robot's drawing; a model without one is a problem.
std::optional<Robot> loadDrawing(Check& check) {
  try {
    return loadRobot(check.set());
  } catch (const InputError& error) {
    check.add(Severity::refused, "unknown-robot", "robot.model",
              fmt::format("\"{}\" has no drawing ({})", check.set().model, error.what()));
    return std::nullopt;
  }
}

void addBeyondLimits(Check& check, const Robot& robot) {
  const CaptureSet& set = check.set();
  for (const Capture& capture : set.captures) {
    for (std::size_t i = 0; i < capture.joints.measured.size(); ++i) {
      const auto joint = robot.jointIndex(set.jointNames[i]);
      const double angle = capture.joints.measured[i];
      if (joint && (angle < robot.joints[*joint].limits.lower - limitMargin ||
                    angle > robot.joints[*joint].limits.upper + limitMargin)) {
        const AngleRange& limits = robot.joints[*joint].limits;
        check.add(
            Severity::doubtful, "beyond-limits", check.placeOf(capture) + ".joints.measured",
            fmt::format("{} of {:.3f} rad lies beyond its limits of {:.3f} to {:.3f} rad by more than 10°; check the "
                        "order of jointNames, the sign and the unit",
                        set.jointNames[i], angle, limits.lower, limits.upper));
      }
    }
  }
}

void addCameras(Check& check, const Robot* robot) {
  for (const auto& [name, camera] : check.set().cameras) {
    const std::string place = "cameras." + name;
    if (robot != nullptr && !robot->cameraIndex(name)) {
      check.add(
          Severity::doubtful, "unknown-camera", place,
          fmt::format("the {} has no camera of that name; rename it to one of its drawing's, or captures by it are "
                      "refused",
                      robot->model));
    }
    const double wide = camera.fx / camera.width, high = camera.fy / camera.fx;
    if (wide < 0.3 || wide > 5 || high < 0.8 || high > 1.25) {
      check.add(
          Severity::doubtful, "focal-length", place,
          fmt::format("fx = {:g} px and fy = {:g} px are no focal lengths of a camera with pictures of {} × {} pixels "
                      "(about 0.9 of the width on a NAO); give pixels at this size",
                      camera.fx, camera.fy, camera.width, camera.height));
    }
    if (camera.cx < 0 || camera.cy < 0 || camera.cx > camera.width || camera.cy > camera.height) {
      check.add(
          Severity::doubtful, "principal-point", place,
          fmt::format("the principal point ({:g}, {:g}) px lies outside the picture of {} × {} pixels; give it at this "
                      "size",
                      camera.cx, camera.cy, camera.width, camera.height));
    }
  }
}

/// Compares a picture with its camera; one sentence if it is missing, broken or of another size.
void addPicture(Check& check, const Capture& capture) {
  const std::string place = check.placeOf(capture) + ".image";
  const auto path = check.folder / capture.image;
  const bool isNeeded = !capture.corners;
  if (!std::filesystem::exists(path)) {
    check.add(isNeeded ? Severity::refused : Severity::remark, "missing-picture", place,
              fmt::format("there is no file {}; {}", path.string(),
                          isNeeded ? "put it there, or leave the capture out"
                                   : "the capture counts by its corners, but nobody can look at it"));
    return;
  }
  try {
    const GreyPicture picture = readImage(path);
    const CameraIntrinsics& camera = check.set().cameras.at(capture.camera);
    if (picture.width != camera.width || picture.height != camera.height) {
      check.add(
          isNeeded ? Severity::refused : Severity::doubtful, "picture-size", place,
          fmt::format("{} has {} × {} pixels, the camera {} {} × {}; give the camera's numbers for the pictures' size",
                      capture.image, picture.width, picture.height, capture.camera, camera.width, camera.height));
    }
  } catch (const InputError& error) {
    check.add(isNeeded ? Severity::refused : Severity::doubtful, "broken-picture", place, error.what());
  }
}

void addPictures(Check& check, const CheckProgress& progress) {
  std::vector<const Capture*> withPicture;
  for (const Capture& capture : check.set().captures) {
    if (!capture.image.empty() && check.set().cameras.contains(capture.camera)) {
      withPicture.push_back(&capture);
    }
  }
  std::map<std::string, const Capture*> first;
  for (std::size_t i = 0; i < withPicture.size(); ++i) {
    const auto [other, isNew] = first.try_emplace(withPicture[i]->image, withPicture[i]);
    if (!isNew) {
      check.add(Severity::doubtful, "same-picture", check.placeOf(*withPicture[i]) + ".image",
                fmt::format("{} is also the picture of capture {}; each capture has one of its own",
                            withPicture[i]->image, other->second->id));
    }
    addPicture(check, *withPicture[i]);
    if (progress && !progress(i + 1, withPicture.size())) {
      return;
    }
  }
}

void addTimeOrder(Check& check) {
  const Capture* previous = nullptr;
  for (const Capture& capture : check.set().captures) {
    if (previous != nullptr && capture.time < previous->time) {
      check.add(
          Severity::doubtful, "time-order", check.placeOf(capture) + ".time",
          fmt::format("{:.3f} s lies before the {:.3f} s of capture {} above it; list captures as they were taken, by "
                      "one clock, or effects that grow with time are misjudged",
                      capture.time.count(), previous->time.count(), previous->id));
    }
    previous = &capture;
  }
}

void addCornersOutside(Check& check) {
  for (const Capture& capture : check.set().captures) {
    const auto camera = check.set().cameras.find(capture.camera);
    if (camera == check.set().cameras.end()) {
      continue;
    }
    for (const BoardCorners& corners : capture.corners.value_or(std::vector<BoardCorners>{})) {
      const auto outside = std::count_if(corners.uv.begin(), corners.uv.end(), [&](const Eigen::Vector2d& uv) {
        return uv.x() < -0.5 - cornerMargin || uv.y() < -0.5 - cornerMargin ||
               uv.x() > camera->second.width - 0.5 + cornerMargin ||
               uv.y() > camera->second.height - 0.5 + cornerMargin;
      });
      if (outside > 0) {
        check.add(
            Severity::doubtful, "outside-picture", check.placeOf(capture) + ".corners",
            fmt::format("{} of {} corners of board {} lie outside the picture of {} × {} pixels; check the camera's "
                        "size, or detect the corners anew",
                        outside, corners.uv.size(), corners.board, camera->second.width, camera->second.height));
      }
    }
  }
}

/// Whether a detector writes this for a corner that it did not find: (0, 0) or (-1, -1).
bool isFailureValue(const Eigen::Vector2d& uv) {
  return uv.x() == uv.y() && (uv.x() == 0 || uv.x() == -1);
}

/// Whether all corners of a view lie at one point of the picture.
bool areAtOnePoint(const std::vector<Eigen::Vector2d>& uv) {
  return uv.size() > 1 && std::all_of(uv.begin(), uv.end(), [&](const Eigen::Vector2d& other) {
           return (other - uv.front()).norm() < onePoint;
         });
}

/// Views of boards that no detector saw: all corners at one point, or some at its value for failure.
void addFailedCorners(Check& check) {
  for (const Capture& capture : check.set().captures) {
    for (const BoardCorners& corners : capture.corners.value_or(std::vector<BoardCorners>{})) {
      const auto failed = std::count_if(corners.uv.begin(), corners.uv.end(), isFailureValue);
      const std::string place = check.placeOf(capture) + ".corners";
      if (areAtOnePoint(corners.uv)) {
        check.add(Severity::doubtful, "corners-at-one-point", place,
                  fmt::format("all {} corners of board {} lie at one point, ({:g}, {:g}) px{}; leave the view out, or "
                              "detect its corners anew",
                              corners.uv.size(), corners.board, corners.uv.front().x(), corners.uv.front().y(),
                              failed > 0 ? ", as a detector that found nothing writes them" : ""));
      } else if (failed > 0) {
        check.add(Severity::doubtful, "failed-corners", place,
                  fmt::format("{} of {} corners of board {} lie at the picture's very corner, as a detector that did "
                              "not find them writes them; leave these out, or detect the corners anew",
                              failed, corners.uv.size(), corners.board));
      }
    }
  }
}

void addUnseenBoards(Check& check) {
  const CaptureSet& set = check.set();
  const auto pending = std::count_if(set.captures.begin(), set.captures.end(), [](const Capture& capture) {
    return !capture.camera.empty() && !capture.corners;
  });
  if (pending > 0) {
    check.add(Severity::doubtful, "no-corners", "captures",
              fmt::format("{} of {} captures have no corners yet; run 'naocal detect {}'", pending, set.captures.size(),
                          check.folder.string()));
    return;
  }
  std::map<std::string, std::size_t> seen;
  for (const Capture& capture : set.captures) {
    for (const BoardCorners& corners : capture.corners.value_or(std::vector<BoardCorners>{})) {
      seen[corners.board] += corners.ids.empty() ? 0 : 1;
    }
  }
  for (const Board& board : set.boards) {
    if (!set.captures.empty() && seen[board.id] == 0) {
      check.add(Severity::remark, "unseen-board", "boards",
                fmt::format("board {} is seen in no capture; check its dictionary and firstMarkerId, or remove it",
                            board.id));
    }
  }
}

void addCounts(Check& check, std::size_t poses) {
  const CaptureSet& set = check.set();
  if (poses < fewPoses) {
    check.add(Severity::doubtful, "few-poses", "captures",
              fmt::format("{} different pose{}, expected at least {}; take more (naocal poses plans them)", poses,
                          poses == 1 ? "" : "s", fewPoses));
  }
  std::set<std::pair<std::string, std::string>> taken;
  const bool hasRepeats = std::any_of(set.captures.begin(), set.captures.end(), [&](const Capture& capture) {
    return !taken.insert({capture.pose, capture.camera}).second;
  });
  const bool hasPictures = std::any_of(set.captures.begin(), set.captures.end(),
                                       [](const Capture& capture) { return !capture.camera.empty(); });
  if (hasPictures && !hasRepeats) {
    check.add(
        Severity::remark, "no-repeats", "captures",
        "no pose was pictured twice by a camera, so that nothing in the captures proves the noise; take two of each");
  }
  for (std::size_t i = 0; i < set.stances.size(); ++i) {
    const int id = set.stances[i].id;
    if (std::none_of(set.captures.begin(), set.captures.end(),
                     [&](const Capture& each) { return each.stance == id; })) {
      check.add(Severity::remark, "unused-stance", "stances", fmt::format("stance {} has no capture; remove it", id));
    }
  }
}

/// What a calibration takes for granted: readings that are none, and directions that were not recorded.
void addAssumptions(Check& check, const Measurements& measurements) {
  for (const FailedReadings& failed : measurements.failedReadings.front()) {
    check.add(Severity::doubtful, "no-reading", "captures",
              describeFailedReadings(failed, measurements.sets->front()) + "; remove them, or measure again");
  }
  if (measurements.approachesFromOrder > 0) {
    check.add(Severity::remark, "approach-from-order", "captures",
              fmt::format("{} of {} record no direction of approach; it is taken from the order of captures, as if the "
                          "robot went from each pose straight to the next",
                          measurements.approachesFromOrder, measurements.pictures.size()));
  }
}

/// Joints between what measures and what is measured that keep their angle in all captures.
void addStillJoints(Check& check, const Measurements& measurements) {
  std::vector<std::string> names;
  for (const std::size_t joint : measurements.joints) {
    if (isStill(joint, measurements)) {
      names.push_back(measurements.robot.joints[joint].name);
    }
  }
  if (!names.empty() && measurements.poses.size() > 1) {
    const bool single = names.size() == 1;
    check.add(
        Severity::doubtful, "still-joints", "captures[*].joints.measured",
        fmt::format("{} joint{} never moved: {}; without motion no offset can be learned: add poses that move {}, "
                    "or leave {} out",
                    names.size(), single ? "" : "s", fmt::join(names, ", "), single ? "it" : "them",
                    single ? "its offset" : "their offsets"));
  }
}

/// What a calibration refuses in a set that can be read; corners that are not detected yet are reported elsewhere.
void addCalibrationRefusal(Check& check, const Robot& robot) {
  CaptureSet ready = check.set();
  std::erase_if(ready.captures, [&](const Capture& capture) { return !capture.camera.empty() && !capture.corners; });
  if (ready.captures.empty()) {
    return;
  }
  try {
    const Measurements measurements = buildMeasurements({std::move(ready)}, robot);
    addAssumptions(check, measurements);
    addStillJoints(check, measurements);
  } catch (const InputError& error) {
    check.problems.push_back({Severity::refused, "not-usable", error.what()});
  }
}

} // namespace

std::string_view toString(Severity severity) {
  return severity == Severity::refused ? "refused" : severity == Severity::doubtful ? "doubtful" : "remark";
}

CaptureSetCheck checkCaptureSet(const std::filesystem::path& folder, const CheckProgress& progress) {
  const std::string file = (folder / "captures.json").string();
  SurveyedCaptureSet survey = surveyCaptureSet(readFile(file), file);
  survey.set.folder = folder;
  Check check{folder, file, std::move(survey)};
  const nlohmann::json& document = *check.set().source;
  CaptureSetCheck result;
  if (document.contains("captures") && document["captures"].is_array()) {
    result.captures = document["captures"].size();
  }
  std::set<std::string> poses;
  for (const Capture& capture : check.set().captures) {
    poses.insert(capture.pose);
  }
  result.poses = poses.size();

  const bool isDegrees = suspectsDegrees(document);
  if (isDegrees) {
    check.add(Severity::refused, "degrees", "captures[*].joints.measured",
              "more than 30 % of the angles lie beyond every joint's limit, as if they were degrees; convert them to "
              "radians (factor 0.0174533)");
  }
  addRefusals(check);
  const std::optional<Robot> robot = loadDrawing(check);
  if (robot && check.survey.refusals.empty()) {
    addCalibrationRefusal(check, *robot);
  }
  if (robot && !isDegrees) {
    addBeyondLimits(check, *robot);
  }
  addCameras(check, robot ? &*robot : nullptr);
  addPictures(check, progress);
  addCornersOutside(check);
  addFailedCorners(check);
  addTimeOrder(check);
  if (check.survey.refusals.empty()) { // captures that cannot be read are not missing
    addCounts(check, poses.size());
    addUnseenBoards(check);
  }
  addUnknownKeys(check);
  std::stable_sort(check.problems.begin(), check.problems.end(),
                   [](const SetProblem& one, const SetProblem& other) { return one.severity < other.severity; });
  result.problems = std::move(check.problems);
  return result;
}

} // namespace naocal
