#pragma once

#include "analysis/Dataset.hpp"
#include "math/Worker.hpp"
#include "server/HttpServer.hpp"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace naocal {

class AnalysisSession;

/// Runs an AnalysisSession on its own thread: queues the panel's requests and reports progress. After every change of
/// the model it searches for what that lacks; the next change ends the search.
class AnalysisWorker {
public:
  /// Receives messages for all panels: kind and JSON. Called on the worker's thread. In addition to the session's
  /// kinds: "work" (current activity), "refused", "unfitted" (reason of a failed initial fit), "unsearched" (of a
  /// failed search), "made".
  using MessageSink = std::function<void(const std::string& kind, std::string json)>;

  /// Queues the initial fit. Throws InputError for captures that do not match the robot.
  AnalysisWorker(Dataset opened, MessageSink tell);
  ~AnalysisWorker();

  /// As in AnalysisSession, asynchronous. These change the model:
  void add(const std::vector<std::string>& labels);
  void drop(const std::string& label);
  void goTo(std::size_t number);
  void defineEffect(const nlohmann::json& effect);
  /// These do not change it:
  void proposePoses(int count);
  void compareWith(const std::vector<std::string>& paths);
  void generateFile(const std::string& name);

  /// Validates a custom effect; synchronous, even while the worker is busy.
  nlohmann::json checkEffect(const nlohmann::json& effect) const;

  /// A generated file, available after its "made" message; otherwise absent.
  std::optional<std::string> generatedFile(const std::string& name) const;

  /// The image file of a capture, "SET/CAPTURE"; absent if there is none.
  std::optional<std::string> picture(std::string_view path) const;

private:
  /// Reports the current activity; "": none.
  void tellWork(std::string_view what);
  void work(std::string_view what, std::function<void(AnalysisSession&)> task);
  void change(std::function<void(AnalysisSession&)> change);
  void search();
  /// For a search of the model as it is after the queued changes: tells how far it is; false once the model changes.
  std::function<bool(std::size_t found)> whileUnchanged();

  MessageSink tell_;
  std::atomic<bool> isFitted_ = false;
  std::map<std::string, std::filesystem::path> images_; // file by "SET/CAPTURE"
  std::shared_ptr<AnalysisSession> session_;            // used by the worker's thread
  std::atomic<std::size_t> changes_ = 0;                // of the model, those in the queue included
  mutable std::mutex mutex_;
  std::map<std::string, std::string> made_;   // generated files by name
  Worker thread_{Worker::AtEnd::presentTask}; // last: uses the members above
};

/// Holds the analysis of the open captures and replaces it. A separate thread opens captures, because reading and
/// corner detection take long and robots must stay reachable. Used on the panel's thread only.
class AnalysisSlot {
public:
  using PostToPanelThread = std::function<void(std::function<void()>)>; // thread-safe
  using Broadcast = std::function<void(const Message& message)>;        // to every panel
  AnalysisSlot(PostToPanelThread later, Broadcast all) : later_{std::move(later)}, all_{std::move(all)} {}

  /// Replaces the analysis. Throws InputError for captures that do not match the robot.
  void setDataset(Dataset opened);
  /// Opens captures asynchronously and analyses them; then calls `opened`, or on failure `refused` with the reason.
  /// Sends "missing" to every panel if a document's captures were not found, also in `lookIn`, and "moved" if they were
  /// found elsewhere than it says.
  void open(
      const std::vector<std::string>& paths, std::function<void(const std::string& problem)> refused,
      std::function<void()> opened = [] {}, const std::vector<std::filesystem::path>& lookIn = {});

  /// nullptr if no captures are open.
  AnalysisWorker* worker() const { return worker_.get(); }
  /// The last message of each kind, in order, for a new panel.
  const std::vector<std::pair<std::string, Message>>& latest() const { return latest_; }

private:
  void remember(const std::string& kind, const Message& told);
  void tellWork(const char* what);

  PostToPanelThread later_;
  Broadcast all_;
  std::size_t number_ = 0;                              // number of the current worker
  std::vector<std::pair<std::string, Message>> latest_; // by kind
  std::unique_ptr<AnalysisWorker> worker_;
  Worker leaving_{Worker::AtEnd::presentTask}, opening_{Worker::AtEnd::presentTask}; // last: they end first
};

} // namespace naocal
