#include "start/StartPage.hpp"

#include "io/FileVersion.hpp"
#include "io/InputError.hpp"
#include "print/Paper.hpp"
#include "protocol/BoundedJson.hpp"
#include "start/DroppedKinds.hpp"
#include "start/PrintableBoards.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <optional>

namespace naocal {

namespace {

using Json = nlohmann::json;

constexpr std::size_t mostDropped = 2; // the present dataset and the one before it, which may still be read

/// The place of a path without a "/" at its end.
std::filesystem::path placeOf(const std::string& path) {
  const std::filesystem::path place{path};
  return place.has_filename() ? place : place.parent_path();
}

} // namespace

StartPage::StartPage(boost::asio::io_context& context, const std::filesystem::path& recentFiles, Calls calls)
    : calls_{std::move(calls)}, recent_{recentFiles}, sample_{context,
                                                              [this](const std::string& folder) {
                                                                calls_.open({folder}, {}, [] {});
                                                              },
                                                              [this] { changed(); }},
      robot_{context,
             {[this](const std::string& address) { calls_.connect(address); },
              [this](const std::string& address) { calls_.disconnect(address); }, [this] { changed(); }}},
      search_{context, [this] { changed(); }},
      imports_{context,
               {[this](std::size_t panel, const std::string& json) { calls_.one(panel, json); },
                [this](const DroppedTable::Written& written, std::function<void(const std::string& why)> refused,
                       std::function<void()> done) {
                  const std::vector<std::string> paths{written.set.string()};
                  calls_.open(paths, std::move(refused),
                              [this, paths, temporary = written.temporary, done = std::move(done)] {
                                temporary ? keep(temporary) : opened(paths);
                                done();
                              });
                }}} {}

void StartPage::opened(const std::vector<std::string>& paths) {
  recent_.add(paths);
  changed();
}

void StartPage::forget(const std::vector<std::string>& paths) {
  recent_.forget(paths);
  changed();
}

void StartPage::findRobots(const std::vector<std::string>& addresses) {
  if (addresses.size() > RecentFiles::mostRobots) {
    throw InputError{
        fmt::format("expected at most {} robots' addresses, found {}", RecentFiles::mostRobots, addresses.size())};
  }
  search_.search(addresses);
  recent_.setRobots(addresses);
  changed();
}

void StartPage::beginUpload(std::size_t panel, const Json& files) {
  uploads_.erase(panel);
  uploads_[panel] = std::make_unique<DroppedFiles>(files, imports_.amount(panel));
}

Json StartPage::addUpload(std::size_t panel, std::string_view part) {
  const auto found = uploads_.find(panel);
  if (found == uploads_.end()) {
    throw InputError{"expected files to be announced before their contents, found none; drop them again"};
  }
  try {
    found->second->append(part);
    const Json told{{"bytes", found->second->received()}, {"complete", found->second->isComplete()}};
    if (found->second->isComplete()) {
      finishUpload(panel);
    }
    return told;
  } catch (...) {
    uploads_.erase(panel);
    throw;
  }
}

void StartPage::finishUpload(std::size_t panel) {
  std::unique_ptr<DroppedFiles> files = std::move(uploads_.at(panel));
  uploads_.erase(panel);
  const bool isOfImport = files->holdsImport() || (imports_.has(panel) && !files->holdsSet());
  if (isOfImport) {
    return imports_.add(panel, std::move(files));
  }
  imports_.end(panel);
  const std::vector<std::string> paths = files->paths();
  const std::shared_ptr<const DroppedFiles> dropped = std::move(files); // goes if opening is refused
  calls_.open(paths, {}, [this, dropped] { keep(dropped); });
}

/// Keeps the folder of a dataset that was opened, and that of the one before it.
void StartPage::keep(std::shared_ptr<const void> files) {
  dropped_.push_back(std::move(files));
  if (dropped_.size() > mostDropped) {
    dropped_.pop_front();
  }
}

void StartPage::removePanel(std::size_t panel) {
  uploads_.erase(panel);
  imports_.end(panel);
}

std::optional<std::string> StartPage::boards(std::string_view name) {
  for (const Paper& paper : papers) {
    if (name == fmt::format("boards-{}.pdf", paper.name)) {
      return printableBoards(paper.name);
    }
  }
  return std::nullopt;
}

std::string StartPage::message() const {
  Json recent = Json::array();
  for (const RecentFile& entry : recent_.files()) {
    const std::string& first = entry.paths.front();
    if (!kinds_.contains(first)) {
      kinds_[first] = kindOfDataset(first);
    }
    recent.push_back({{"paths", entry.paths},
                      {"name", placeOf(first).filename().string()},
                      {"folder", placeOf(first).parent_path().string()},
                      {"what", kinds_[first]},
                      {"opened", entry.opened}});
  }
  return jsonText({{"kind", "start"},
                   {"program", thisProgram},
                   {"recent", recent},
                   {"problem", recent_.problem()},
                   {"robots", recent_.robots()},
                   {"search", search_.state()},
                   {"sample", sample_.state()},
                   {"robot", robot_.state()},
                   {"drop", droppedFilesState()}});
}

} // namespace naocal
