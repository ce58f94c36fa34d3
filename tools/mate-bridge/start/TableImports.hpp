#pragma once

#include "start/DroppedTable.hpp"

#include "math/Worker.hpp"

#include <boost/asio/io_context.hpp>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace naocal {

/// The tables that panels import, one per panel: from the drop to the opened set. Reading and writing have a thread of
/// their own, because pictures are large and robots must stay reachable. Used on the context's thread.
class TableImports {
public:
  struct Calls {
    std::function<void(std::size_t panel, const std::string& json)> tell;
    /// Opens a written set; then calls `opened`, or `refused` with the reason.
    std::function<void(const DroppedTable::Written& written, std::function<void(const std::string& why)> refused,
                       std::function<void()> opened)>
        open;
  };
  TableImports(boost::asio::io_context& context, Calls calls) : context_{context}, calls_{std::move(calls)} {}

  /// Whether a panel imports a table, and the size of its files.
  bool has(std::size_t panel) const { return imports_.contains(panel); }
  DroppedFiles::Amount amount(std::size_t panel) const;

  /// Begins a panel's import, or adds files to it. Every change is answered with the new state:
  /// {"kind": "import", "table": as DroppedTable::state and {"busy"}}.
  void add(std::size_t panel, std::unique_ptr<DroppedFiles> files);
  /// These throw InputError if the panel imports nothing. What is refused later stands in the state's "problem".
  void choose(std::size_t panel, std::map<std::string, std::string> choices);
  void assign(std::size_t panel, const std::string& column, const std::string& meaning, const std::string& unit);
  void setColumns(std::size_t panel, const std::string& text);
  /// Writes the set and has it opened; then the import ends: {"kind": "import", "table": null, "sentence"}. If either
  /// is refused, it stays, and nothing is left of the set.
  void write(std::size_t panel);
  /// Ends a panel's import, if there is one.
  void end(std::size_t panel) { imports_.erase(panel); }

private:
  struct Import {
    std::shared_ptr<DroppedTable> table = std::make_shared<DroppedTable>(); // used by the worker's tasks only
    DroppedFiles::Amount amount;
    bool isBusy = false; // writes or opens
  };
  using Task = std::function<void(DroppedTable& table)>;

  Import& at(std::size_t panel);
  bool isCurrent(std::size_t panel, const std::shared_ptr<DroppedTable>& table) const;
  void change(std::size_t panel, Task task);
  void onWritten(std::size_t panel, const std::shared_ptr<DroppedTable>& table, const DroppedTable::Written& written);
  void onRefused(std::size_t panel, const std::shared_ptr<DroppedTable>& table, const std::string& problem);

  boost::asio::io_context& context_;
  Calls calls_;
  std::map<std::size_t, Import> imports_;     // by panel
  Worker worker_{Worker::AtEnd::presentTask}; // last: its tasks post to the context
};

} // namespace naocal
