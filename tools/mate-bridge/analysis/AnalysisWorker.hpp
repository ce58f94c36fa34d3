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

/// Runs an AnalysisSession on a thread of its own: takes the panel's requests and reports progress. After every change
/// of the model all candidates are tested, unless another change waits.
class AnalysisWorker {
public:
  /// A message for all panels: its kind, and its JSON. Called on the worker's thread. Beside the session's kinds:
  /// "work" (what it is at), "refused", "unfitted" (why there is no fit at all), "made".
  using MessageSink = std::function<void(const std::string& kind, std::string json)>;

  /// Starts with the first fit. Throws InputError for captures that the robot cannot have made.
  AnalysisWorker(Dataset opened, MessageSink tell);
  ~AnalysisWorker();

  /// As AnalysisSession, later and on the worker's thread. These change the model:
  void add(const std::string& label);
  void drop(const std::string& label);
  void goTo(std::size_t number);
  void defineEffect(const nlohmann::json& effect);
  /// These leave it as it is:
  void searchMissing();
  void cancelSearch();
  void proposePoses(int count);
  void compareWith(const std::vector<std::string>& paths);
  void generateFile(const std::string& name);

  /// Whether a person's own effect can be used; at once, whatever the worker is busy with.
  nlohmann::json checkEffect(const nlohmann::json& effect) const;

  /// A file that was made ("made" says when).
  std::optional<std::string> generatedFile(const std::string& name) const;

  /// The file of a picture that was kept: "SET/CAPTURE". Absent when there is none.
  std::optional<std::string> picture(std::string_view path) const;

private:
  void work(std::string_view what, std::function<void(AnalysisSession&)> task);
  void change(std::function<void(AnalysisSession&)> change);
  void testCandidates();

  MessageSink tell_;
  std::atomic<bool> isFitted_ = false;
  std::map<std::string, std::filesystem::path> images_; // "SET/CAPTURE"
  std::shared_ptr<AnalysisSession> session_;            // of the worker's thread
  std::atomic<bool> cancelled_ = false;
  std::atomic<int> questions_ = 0; // that wait
  mutable std::mutex mutex_;
  std::map<std::string, std::string> made_;   // files by name
  Worker thread_{Worker::AtEnd::presentTask}; // last: it uses the others
};

/// The analysis of the captures that are open, and its replacement: captures are opened by a thread of their own, as
/// reading and detecting corners takes long and robots must be reached meanwhile. Used on the panel's thread only.
class AnalysisSlot {
public:
  using PostToPanelThread = std::function<void(std::function<void()>)>; // to the panel's thread, from any other
  using Broadcast = std::function<void(const Message& message)>;        // to every panel
  AnalysisSlot(PostToPanelThread later, Broadcast all) : later_{std::move(later)}, all_{std::move(all)} {}

  /// Analyses these captures instead of the present ones. Throws InputError for captures that the robot cannot have
  /// made.
  void setDataset(Dataset opened);
  /// Opens captures and analyses them, later; `refused` gets the reason why not.
  void open(const std::vector<std::string>& paths, std::function<void(const std::string& problem)> refused);

  /// nullptr: nothing is open yet.
  AnalysisWorker* worker() const { return worker_.get(); }
  /// What a panel that comes must know, in the order in which it was told.
  const std::vector<std::pair<std::string, Message>>& latest() const { return latest_; }

private:
  void remember(const std::string& kind, const Message& told);
  void tellWork(const char* what);

  PostToPanelThread later_;
  Broadcast all_;
  std::size_t number_ = 0;                              // of the worker
  std::vector<std::pair<std::string, Message>> latest_; // what it told last, by kind
  std::unique_ptr<AnalysisWorker> worker_;
  Worker leaving_{Worker::AtEnd::presentTask}, opening_{Worker::AtEnd::presentTask}; // last: they end first
};

} // namespace naocal
