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

/// The pictures of a robot's captures, for panels that come later: each capture's own one, kept while the robot showed
/// it. A robot tells its captures without pictures and without times; a capture's time is that of the message in which
/// it turned up, as long as the robot was watched without a gap. Captures that were there when watching began have no
/// picture: any that the cameras show now would be another.
class CapturePictures {
public:
  /// From now on until the next call nothing is missed.
  void beginWatch();
  /// The robot's list of captures, [{"number", "pose", "camera", "round"}]; a shorter or another one is of a new
  /// calibration. Throws Json::exception for anything else. True: there are other pictures than before.
  bool onCaptures(const nlohmann::json& captures, std::uint64_t timestamp);
  /// A camera's live picture ("top", "bottom"; time as in `told` [ms]). True: it is a capture's.
  bool onImage(const std::string& camera, std::uint64_t timestamp, std::string_view file);

  /// Which calibration it is, counted, and whose captures (by their place in the robot's list) have pictures.
  nlohmann::json list() const;
  /// Of a capture by that place; absent where there is none.
  std::optional<std::string> picture(std::size_t series, std::size_t place) const;

private:
  struct Taken {
    std::string name, camera;
    std::optional<std::uint64_t> time; // [ms]; absent: nobody watched
    std::shared_ptr<const std::string> file;
    std::uint64_t off = 0; // of the file's time from its own [ms]
  };
  struct Seen {
    std::uint64_t time = 0;
    std::shared_ptr<const std::string> file;
  };
  bool offer(Taken& taken, const Seen& seen) const;

  bool isFirst_ = true; // nothing was told since watching began
  std::size_t series_ = 0;
  std::vector<Taken> taken_;
  std::map<std::string, std::deque<Seen>> seen_; // by camera: of the last seconds
};

} // namespace naocal
