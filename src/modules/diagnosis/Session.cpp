#include "diagnosis/Session.hpp"

#include "io/FileVersion.hpp"
#include "io/Files.hpp"
#include "io/InputError.hpp"
#include "io/JsonReader.hpp"
#include "io/JsonWriter.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace naocal {

namespace {

using Json = nlohmann::json;

constexpr Range pixels{0, 1e9, "px"}, chance{0, 1, ""};

Json revisionJson(const ModelRevision& rung) {
  Json json{{"with", rung.with}, {"without", rung.without},   {"define", Json::parse(rung.definitions)},
            {"step", rung.step}, {"from", orNull(rung.from)}, {"rmsPx", rung.rmsPx}};
  if (rung.questioned) {
    json["heldOutPx"] = orNull(rung.questioned->heldOutPx);
    json["noiseFloorPx"] = rung.questioned->noiseFloorPx;
    json["alarm"] = rung.questioned->alarm;
  }
  return json;
}

bool isKnown(const std::optional<JsonCursor>& place) {
  return place && !place->value().is_null();
}

/// `before`: number of preceding revisions.
ModelRevision readRevision(const JsonCursor& place, int before) {
  const std::optional<JsonCursor> without = place.find("without");
  ModelRevision rung{.with = place.at("with").texts(),
                     .without = without ? without->texts() : std::vector<std::string>{}};
  if (const auto define = place.find("define")) {
    define->elements(); // a list; its elements are checked later, against the robot description
    rung.definitions = define->value().dump();
  }
  if (const auto step = place.find("step"); step && step->value() != "") {
    rung.step = step->text();
  }
  if (const auto from = place.find("from"); isKnown(from)) {
    rung.from = static_cast<std::size_t>(from->integer(0, before - 1));
  }
  rung.rmsPx = place.at("rmsPx").number(pixels);
  if (const auto floor = place.find("noiseFloorPx"); isKnown(floor)) {
    SelectionStep step{.rmsPx = rung.rmsPx, .noiseFloorPx = floor->number(pixels)};
    step.alarm = place.at("alarm").number(chance);
    if (const auto heldOut = place.find("heldOutPx"); isKnown(heldOut)) {
      step.heldOutPx = heldOut->number(pixels);
    }
    rung.questioned = std::move(step);
  }
  return rung;
}

bool contains(const std::vector<std::string>& labels, const std::string& label) {
  return std::find(labels.begin(), labels.end(), label) != labels.end();
}

} // namespace

std::vector<std::string> termLabels(const Model& model) {
  std::vector<std::string> labels;
  for (const Term& term : model.terms()) {
    if (!term.isPlacement && term.requested) {
      labels.push_back(term.label());
    }
  }
  return labels;
}

void Session::add(const std::vector<std::string>& labels, const Terms& terms) {
  ModelRevision changed = current();
  for (const std::string& label : labels) {
    if (std::erase(changed.without, label) == 0) {
      if (contains(changed.with, label) || contains(terms(), label)) {
        throw InputError{fmt::format("{} is in the model already", label)};
      }
      changed.with.push_back(label);
    }
  }
  revise(std::move(changed), fmt::format("+ {}", fmt::join(labels, ", ")));
}

void Session::drop(const std::string& label, const Terms& terms) {
  ModelRevision changed = current();
  if (std::erase(changed.with, label) == 0) {
    if (!contains(terms(), label)) {
      throw InputError{fmt::format("{} is not in the model; it has {}", label,
                                   changed.with.empty() ? "no more than the base"
                                                        : fmt::format("{}", fmt::join(changed.with, ", ")))};
    }
    changed.without.push_back(label);
  }
  revise(std::move(changed), "− " + label);
}

void Session::revise(ModelRevision changed, const std::string& step) {
  changed.step = step;
  changed.from = at;
  changed.questioned.reset();
  at = ladder.size();
  ladder.push_back(std::move(changed));
}

void Session::undo() {
  const std::optional<std::size_t> before = current().from;
  if (!before) {
    throw InputError{"there is nothing to undo"};
  }
  at = *before;
}

void Session::redo() {
  for (std::size_t i = ladder.size(); i-- > 0;) {
    if (ladder[i].from == at) {
      at = i;
      return;
    }
  }
  throw InputError{"there is nothing to redo"};
}

void Session::goTo(std::size_t number) {
  if (number >= ladder.size()) {
    throw InputError{"there is no such step in the history"};
  }
  at = number;
}

nlohmann::json sessionJson(const Session& session) {
  Json ladder = Json::array();
  for (const ModelRevision& rung : session.ladder) {
    ladder.push_back(revisionJson(rung));
  }
  return withFormat("naocal-session", {{"sets", session.inputs.sets},
                                       {"sha256", session.inputs.sha256},
                                       {"ladder", std::move(ladder)},
                                       {"at", session.at}});
}

Session readSession(const std::filesystem::path& file) {
  const Json document = parseJson(readFile(file), file.string());
  const JsonCursor all{document, file.string()};
  requireFormat(all, "naocal-session");
  Session session{.inputs = {all.at("sets").texts(), all.at("sha256").texts()}};
  for (const JsonCursor& rung : all.at("ladder").elements()) {
    session.ladder.push_back(readRevision(rung, static_cast<int>(session.ladder.size())));
  }
  if (session.ladder.empty()) {
    all.at("ladder").refuse("at least the model to begin with");
  }
  session.at = static_cast<std::size_t>(all.at("at").integer(0, static_cast<int>(session.ladder.size()) - 1));
  return session;
}

void requireSameCaptures(const Session& session, const ResultSources& inputs, const std::filesystem::path& file) {
  if (session.inputs.sha256 != inputs.sha256) {
    throw InputError{fmt::format("{}: expected a session of these captures ({}), found one of others ({}, or they were "
                                 "changed since); name another file, or open the captures without it",
                                 file.string(), fmt::join(inputs.sets, ", "), fmt::join(session.inputs.sets, ", "))};
  }
}

} // namespace naocal
