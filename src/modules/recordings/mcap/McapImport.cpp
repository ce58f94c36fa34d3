#include "recordings/mcap/McapImport.hpp"

#include "io/InputError.hpp"
#include "recordings/mcap/McapReader.hpp"
#include "recordings/mcap/RosMessages.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <limits>
#include <set>

namespace naocal {

namespace {

using Time = std::chrono::nanoseconds;

constexpr std::string_view jointStateType = "sensor_msgs/msg/JointState", imageType = "sensor_msgs/msg/Image",
                           compressedType = "sensor_msgs/msg/CompressedImage", infoType = "sensor_msgs/msg/CameraInfo";

/// What the first reading of the recording keeps.
struct Contents {
  std::map<std::string, JointSeries> joints;
  std::vector<Time> pictures; // in the order of messages
  std::optional<RosCameraLens> lens;
  std::map<std::string, std::string, std::less<>> topics; // type by name
};

std::ifstream openRecording(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw InputError{fmt::format("{}: expected a recording (MCAP), found {}", file.string(),
                                 std::filesystem::exists(file, error) ? "no regular file" : "no such file")};
  }
  std::ifstream stream{file, std::ios::binary};
  if (!stream) {
    throw InputError{fmt::format("{}: expected a file that can be read, found one that cannot", file.string())};
  }
  return stream;
}

std::string infoTopic(const McapTopics& topics) {
  if (!topics.cameraInfo.empty()) {
    return topics.cameraInfo;
  }
  return topics.images.substr(0, topics.images.rfind('/') + 1) + "camera_info";
}

class McapImporter {
public:
  McapImporter(const std::filesystem::path& file, const ImportScene& scene, const McapTopics& topics)
      : file_{file}, scene_{scene}, topics_{topics}, infoTopic_{infoTopic(topics)} {}

  McapImport run(const RestOptions& restOptions) {
    readContents();
    requireContents();
    const std::vector<std::size_t> order = timeOrder();
    std::vector<Time> times;
    for (const std::size_t index : order) {
      times.push_back(contents_.pictures[index]);
    }
    std::vector<RestInstant> rests = findRestInstants(contents_.joints, times, restOptions);
    if (rests.empty()) {
      throw InputError{fmt::format(
          "{}: expected pictures during which all joints rest, found none among {}: the robot must stand still for "
          "{:.2f} s around a picture, moving by at most {:.4f} rad (--rest)",
          file_.string(), times.size(), 2 * std::chrono::duration<double>{restOptions.around}.count(),
          restOptions.mostTravel)};
    }
    McapImport result;
    result.pictures = times.size();
    result.rests = rests.size();
    for (const RestInstant& rest : rests) {
      result.poses = std::max(result.poses, rest.pose + 1);
    }
    result.imported = makeSet(rests, times);
    readPictures(rests, order, result.imported);
    return result;
  }

private:
  std::string where(const McapMessage& message) const {
    return fmt::format("{}, topic {}", file_.string(), printableText(message.topic, 80));
  }

  void requireType(const McapMessage& message, std::initializer_list<std::string_view> types) const {
    const bool isKnown = std::find(types.begin(), types.end(), message.schema) != types.end();
    if (!isKnown) {
      throw InputError{fmt::format("{}: expected messages of the type {}, found {}", where(message),
                                   fmt::join(types, " or "), printableText(message.schema, 80))};
    }
    if (message.encoding != "cdr") {
      throw InputError{fmt::format("{}: expected messages encoded as cdr (ROS 2), found \"{}\"", where(message),
                                   printableText(message.encoding, 40))};
    }
  }

  void readContents() {
    std::ifstream stream = openRecording(file_);
    visitMcapMessages(stream, file_.string(), [&](const McapMessage& message) {
      if (!contents_.topics.contains(message.topic)) {
        contents_.topics.emplace(message.topic, message.schema);
      }
      if (message.topic == topics_.joints) {
        requireType(message, {jointStateType});
        addJoints(parseJointState(message.data, where(message)), message);
      } else if (message.topic == topics_.images) {
        requireType(message, {imageType, compressedType});
        contents_.pictures.push_back(parseStamp(message.data, where(message)));
      } else if (message.topic == infoTopic_ && !contents_.lens && !scene_.lens) {
        requireType(message, {infoType});
        contents_.lens = parseCameraInfo(message.data, where(message));
      }
      return true;
    });
    for (auto& [name, series] : contents_.joints) {
      std::stable_sort(series.begin(), series.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    }
  }

  void addJoints(const RosJointState& state, const McapMessage& message) {
    for (std::size_t i = 0; i < state.names.size(); ++i) {
      if (!scene_.robot.jointIndex(state.names[i])) {
        continue;
      }
      if (!std::isfinite(state.positions[i])) {
        throw InputError{fmt::format("{}: expected a number for joint {}, found {}", where(message), state.names[i],
                                     state.positions[i])};
      }
      contents_.joints[state.names[i]].emplace_back(state.stamp, state.positions[i]);
    }
  }

  std::string topicList() const {
    std::vector<std::string> names;
    for (const auto& [name, type] : contents_.topics) {
      names.push_back(printableText(name, 80) + " (" + printableText(type, 80) + ")");
    }
    return names.empty() ? "no message at all" : fmt::format("{}", fmt::join(names, ", "));
  }

  void requireContents() const {
    if (!contents_.topics.contains(topics_.joints)) {
      throw InputError{fmt::format("{}: expected joint states on the topic {} (--joints), found {}", file_.string(),
                                   topics_.joints, topicList())};
    }
    if (contents_.joints.empty()) {
      throw InputError{
          fmt::format("{}, topic {}: expected joints of the URDF, found others", file_.string(), topics_.joints)};
    }
    if (contents_.pictures.empty()) {
      throw InputError{fmt::format("{}: expected pictures on the topic {} (--images), found {}", file_.string(),
                                   topics_.images, topicList())};
    }
  }

  /// Indices of the pictures by time.
  std::vector<std::size_t> timeOrder() const {
    std::vector<std::size_t> order(contents_.pictures.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      order[i] = i;
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return contents_.pictures[a] < contents_.pictures[b]; });
    return order;
  }

  ImportedSet makeSet(const std::vector<RestInstant>& rests, const std::vector<Time>& times) const {
    std::vector<std::string> jointNames; // in the order of the description
    for (const Joint& joint : scene_.robot.joints) {
      if (contents_.joints.contains(joint.name)) {
        jointNames.push_back(joint.name);
      }
    }
    ImportedSet imported = beginImport(scene_, jointNames);
    for (const RestInstant& rest : rests) {
      Capture capture;
      capture.id = static_cast<int>(imported.set.captures.size());
      capture.pose = poseName(rest.pose);
      capture.repeat = rest.repeat;
      capture.repeatKind = RepeatKind::reapproach;
      capture.time = times[rest.picture] - times.front();
      capture.camera = scene_.camera;
      capture.supportFoot = SupportFoot::none;
      for (const std::string& name : jointNames) {
        capture.joints.measured.push_back(rest.angles.at(name));
      }
      imported.set.captures.push_back(std::move(capture));
    }
    return imported;
  }

  /// Second reading: adds the pictures of the rests, and the camera.
  void readPictures(const std::vector<RestInstant>& rests, const std::vector<std::size_t>& order,
                    ImportedSet& imported) const {
    std::map<std::size_t, std::size_t> captureOf; // by number of the message
    for (std::size_t i = 0; i < rests.size(); ++i) {
      captureOf[order[rests[i].picture]] = i;
    }
    std::size_t number = 0;
    std::string frame;
    std::ifstream stream = openRecording(file_);
    visitMcapMessages(stream, file_.string(), [&](const McapMessage& message) {
      if (message.topic != topics_.images) {
        return true;
      }
      const auto found = captureOf.find(number++);
      if (found != captureOf.end()) {
        const RosImage image = message.schema == imageType ? parseImage(message.data, where(message))
                                                           : parseCompressedImage(message.data, where(message));
        frame = image.frame;
        addPicture(image, imported.set.captures[found->second], imported);
      }
      return true;
    });
    const std::string link = !scene_.cameraLink.empty() ? scene_.cameraLink
                             : contents_.lens           ? contents_.lens->frame
                                                        : frame;
    std::optional<CameraIntrinsics> lens = scene_.lens;
    if (!lens && contents_.lens) {
      lens = contents_.lens->lens;
    }
    addCamera(scene_, lens, link, imported);
  }

  static void addPicture(const RosImage& image, Capture& capture, ImportedSet& imported) {
    const auto* const grey = std::get_if<GreyPicture>(&image.content);
    const std::string content = grey != nullptr ? encodePng(*grey) : std::get<std::string>(image.content);
    const bool isPng = content.starts_with("\x89PNG");
    capture.image = fmt::format("images/{:04}.{}", capture.id, isPng ? "png" : "jpg");
    imported.files[capture.image] = content;
  }

  std::filesystem::path file_;
  const ImportScene& scene_;
  const McapTopics& topics_;
  std::string infoTopic_;
  Contents contents_;
};

} // namespace

McapImport importMcap(const std::filesystem::path& file, const ImportScene& scene, const McapTopics& topics,
                      const RestOptions& rests) {
  return McapImporter{file, scene, topics}.run(rests);
}

} // namespace naocal
