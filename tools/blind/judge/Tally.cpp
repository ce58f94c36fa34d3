#include "judge/Tally.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace blind {

namespace {

using nlohmann::json;
using Binomial = boost::math::binomial_distribution<>;

std::string family(const Truth& truth) {
  const std::string& name = truth.effects.front().name;
  return name.substr(0, name.find('@'));
}

void addCatalogue(const Truth& truth, const Marks& marked, Tally& result) {
  if (truth.pictures) {
    result.pictures.add(marked);
    return;
  }
  result.bySize[truth.wanted].add(marked);
  result.cells[{family(truth), truth.wanted, truth.poses, truth.noise}].add(marked);
  constexpr double plain = 19;
  if (truth.effects.front().noncentrality > plain) {
    result.byFamily[family(truth)].add(marked);
  }
}

void addAll(const std::vector<bool>& marks, Share& share) {
  for (const bool mark : marks) {
    share.add(mark);
  }
}

bool isOfCamera(const Truth& truth) {
  const std::string name = family(truth);
  return name == "cameraTranslation" || name == "focalLength" || name == "principalPoint" || name == "radialDistortion";
}

/// How honest calibrations are, where nothing is hidden and where something is.
void addHonesty(const Case& one, const Marks& marked, Tally& result) {
  const Truth& truth = one.truth;
  if (truth.group == "control" || truth.group == "decoy" || truth.group == "jitter") {
    addAll(marked.offsetsInside, result.offsetsSound);
    if (one.answer.first) {
      const std::string regime = truth.pictures ? "pictures" : truth.jitter > 0 ? "jitter" : truth.noise;
      result.pValues[regime].push_back(one.answer.first->pValue);
    }
  }
  if (hidesOne(truth) || truth.group == "pair" || truth.group == "outside") {
    result.wronglyUsable.add(marked.wronglyUsable);
    result.wronglyUsableAfter.add(marked.wronglyUsableAfter);
    addAll(marked.offsetsInside, result.offsetsHidden);
    addAll(marked.offsetsInsideAfter, result.offsetsAfter);
  }
  constexpr double large = 1.5; // plausible sizes
  if (truth.plausible > large && marked.rmsRatio) {
    result.rmsRatios.push_back(*marked.rmsRatio);
  }
  if (hidesOne(truth)) {
    result.extraNamed.add(marked.extraNamed);
    if (isOfCamera(truth)) {
      result.cameraBlamed.add(marked.blamedOnCaptures);
    }
  }
  if (truth.group == "sized") {
    result.byPlausible[truth.plausible].add(marked);
  }
  if (truth.group == "twin") {
    result.twinClass.add(marked.inClass);
  }
}

json shareJson(const Share& share) {
  return {{"sets", share.all}, {"rate", share.rate()}, {"low", share.low()}, {"high", share.high()}};
}

json cellJson(const Cell& cell) {
  return {
      {"sets", cell.detected.all},       {"detected", cell.detected.rate()},   {"expected", cell.expected.value()},
      {"top1", cell.top1.rate()},        {"top3", cell.top3.rate()},           {"class", cell.inClass.rate()},
      {"coverage", cell.covered.rate()}, {"errorFell", cell.errorFell.rate()}, {"nearFloor", cell.nearFloor.rate()}};
}

template <typename Map> json sharesJson(const Map& shares) {
  json result = json::object();
  for (const auto& [name, share] : shares) {
    result[name] = shareJson(share);
  }
  return result;
}

} // namespace

double Share::low() const {
  constexpr double tail = 0.025;
  return all == 0 ? 0 : Binomial::find_lower_bound_on_p(static_cast<double>(all), static_cast<double>(yes), tail);
}

double Share::high() const {
  constexpr double tail = 0.025;
  return all == 0 ? 1 : Binomial::find_upper_bound_on_p(static_cast<double>(all), static_cast<double>(yes), tail);
}

void Cell::add(const Marks& one) {
  detected.add(one.detected);
  top1.add(one.top1);
  top3.add(one.top3);
  inClass.add(one.inClass);
  for (const bool inside : one.covered) {
    covered.add(inside);
  }
  errorFell.add(one.errorFell);
  nearFloor.add(one.nearFloor);
  if (one.expected) {
    expected.add(*one.expected);
  }
}

Tally tally(const std::vector<Case>& cases) {
  Tally result;
  for (const Case& one : cases) {
    const Truth& truth = one.truth;
    const Marks marked = marks(one);
    ++result.sets;
    const bool silent = one.answer.verdict.empty(); // never counts for the better
    result.withoutVerdict += silent;
    result.seconds.add(one.answer.seconds);
    addHonesty(one, marked, result);
    if (truth.group == "control" || truth.group == "catalogue") {
      result.falseUnknown.add(marked.unknownSaid);
    }
    if (truth.group == "control") {
      result.falseAlarms[truth.pictures ? "pictures" : truth.noise].add(marked.alarmed || silent);
    } else if (truth.group == "decoy") {
      result.decoyAlarms.add(marked.alarmed || silent);
    } else if (truth.group == "catalogue") {
      addCatalogue(truth, marked, result);
    } else if (truth.group == "pair") {
      result.bothFound.add(marked.bothFound);
      result.extra.add(*marked.extra);
    } else if (truth.group == "outside") {
      (truth.noise.starts_with("stiction") ? result.unknownSticking : result.unknownClean).add(marked.placeAndDriver);
      result.unknownByKind[truth.kind].add(marked.placeAndDriver);
    } else if (truth.group == "absorbed") {
      result.saidUntestable.add(marked.saidUntestable);
      result.untestableByKind[truth.kind].add(marked.saidUntestable);
    } else if (truth.group == "event" && marked.eventNamed) {
      result.eventNamed[truth.event->what].add(marked.eventNamed);
      result.eventTimed[truth.event->what].add(marked.eventTimed);
    } else if (truth.group == "jitter") {
      result.falseAlarms["jitter"].add(marked.alarmed || silent);
      result.jitterAdequate[truth.kind].add(marked.jitterAdequate);
      result.jitterLevel[truth.kind].add(marked.jitterLevel);
    } else if (truth.group == "corrupted") {
      result.saidCorrupted.add(marked.saidCorrupted);
      result.byCorruption[truth.kind].add(marked.saidCorrupted);
    }
  }
  return result;
}

json evaluationJson(const Tally& tally) {
  json file{{"format", "naocal-effect-evaluation"},
            {"version", 1},
            {"sets", tally.sets},
            {"withoutVerdict", tally.withoutVerdict},
            {"secondsPerDiagnosis", tally.seconds.value()},
            {"falseAlarms", sharesJson(tally.falseAlarms)},
            {"decoyAlarms", shareJson(tally.decoyAlarms)},
            {"falseUnknown", shareJson(tally.falseUnknown)},
            {"bothFound", shareJson(tally.bothFound)},
            {"extraPerPair", tally.extra.value()},
            {"outsideCatalogue", sharesJson(tally.unknownByKind)},
            {"saidUntestable", sharesJson(tally.untestableByKind)},
            {"saidCorrupted", sharesJson(tally.byCorruption)},
            {"eventsNamed", sharesJson(tally.eventNamed)},
            {"eventsTimed", sharesJson(tally.eventTimed)},
            {"byPlausibleSize", json::array()},
            {"bySize", json::array()},
            {"byFamily", json::array()},
            {"pictures", cellJson(tally.pictures)},
            {"cells", json::array()},
            {"required", json::array()}};
  for (const auto& [size, cell] : tally.bySize) {
    file["bySize"].push_back(cellJson(cell));
    file["bySize"].back()["noncentrality"] = size > 0 ? json(size) : json("physical");
  }
  for (const auto& [size, cell] : tally.byPlausible) {
    file["byPlausibleSize"].push_back(cellJson(cell));
    file["byPlausibleSize"].back()["plausible"] = size;
  }
  for (const auto& [name, cell] : tally.byFamily) {
    file["byFamily"].push_back(cellJson(cell));
    file["byFamily"].back()["family"] = name;
  }
  for (const auto& [key, cell] : tally.cells) {
    const auto& [name, size, poses, noise] = key;
    file["cells"].push_back(cellJson(cell));
    file["cells"].back().update(json{{"family", name},
                                     {"noncentrality", size > 0 ? json(size) : json("physical")},
                                     {"poses", poses},
                                     {"noise", noise}});
  }
  for (const Required& figure : requiredFigures(tally)) {
    json entry = figure.value ? json{{"value", *figure.value}, {"sets", figure.share.all}} : shareJson(figure.share);
    entry.update(json{{"figure", figure.what}, {"required", figure.wanted}, {"met", figure.met}});
    file["required"].push_back(std::move(entry));
  }
  return file;
}

} // namespace blind
