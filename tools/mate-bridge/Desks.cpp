#include "Desks.hpp"

#include "Wire.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

namespace naocal {

void Desks::put(OpenedSets opened) {
  const std::size_t number = number_ + 1;
  auto fresh = std::make_unique<LabDesk>(std::move(opened), [this, number](const std::string& kind, std::string json) {
    later_([this, number, kind, told = message(std::move(json))] {
      if (number == number_) { // else the desk was cleared since
        remember(kind, told);
        all_(told);
      }
    });
  });
  number_ = number;
  latest_.clear();
  all_(message(R"({"kind": "opened"})"));
  if (desk_) { // it ends what it is at, which may take seconds
    leaving_.add([old = std::shared_ptr<LabDesk>{std::move(desk_)}] {});
  }
  desk_ = std::move(fresh);
}

void Desks::open(const std::vector<std::string>& paths, std::function<void(const std::string& problem)> refused) {
  tellWork("opening captures");
  opening_.add([this, paths, refused = std::move(refused)] {
    std::shared_ptr<OpenedSets> opened;
    std::string problem;
    try {
      opened = std::make_shared<OpenedSets>(openSets(paths));
    } catch (const std::exception& error) {
      problem = error.what();
    }
    later_([this, opened, problem, refused] {
      tellWork(nullptr);
      try {
        opened ? put(std::move(*opened)) : refused(problem);
      } catch (const std::exception& error) {
        refused(error.what());
      }
    });
  });
}

/// What was said of another fit is not true of a new one.
void Desks::remember(const std::string& kind, const Message& told) {
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

void Desks::tellWork(const char* what) {
  const nlohmann::json work{{"kind", "work"}, {"what", what ? nlohmann::json(what) : nlohmann::json()}};
  all_(message(work.dump()));
}

} // namespace naocal
