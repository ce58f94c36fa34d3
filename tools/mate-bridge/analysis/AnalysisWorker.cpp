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

constexpr std::string_view fitting = "fitting";

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
  testCandidates();
}

AnalysisWorker::~AnalysisWorker() {
  cancelled_ = true; // speeds up the end of the thread
}

void AnalysisWorker::work(std::string_view what, std::function<void(AnalysisSession&)> task) {
  thread_.enqueue([this, what, task = std::move(task)] {
    tell_("work", jsonText({{"kind", "work"}, {"what", what}}));
    try {
      task(*session_);
    } catch (const std::exception& error) { // any failure, such as a full disk, must not end the bridge
      tell_("refused", jsonText({{"kind", "refused"}, {"sentence", error.what()}}));
      if (!isFitted_ && what == fitting) {
        tell_("unfitted", jsonText({{"kind", "unfitted"}, {"sentence", error.what()}}));
      }
    }
    tell_("work", jsonText({{"kind", "work"}, {"what", nullptr}}));
  });
}

void AnalysisWorker::testCandidates() {
  ++questions_;
  work("testing causes", [this](AnalysisSession& session) {
    if (--questions_ == 0 && isFitted_) { // otherwise the model has changed since: only the last test runs
      session.testCandidates();
    }
  });
}

void AnalysisWorker::change(std::function<void(AnalysisSession&)> change) {
  work(fitting, std::move(change));
  testCandidates();
}

void AnalysisWorker::add(const std::string& label) {
  change([label](AnalysisSession& session) { session.add(label); });
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

void AnalysisWorker::searchMissing() {
  cancelled_ = false;
  work("searching", [this](AnalysisSession& session) { session.searchMissing([this] { return !cancelled_; }); });
}

void AnalysisWorker::cancelSearch() {
  cancelled_ = true;
}

void AnalysisWorker::proposePoses(int count) {
  const std::size_t bounded = std::clamp(count, 1, 20);
  work("choosing poses", [bounded](AnalysisSession& session) { session.proposePoses(bounded); });
}

void AnalysisWorker::compareWith(const std::vector<std::string>& paths) {
  work("comparing", [paths](AnalysisSession& session) { session.compareWith(openDataset(paths)); });
}

void AnalysisWorker::generateFile(const std::string& name) {
  work("writing", [this, name](AnalysisSession& session) {
    std::string content = session.generateFile(name);
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
  constexpr std::array<std::string_view, 4> ofFit{"questions", "next", "compared", "unfitted"};
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
