#pragma once

#include "start/ChildProgram.hpp"

#include "io/Files.hpp"

#include <boost/asio/io_context.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace naocal {

/// A capture set to try the panel with: `naocal simulate` takes pictures of a robot with a hidden effect, on demand,
/// into a temporary folder.
class SampleSet {
public:
  /// `made` gets the set's folder; `changed` is called when `state` changes.
  SampleSet(boost::asio::io_context& context, std::function<void(const std::string& folder)> made,
            std::function<void()> changed);

  /// Makes the set, once per bridge; later calls give the same one. Throws InputError if it cannot be started.
  void make();
  /// {"state": "none", "making", "made" or "failed", "sentence": why it failed}
  nlohmann::json state() const;
  /// The hidden effect, "EFFECT@PLACE", from the file beside the set. Throws InputError if there is none.
  std::string truth() const;

private:
  void onChanged();
  std::filesystem::path set() const;

  std::function<void(const std::string& folder)> made_;
  std::function<void()> changed_;
  std::unique_ptr<TemporaryDirectory> folder_;
  bool isMade_ = false;
  ChildProgram child_; // last: it ends before the folder goes
};

} // namespace naocal
