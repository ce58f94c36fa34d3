#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// Collects the images of a robot's captures for panels that connect later. A robot lists its captures without images
/// and time stamps; the time of a capture is that of the message in which it first appears, if the robot was watched
/// without a gap. An image belongs to one capture, the nearest in time: where few images arrive, captures have none
/// rather than another's. Captures listed when watching began get no image: the live images then show something else.
class CapturePictures {
public:
  /// Starts a gapless watch.
  void beginWatch();
  /// Updates the robot's list of captures, [{"number", "pose", "camera", "round"}]; a shorter or different list belongs
  /// to a new calibration. Throws Json::exception for an invalid list. True: the available images have changed.
  bool onCaptures(const nlohmann::json& captures, std::uint64_t timestamp);
  /// Adds a live image of a camera ("top", "bottom"; time as in `onCaptures` [ms]). True: it belongs to a capture.
  bool onImage(const std::string& camera, std::uint64_t timestamp, std::string_view file);

  /// Number of the calibration, and the indices of captures with images.
  nlohmann::json list() const;
  /// The image of a capture by index; absent if there is none.
  std::optional<std::string> picture(std::size_t series, std::size_t place) const;

private:
  struct Taken {
    std::string name, camera;
    std::optional<std::uint64_t> time; // [ms]; absent: not watched
    std::shared_ptr<const std::string> file;
  };
  struct Seen {
    std::uint64_t time = 0;
    std::shared_ptr<const std::string> file;
  };
  bool assignImages(const std::string& camera);

  bool isFirst_ = true; // no list since watching began
  std::size_t series_ = 0;
  std::vector<Taken> taken_;
  std::map<std::string, std::deque<Seen>> seen_; // recent images by camera
};

} // namespace naocal
