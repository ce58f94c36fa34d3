#pragma once

#include "start/DroppedFiles.hpp"
#include "start/RecentFiles.hpp"
#include "start/RobotSearch.hpp"
#include "start/SampleSet.hpp"
#include "start/SimulatedRobot.hpp"

#include <boost/asio/io_context.hpp>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// What the panel's start page offers: recent files, a sample set, a simulated robot, robots on the network, boards to
/// print, and files that are dropped on the page. Used on the context's thread.
class StartPage {
public:
  struct Calls {
    std::function<void(const std::string& json)> all;                // a message for every panel
    std::function<void(const std::vector<std::string>& paths)> open; // opens a temporary dataset
    std::function<void(const std::string&address)> connect, disconnect;
  };
  /// `recentFiles`: where recent files are kept; empty: nowhere.
  StartPage(boost::asio::io_context& context, const std::filesystem::path& recentFiles, Calls calls);

  /// Adds paths that were opened to the recent ones.
  void opened(const std::vector<std::string>& paths);
  void forget(const std::vector<std::string>& paths);
  /// Keeps this list of robots' addresses and looks for them.
  void findRobots(const std::vector<std::string>& addresses);
  void openSample() { sample_.make(); }
  /// The sample's hidden effect. Throws InputError without the sample.
  std::string sampleTruth() const { return sample_.truth(); }
  void startRobot() { robot_.start(); }
  void endRobot() { robot_.end(); }

  /// Begins a panel's upload, which replaces its unfinished one. Throws InputError as DroppedFiles does.
  void beginUpload(std::size_t panel, const nlohmann::json& files);
  /// Adds a part; opens the files after the last one. Returns {"bytes", "complete"}. Throws InputError without a begun
  /// upload; on any failure the upload is given up.
  nlohmann::json addUpload(std::size_t panel, std::string_view part);
  /// Gives up the upload of a panel that was closed.
  void removePanel(std::size_t panel) { uploads_.erase(panel); }

  /// A PDF of boards, by file name such as "boards-a3.pdf"; absent for other names.
  static std::optional<std::string> boards(std::string_view name);

  /// {"kind": "start", "recent": [{"paths", "name", "folder", "what", "opened" [s]}], "problem", "robots": listed
  /// addresses, "search", "sample", "robot": states}
  std::string message() const;

private:
  void finishUpload(std::size_t panel);
  void changed() const { calls_.all(message()); }

  Calls calls_;
  RecentFiles recent_;
  mutable std::map<std::string, std::string> kinds_;             // of recent files, by path: read once
  std::map<std::size_t, std::unique_ptr<DroppedFiles>> uploads_; // unfinished ones, by panel
  std::deque<std::unique_ptr<DroppedFiles>> dropped_;            // opened ones: their pictures are still read
  SampleSet sample_;
  SimulatedRobot robot_;
  RobotSearch search_;
};

} // namespace naocal
