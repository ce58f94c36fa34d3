#pragma once

#include "data/Capture.hpp"
#include "io/JsonReader.hpp"
#include "io/Refusals.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

/// What the readers of a capture set's parts share. (Heavy: include in .cpp files only.)

namespace naocal {

/// A capture set while it is read. Where refusals are collected, it also knows the ids of what was refused, so that
/// what refers to it is not refused as well.
struct SetReading {
  CaptureSet& set;
  Refusals& refusals;
  std::set<std::string> refusedCameras = {}, refusedBoards = {}, refusedTrackers = {}, refusedMarkers = {},
                        refusedFrames = {}, refusedPlaces = {};
  std::set<int> refusedStances = {};
  bool knowsJoints = true, knowsCameras = true, knowsBoards = true, knowsStances = true; // the lists themselves
};

/// Refuses a name that is neither the id of an entry nor that of a refused one. `list`: key of the entries.
template <typename Entry>
void requireEntry(const JsonCursor& place, const std::vector<Entry>& entries, const std::set<std::string>& refused,
                  const char* list) {
  const std::string id = place.text();
  const bool isKnown = std::any_of(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.id == id; });
  if (!isKnown && !refused.contains(id)) {
    place.refuse(std::string{"the id of one of the set's `"} + list + "`");
  }
}

/// Reads a list of entries with distinct ids. Where refusals are collected, `refused` receives the ids of the refused.
template <typename Entry, typename Id, typename Read>
std::vector<Entry> readEntries(const JsonCursor& place, const Read& read, Refusals& refusals, std::set<Id>& refused) {
  std::vector<Entry> entries;
  std::set<Id> ids;
  for (const JsonCursor& element : place.elements()) {
    const bool isRead = refusals.attempt([&] {
      Entry entry = read(element);
      if (!ids.insert(entry.id).second) {
        element.at("id").refuse("an id that no other entry of the list has");
      }
      entries.push_back(std::move(entry));
    });
    if (!isRead && element.value().is_object() && element.value().contains("id")) {
      const nlohmann::json& id = element.value()["id"];
      if constexpr (std::is_same_v<Id, int>) {
        refused.insert(id.is_number_integer() ? id.template get<int>() : 0);
      } else if (id.is_string()) {
        refused.insert(id.template get<Id>());
      }
    }
  }
  return entries;
}

} // namespace naocal
