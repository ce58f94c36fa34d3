#pragma once

#include "analysis/Dataset.hpp"
#include "server/HttpServer.hpp"
#include "server/JobQueue.hpp"

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

class Laboratory;

/// The laboratory behind the panel: takes what people ask for, works on a thread of its own and says how it is getting
/// on. After every change of the model it is put to the question, unless more was asked for meanwhile.
class LabDesk {
public:
  /// A message for all panels: its kind, and its JSON. Called on the desk's thread. Beside the laboratory's kinds:
  /// "work" (what it is at), "refused", "unfitted" (why there is no fit at all), "made".
  using Tell = std::function<void(const std::string& kind, std::string json)>;

  /// Starts with the first fit. Throws InputError for captures that the robot cannot have made.
  LabDesk(OpenedSets opened, Tell tell);
  ~LabDesk();

  /// Does what a panel asks for: {"do": "add" | "drop", "label"}, {"do": "goTo", "rung"}, {"do": "search"}, {"do":
  /// "cancel"} of that search, {"do": "define", "effect"}, {"do": "propose", "count"}, {"do": "compare", "paths"},
  /// {"do": "make", "file"}. False: that is nothing for the laboratory.
  bool asked(const nlohmann::json& request);

  /// Whether a person's own effect can be used; at once, whatever the desk works at.
  nlohmann::json checked(const nlohmann::json& effect) const;

  /// A file that was made ("made" says when).
  std::optional<std::string> made(const std::string& name) const;

  /// The file of a picture that was kept: "SET/CAPTURE". Absent when there is none.
  std::optional<std::string> picture(std::string_view path) const;

private:
  void work(std::string_view what, std::function<void(Laboratory&)> change);
  void question();
  bool askedForMore(const std::string& verb, const nlohmann::json& request);

  Tell tell_;
  std::atomic<bool> isFitted_ = false;
  std::map<std::string, std::filesystem::path> images_; // "SET/CAPTURE"
  std::shared_ptr<Laboratory> laboratory_;              // of the worker's thread
  std::atomic<bool> cancelled_ = false;
  std::atomic<int> questions_ = 0; // that wait
  mutable std::mutex mutex_;
  std::map<std::string, std::string> made_; // files by name
  JobQueue jobs_;
};

/// The desk that captures lie on, and those before it: captures are opened by a thread of their own, for reading and
/// looking for corners takes long and robots must be reached meanwhile. Used on the panel's thread only.
class Desks {
public:
  using Later = std::function<void(std::function<void()>)>; // to the panel's thread, from any other
  using All = std::function<void(const Message& message)>;  // to every panel
  Desks(Later later, All all) : later_{std::move(later)}, all_{std::move(all)} {}

  /// Puts captures on the desk, in place of those that lie there. Throws InputError for what the robot cannot have
  /// made.
  void put(OpenedSets opened);
  /// Opens captures and puts them there, later; says in a sentence why not.
  void open(const std::vector<std::string>& paths, std::function<void(const std::string& problem)> refused);

  /// nullptr: nothing was put there yet.
  LabDesk* desk() const { return desk_.get(); }
  /// What a panel that comes must know, in the order in which it was told.
  const std::vector<std::pair<std::string, Message>>& latest() const { return latest_; }

private:
  void remember(const std::string& kind, const Message& told);
  void tellWork(const char* what);

  Later later_;
  All all_;
  std::size_t number_ = 0;                              // of the desk
  std::vector<std::pair<std::string, Message>> latest_; // what it told last, by kind
  std::unique_ptr<LabDesk> desk_;
  JobQueue leaving_, opening_; // last: they end first
};

} // namespace naocal
