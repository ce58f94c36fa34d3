#pragma once

#include "JobQueue.hpp"
#include "LabDesk.hpp"
#include "Server.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace naocal {

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
