#include "start/TableImports.hpp"

#include "io/InputError.hpp"
#include "protocol/BoundedJson.hpp"

#include <boost/asio/post.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

/// Runs a task with a table; why it was refused, empty if it was not.
template <class Task> std::string refusalOf(const DroppedTable& table, Task&& task) {
  try {
    task();
    return "";
  } catch (const std::exception& error) {
    return withoutFolder(error.what(), table.folder());
  }
}

} // namespace

TableImports::Import& TableImports::at(std::size_t panel) {
  const auto found = imports_.find(panel);
  if (found == imports_.end()) {
    throw InputError{"import: expected a dropped table or URDF, found none; drop it again"};
  }
  return found->second;
}

bool TableImports::isCurrent(std::size_t panel, const std::shared_ptr<DroppedTable>& table) const {
  const auto found = imports_.find(panel);
  return found != imports_.end() && found->second.table == table;
}

DroppedFiles::Amount TableImports::amount(std::size_t panel) const {
  const auto found = imports_.find(panel);
  return found == imports_.end() ? DroppedFiles::Amount{} : found->second.amount;
}

void TableImports::add(std::size_t panel, std::unique_ptr<DroppedFiles> files) {
  Import& import = imports_[panel];
  const DroppedFiles::Amount further = files->amount();
  import.amount.files += further.files;
  import.amount.bytes += further.bytes;
  change(panel, [files = std::shared_ptr<DroppedFiles>{std::move(files)}](DroppedTable& table) { table.add(files); });
}

void TableImports::choose(std::size_t panel, std::map<std::string, std::string> choices) {
  change(panel, [choices = std::move(choices)](DroppedTable& table) { table.choose(choices); });
}

void TableImports::assign(std::size_t panel, const std::string& column, const std::string& meaning,
                          const std::string& unit) {
  change(panel, [=](DroppedTable& table) { table.assign(column, meaning, unit); });
}

void TableImports::setColumns(std::size_t panel, const std::string& text) {
  change(panel, [text](DroppedTable& table) { table.setColumns(text); });
}

/// Changes a table on the worker's thread, and tells its new state.
void TableImports::change(std::size_t panel, Task task) {
  worker_.enqueue([this, panel, table = at(panel).table, task = std::move(task)] {
    const std::string problem = refusalOf(*table, [&] { task(*table); });
    Json state;
    const std::string failure = refusalOf(*table, [&] { state = table->state(); });
    if (!problem.empty() || !failure.empty()) {
      state["problem"] = problem.empty() ? failure : problem;
    }
    boost::asio::post(context_, [this, panel, table, state = std::move(state)]() mutable {
      if (isCurrent(panel, table)) { // else it was ended meanwhile
        state["busy"] = at(panel).isBusy;
        calls_.tell(panel, jsonText({{"kind", "import"}, {"table", state}}));
      }
    });
  });
}

void TableImports::write(std::size_t panel) {
  Import& import = at(panel);
  if (import.isBusy) {
    return;
  }
  import.isBusy = true;
  change(panel, [](DroppedTable&) {}); // tells that it is busy
  worker_.enqueue([this, panel, table = import.table] {
    DroppedTable::Written written;
    const std::string problem = refusalOf(*table, [&] { written = table->write(); });
    boost::asio::post(context_, [this, panel, table, problem, written = std::move(written)] {
      problem.empty() ? onWritten(panel, table, written) : onRefused(panel, table, problem);
    });
  });
}

/// Has a written set opened.
void TableImports::onWritten(std::size_t panel, const std::shared_ptr<DroppedTable>& table,
                             const DroppedTable::Written& written) {
  if (!isCurrent(panel, table)) {
    return written.remove();
  }
  calls_.open(
      written,
      [this, panel, table, written](const std::string& why) {
        written.remove();
        onRefused(panel, table, written.temporary ? withoutFolder(why, written.temporary->path()) : why);
      },
      [this, panel, table, sentences = written.sentences] {
        if (isCurrent(panel, table)) {
          imports_.erase(panel);
          calls_.tell(panel, jsonText({{"kind", "import"},
                                       {"table", nullptr},
                                       {"sentence", fmt::format("{}", fmt::join(sentences, "; "))}}));
        }
      });
}

void TableImports::onRefused(std::size_t panel, const std::shared_ptr<DroppedTable>& table,
                             const std::string& problem) {
  if (isCurrent(panel, table)) {
    at(panel).isBusy = false;
    change(panel, [problem](DroppedTable&) { throw InputError{problem}; });
  }
}

} // namespace naocal
