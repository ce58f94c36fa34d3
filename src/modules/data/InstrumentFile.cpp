#include "data/InstrumentFile.hpp"

#include "data/BoardFile.hpp"
#include "io/JsonWriter.hpp"

#include <cmath>
#include <fmt/format.h>

namespace naocal {

namespace {

using nlohmann::json;
using Written = nlohmann::ordered_json;

constexpr double quaternionTolerance = 1e-3; // of its norm: logs round to few digits

Eigen::Vector3d readPoint(const JsonCursor& place) {
  const auto xyz = place.numbers(3, lengthRange, "x, y, z");
  return {xyz[0], xyz[1], xyz[2]};
}

std::optional<double> findNumber(const JsonCursor& place, const char* key, const Range& range) {
  const auto given = place.find(key);
  return given ? std::optional{given->number(range)} : std::nullopt;
}

void readTrackers(const JsonCursor& place, SetReading& reading) {
  for (const auto& [id, entry] : place.members()) {
    const bool isRead = reading.refusals.attempt([&, &id = id, &entry = entry] {
      Tracker tracker{.id = id,
                      .sigma = findNumber(entry, "sigma", positiveLengthRange),
                      .sigmaRotation = findNumber(entry, "sigmaRotation", positiveAngleRange),
                      .placement = {}};
      if (const auto placement = entry.find("placement")) {
        tracker.placement = readSparsePlacement(*placement);
      }
      reading.set.instruments.trackers.push_back(std::move(tracker));
    });
    if (!isRead) {
      reading.refusedTrackers.insert(id);
    }
  }
}

TrackedMarker readMarker(const JsonCursor& place) {
  TrackedMarker marker{.id = place.at("id").text(), .link = place.at("link").text(), .point = {}};
  if (const auto point = place.find("point")) {
    marker.point = readPoint(*point);
  }
  if (const auto guess = place.find("pointGuess")) {
    marker.pointGuess = readPoint(*guess);
  }
  marker.pointSigma = findNumber(place, "pointSigma", positiveLengthRange).value_or(marker.pointSigma);
  return marker;
}

TrackedFrame readFrame(const JsonCursor& place) {
  TrackedFrame frame{.id = place.at("id").text(), .link = place.at("link").text(), .placement = {}};
  if (const auto placement = place.find("placement")) {
    frame.placement = readSparsePlacement(*placement);
  }
  return frame;
}

ContactPlace readPlace(const JsonCursor& place) {
  ContactPlace result{.id = place.at("id").text(), .point = {}};
  if (const auto point = place.find("point")) {
    result.point = readPoint(*point);
  }
  return result;
}

PlaceDistance readDistance(const JsonCursor& place, const SetReading& reading) {
  const auto ends = place.at("between").elements();
  if (ends.size() != 2 || ends[0].value() == ends[1].value()) {
    place.at("between").refuse("the ids of two places");
  }
  PlaceDistance distance;
  for (std::size_t end = 0; end < 2; ++end) {
    requireEntry(ends[end], reading.set.instruments.places, reading.refusedPlaces, "places");
    distance.between[end] = ends[end].text();
  }
  distance.metres = place.at("metres").number(positiveLengthRange);
  distance.sigma = place.at("sigma").number({1e-9, 1000, "m"});
  return distance;
}

PointReading readPointReading(const JsonCursor& place, const SetReading& reading) {
  const Instruments& known = reading.set.instruments;
  requireEntry(place.at("tracker"), known.trackers, reading.refusedTrackers, "trackers");
  requireEntry(place.at("marker"), known.markers, reading.refusedMarkers, "markers");
  return {place.at("tracker").text(), place.at("marker").text(), readPoint(place.at("xyz"))};
}

FrameReading readFrameReading(const JsonCursor& place, const SetReading& reading) {
  const Instruments& known = reading.set.instruments;
  requireEntry(place.at("tracker"), known.trackers, reading.refusedTrackers, "trackers");
  requireEntry(place.at("frame"), known.frames, reading.refusedFrames, "frames");
  const auto wxyz = place.at("quaternion").numbers(4, {-2, 2, ""}, "w, x, y, z");
  const Eigen::Quaterniond rotation{wxyz[0], wxyz[1], wxyz[2], wxyz[3]};
  if (!(std::abs(rotation.norm() - 1) < quaternionTolerance)) {
    place.at("quaternion")
        .refuse("four numbers w, x, y, z whose squares add up to 1", fmt::format("a norm of {:.4g}", rotation.norm()));
  }
  return {place.at("tracker").text(), place.at("frame").text(), readPoint(place.at("xyz")), rotation};
}

ContactReading readContactReading(const JsonCursor& place, const SetReading& reading) {
  const Instruments& known = reading.set.instruments;
  requireEntry(place.at("marker"), known.markers, reading.refusedMarkers, "markers");
  requireEntry(place.at("place"), known.places, reading.refusedPlaces, "places");
  return {place.at("marker").text(), place.at("place").text()};
}

/// Reads a list under a key, if it is there, entry by entry.
template <typename Entry, typename Read>
void readReadings(const JsonCursor& place, const char* key, const Read& read, SetReading& reading,
                  std::vector<Entry>& entries) {
  const auto list = place.find(key);
  if (!list) {
    return;
  }
  reading.refusals.attempt([&] {
    for (const JsonCursor& entry : list->elements()) {
      reading.refusals.attempt([&] { entries.push_back(read(entry, reading)); });
    }
  });
}

Written pointJson(const Eigen::Vector3d& point) {
  return {point.x(), point.y(), point.z()};
}

Written placementOrNull(const std::optional<Placement>& placement, const json& read) {
  return placement ? toJson(*placement, false, childOrNull(read, "placement")) : Written();
}

/// A list of entries as JSON; null if there are none.
template <typename Entry, typename Format>
Written listJson(const std::vector<Entry>& entries, const char* key, const json& read, const Format& format) {
  if (entries.empty()) {
    return {};
  }
  Written list = Written::array();
  const json& before = childOrNull(read, key);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if constexpr (requires { entries[i].id; }) {
      list.push_back(format(entries[i], entryOrNull("id", entries[i].id, before)));
    } else {
      static const json none;
      list.push_back(format(entries[i], before.is_array() && i < before.size() ? before[i] : none));
    }
  }
  return list;
}

} // namespace

void readInstruments(const JsonCursor& top, SetReading& reading) {
  Instruments& instruments = reading.set.instruments;
  Refusals& refusals = reading.refusals;
  if (const auto trackers = top.find("trackers")) {
    refusals.attempt([&] { readTrackers(*trackers, reading); });
  }
  const auto readList = [&](const char* key, auto& entries, auto read, std::set<std::string>& refused) {
    using Entry = typename std::decay_t<decltype(entries)>::value_type;
    if (const auto list = top.find(key)) {
      refusals.attempt([&] { entries = readEntries<Entry>(*list, read, refusals, refused); });
    }
  };
  readList("markers", instruments.markers, readMarker, reading.refusedMarkers);
  readList("frames", instruments.frames, readFrame, reading.refusedFrames);
  readList("places", instruments.places, readPlace, reading.refusedPlaces);
  readReadings(top, "distances", readDistance, reading, instruments.distances);
  if (const auto sigma = top.find("contactSigma")) {
    refusals.attempt([&] { instruments.contactSigma = sigma->number(positiveLengthRange); });
  }
}

void readInstrumentReadings(const JsonCursor& place, SetReading& reading, Capture& capture) {
  readReadings(place, "points", readPointReading, reading, capture.points);
  readReadings(place, "frames", readFrameReading, reading, capture.frames);
  readReadings(place, "contacts", readContactReading, reading, capture.contacts);
}

nlohmann::ordered_json instrumentsJson(const Instruments& instruments, const nlohmann::json& read) {
  Written trackers;
  for (const Tracker& tracker : instruments.trackers) {
    const json& before = childOrNull(childOrNull(read, "trackers"), tracker.id);
    trackers[tracker.id] = mergeUnknownKeys({{"sigma", orNull(tracker.sigma)},
                                             {"sigmaRotation", orNull(tracker.sigmaRotation)},
                                             {"placement", placementOrNull(tracker.placement, before)}},
                                            before);
  }
  return {{"trackers", trackers},
          {"markers", listJson(instruments.markers, "markers", read,
                               [](const TrackedMarker& marker, const json& before) {
                                 const bool isGuessed = !marker.point;
                                 return mergeUnknownKeys(
                                     {{"id", marker.id},
                                      {"link", marker.link},
                                      {"point", isGuessed ? Written() : pointJson(*marker.point)},
                                      {"pointGuess", isGuessed ? pointJson(marker.pointGuess) : Written()},
                                      {"pointSigma", isGuessed ? Written(marker.pointSigma) : Written()}},
                                     before);
                               })},
          {"frames", listJson(instruments.frames, "frames", read,
                              [](const TrackedFrame& frame, const json& before) {
                                return mergeUnknownKeys({{"id", frame.id},
                                                         {"link", frame.link},
                                                         {"placement", placementOrNull(frame.placement, before)}},
                                                        before);
                              })},
          {"places", listJson(instruments.places, "places", read,
                              [](const ContactPlace& place, const json& before) {
                                return mergeUnknownKeys(
                                    {{"id", place.id}, {"point", place.point ? pointJson(*place.point) : Written()}},
                                    before);
                              })},
          {"distances", listJson(instruments.distances, "distances", read,
                                 [](const PlaceDistance& distance, const json& before) {
                                   return mergeUnknownKeys({{"between", distance.between},
                                                            {"metres", distance.metres},
                                                            {"sigma", distance.sigma}},
                                                           before);
                                 })},
          {"contactSigma", orNull(instruments.contactSigma)}};
}

nlohmann::ordered_json instrumentReadingsJson(const Capture& capture, const nlohmann::json& read) {
  return {
      {"points", listJson(capture.points, "points", read,
                          [](const PointReading& point, const json& before) {
                            return mergeUnknownKeys(
                                {{"tracker", point.tracker}, {"marker", point.marker}, {"xyz", pointJson(point.xyz)}},
                                before);
                          })},
      {"frames", listJson(capture.frames, "frames", read,
                          [](const FrameReading& frame, const json& before) {
                            const Eigen::Quaterniond& q = frame.rotation;
                            return mergeUnknownKeys({{"tracker", frame.tracker},
                                                     {"frame", frame.frame},
                                                     {"xyz", pointJson(frame.xyz)},
                                                     {"quaternion", Written{q.w(), q.x(), q.y(), q.z()}}},
                                                    before);
                          })},
      {"contacts", listJson(capture.contacts, "contacts", read, [](const ContactReading& contact, const json& before) {
         return mergeUnknownKeys({{"marker", contact.marker}, {"place", contact.place}}, before);
       })}};
}

} // namespace naocal
