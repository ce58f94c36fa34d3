#pragma once

#include "start/DroppedFiles.hpp"
#include "start/RecentFiles.hpp"
#include "start/RobotSearch.hpp"
#include "start/SampleSet.hpp"
#include "start/SimulatedRobot.hpp"
#include "start/TableImports.hpp"

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
/// print, and files that are dropped on the page, to be opened or imported. Used on the context's thread.
class StartPage {
public:
  struct Calls {
    std::function<void(const std::string& json)> all;                    // a message for every panel
    std::function<void(std::size_t panel, const std::string& json)> one; // a message for one panel
    /// Opens a dataset that is no recent one; then calls `opened`, or `refused` with the reason. Without `refused`, all
    /// panels are told the reason.
    std::function<void(const std::vector<std::string>& paths, std::function<void(const std::string& why)> refused,
                       std::function<void()> opened)>
        open;
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
  /// Adds a part; after the last one, opens the files, begins to import them, or adds them to the panel's import.
  /// Returns {"bytes", "complete"}. Throws InputError without a begun upload; on any failure the upload is given up.
  nlohmann::json addUpload(std::size_t panel, std::string_view part);
  /// Gives up the upload and the import of a panel that was closed.
  void removePanel(std::size_t panel);
  TableImports& imports() { return imports_; }

  /// A PDF of boards, by file name such as "boards-a3.pdf"; absent for other names.
  static std::optional<std::string> boards(std::string_view name);

  /// {"kind": "start", "program": "naocal 0.1.0", "recent": [{"paths", "name", "folder", "what", "opened" [s]}],
  /// "problem", "robots": listed addresses, "search", "sample", "robot": states, "drop": what may be dropped}
  std::string message() const;

private:
  void finishUpload(std::size_t panel);
  void keep(std::shared_ptr<const void> files);
  void changed() const { calls_.all(message()); }

  Calls calls_;
  RecentFiles recent_;
  mutable std::map<std::string, std::string> kinds_;             // of recent files, by path: read once
  std::map<std::size_t, std::unique_ptr<DroppedFiles>> uploads_; // unfinished ones, by panel
  std::deque<std::shared_ptr<const void>> dropped_; // folders of opened ones: their pictures are still read
  SampleSet sample_;
  SimulatedRobot robot_;
  RobotSearch search_;
  TableImports imports_;
};

} // namespace naocal
