#include "analysis/AnalysisWorker.hpp"

#include "analysis/AnalysisSession.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "protocol/BoundedJson.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string_view>

namespace naocal {

namespace {

using Json = nlohmann::json;

constexpr std::string_view fitting = "fitting", searching = "searching for what is missing";

/// The sets' image files by "SET/CAPTURE"; only files inside the sets' folders, whatever captures.json names.
std::map<std::string, std::filesystem::path> imagesOf(const Dataset& opened) {
  std::map<std::string, std::filesystem::path> images;
  for (const CaptureSet& set : opened.sets) {
    for (const Capture& capture : set.captures) {
      if (const auto file = fileInside(opened.folders.at(set.name), capture.image)) {
        images[fmt::format("{}/{}", set.name, capture.id)] = *file;
      }
    }
  }
  return images;
}

} // namespace

AnalysisWorker::AnalysisWorker(Dataset opened, MessageSink tell)
    : tell_{std::move(tell)}, images_{imagesOf(opened)}, session_{std::make_shared<AnalysisSession>(
                                                             std::move(opened),
                                                             [this](const std::string& kind, const Json& content) {
                                                               isFitted_ = isFitted_ || kind == "fit";
                                                               Json message = content;
                                                               message["kind"] = kind;
                                                               tell_(kind, jsonText(message));
                                                             })} {
  work(fitting, [](AnalysisSession& session) { session.fit(); });
  search();
}

AnalysisWorker::~AnalysisWorker() {
  ++changes_; // speeds up the end of the thread
}

void AnalysisWorker::tellWork(std::string_view what) {
  tell_("work", jsonText({{"kind", "work"}, {"what", what.empty() ? Json(nullptr) : Json(what)}}));
}

void AnalysisWorker::work(std::string_view what, std::function<void(AnalysisSession&)> task) {
  thread_.enqueue([this, what, task = std::move(task)] {
    tellWork(what);
    try {
      task(*session_);
    } catch (const SearchEnded&) {          // the model has changed
    } catch (const std::exception& error) { // any failure, such as a full disk, must not end the bridge
      tell_("refused", jsonText({{"kind", "refused"}, {"sentence", error.what()}}));
      if (!isFitted_ && what == fitting) {
        tell_("unfitted", jsonText({{"kind", "unfitted"}, {"sentence", error.what()}}));
      }
      if (what == searching) {
        tell_("unsearched", jsonText({{"kind", "unsearched"}, {"sentence", error.what()}}));
      }
    }
    tellWork("");
  });
}

std::function<bool(std::size_t)> AnalysisWorker::whileUnchanged() {
  return [this, model = changes_.load(), most = std::size_t{0}](std::size_t found) mutable {
    if (found > most) {
      most = found;
      tellWork(fmt::format("{}, {} {} found so far", searching, found, found == 1 ? "effect" : "effects"));
    }
    return changes_ == model;
  };
}

void AnalysisWorker::search() {
  work(searching, [this, goesOn = whileUnchanged()](AnalysisSession& session) {
    if (isFitted_ && goesOn(0)) {
      session.search(goesOn);
    }
  });
}

void AnalysisWorker::change(std::function<void(AnalysisSession&)> change) {
  ++changes_; // ends the search of the model before
  work(fitting, std::move(change));
  search();
}

void AnalysisWorker::add(const std::vector<std::string>& labels) {
  change([labels](AnalysisSession& session) { session.add(labels); });
}

void AnalysisWorker::drop(const std::string& label) {
  change([label](AnalysisSession& session) { session.drop(label); });
}

void AnalysisWorker::goTo(std::size_t number) {
  change([number](AnalysisSession& session) { session.goTo(number); });
}

void AnalysisWorker::defineEffect(const Json& effect) {
  change([effect](AnalysisSession& session) { session.defineEffect(effect); });
}

void AnalysisWorker::proposePoses(int count) {
  const std::size_t bounded = std::clamp(count, 1, 20);
  work("choosing poses",
       [bounded, goesOn = whileUnchanged()](AnalysisSession& session) { session.proposePoses(bounded, goesOn); });
}

void AnalysisWorker::compareWith(const std::vector<std::string>& paths) {
  work("comparing", [paths](AnalysisSession& session) { session.compareWith(openDataset(paths)); });
}

void AnalysisWorker::generateFile(const std::string& name) {
  work("writing", [this, name, goesOn = whileUnchanged()](AnalysisSession& session) {
    std::string content = session.generateFile(name, goesOn);
    {
      const std::lock_guard lock{mutex_};
      made_[name] = std::move(content);
    }
    tell_("made", jsonText({{"kind", "made"}, {"file", name}}));
  });
}

std::optional<std::string> AnalysisWorker::generatedFile(const std::string& name) const {
  const std::lock_guard lock{mutex_};
  const auto found = made_.find(name);
  return found == made_.end() ? std::nullopt : std::optional{found->second};
}

Json AnalysisWorker::checkEffect(const Json& effect) const {
  return session_->checkEffect(effect);
}

std::optional<std::string> AnalysisWorker::picture(std::string_view path) const {
  const auto found = images_.find(std::string{path});
  try {
    return found == images_.end() ? std::nullopt : std::optional{readFile(found->second)};
  } catch (const InputError&) { // the file was removed
    return std::nullopt;
  }
}

void AnalysisSlot::setDataset(Dataset opened) {
  const std::size_t number = number_ + 1;
  const std::vector<std::string> moved = opened.moved;
  auto fresh =
      std::make_unique<AnalysisWorker>(std::move(opened), [this, number](const std::string& kind, std::string json) {
        later_([this, number, kind, told = makeMessage(std::move(json))] {
          if (number == number_) { // otherwise other captures were opened meanwhile
            remember(kind, told);
            all_(told);
          }
        });
      });
  number_ = number;
  latest_.clear();
  all_(makeMessage(R"({"kind": "opened"})"));
  for (const std::string& sentence : moved) {
    all_(makeMessage(jsonText({{"kind", "moved"}, {"sentence", sentence}})));
  }
  if (worker_) { // finishes its current task, which may take seconds
    leaving_.enqueue([old = std::shared_ptr<AnalysisWorker>{std::move(worker_)}] {});
  }
  worker_ = std::move(fresh);
}

void AnalysisSlot::open(const std::vector<std::string>& paths, std::function<void(const std::string& problem)> refused,
                        std::function<void()> opened, const std::vector<std::filesystem::path>& lookIn) {
  tellWork("opening captures");
  opening_.enqueue([this, paths, lookIn, refused = std::move(refused), opened = std::move(opened)] {
    std::shared_ptr<Dataset> dataset;
    std::string problem;
    bool isMissing = false;
    try {
      dataset = std::make_shared<Dataset>(openDataset(paths, lookIn));
    } catch (const MissingCaptures& error) {
      problem = error.what();
      isMissing = true;
    } catch (const std::exception& error) {
      problem = error.what();
    }
    later_([this, dataset, problem, isMissing, paths, refused, opened] {
      tellWork(nullptr);
      try {
        if (dataset) {
          setDataset(std::move(*dataset));
          opened();
        } else {
          refused(problem);
        }
      } catch (const std::exception& error) {
        refused(error.what());
      }
      if (isMissing) {
        all_(makeMessage(jsonText({{"kind", "missing"}, {"sentence", problem}, {"paths", paths}})));
      }
    });
  });
}

/// Keeps a message for new panels; a new fit discards messages about the previous one.
void AnalysisSlot::remember(const std::string& kind, const Message& told) {
  constexpr std::array<std::string_view, 5> ofFit{"diagnosis", "unsearched", "next", "compared", "unfitted"};
  if (kind == "refused" || kind == "made") {
    return;
  }
  std::erase_if(latest_, [&](const auto& before) {
    return before.first == kind ||
           (kind == "fit" && std::find(ofFit.begin(), ofFit.end(), before.first) != ofFit.end());
  });
  latest_.emplace_back(kind, told);
}

void AnalysisSlot::tellWork(const char* what) {
  const nlohmann::json work{{"kind", "work"}, {"what", what ? nlohmann::json(what) : nlohmann::json()}};
  all_(makeMessage(work.dump()));
}

} // namespace naocal
