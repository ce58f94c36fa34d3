#include "judge/Tally.hpp"

#include "judge/Figures.hpp"
#include "judge/MachineFigures.hpp"
#include "judge/Statistics.hpp"

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
  constexpr double clear = 40;
  if (truth.machine && truth.wanted >= clear) {
    result.byWitness[truth.noise].add(marked);
  }
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

/// Adds offsets and p-values, with and without hidden effects.
void addHonesty(const Case& one, const Marks& marked, Tally& result) {
  const Truth& truth = one.truth;
  if (truth.group == "control" || truth.group == "decoy" || truth.group == "jitter") {
    result.sound.add(marked.given);
    addAll(marked.given.inside, result.insideByGroup[truth.group]);
    if (one.answer.first) {
      const std::string regime = truth.pictures ? "pictures" : truth.jitter > 0 ? "jitter" : truth.noise;
      result.pValues[regime].push_back(one.answer.first->pValue);
    }
  }
  if (hidesOne(truth) || truth.group == "pair" || truth.group == "outside") {
    result.hidden.add(marked.given);
    addAll(marked.given.inside, result.insideByGroup[truth.group]);
    result.added.add(marked.added);
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

/// Requirements for wrong models or readings: results, causes and events.
void addHonesty(const Tally& tally, Figures& figures) {
  addOffsets(tally, figures);
  const std::size_t large = tally.rmsRatios.size();
  if (large > 0) {
    const double middle = median(tally.rmsRatios);
    const double worst = *std::max_element(tally.rmsRatios.begin(), tally.rmsRatios.end());
    figures.value("rms of the first fit against --fixed-noise, large, median", "at most 1.1", middle, large,
                  middle <= 1.1);
    figures.value("... worst", "at most 1.5", worst, large, worst <= 1.5);
  }
  for (const auto& [size, percent] : {std::pair{0.5, 92.0}, {1.0, 95.0}, {2.0, 97.0}}) {
    const auto cell = tally.byPlausible.find(size);
    if (cell != tally.byPlausible.end()) {
      figures.atLeast(fmt::format("truth or its class first at {:g} plausible sizes", size), percent,
                      cell->second.inClass);
    }
  }
  figures.atLeast("truth or its class first where a twin imitates it", 92, tally.twinClass);
  figures.atMost("extra suggestions, neither truth nor class, one effect", 3, tally.extraNamed);
  figures.atMost("cameras' and lenses' errors said to be bad captures or scatter", 1, tally.cameraBlamed);
  for (const auto& [what, share] : tally.eventNamed) {
    figures.atLeast(what + ": named", 97, share);
    figures.atLeast(what + ": named and timed", 97, tally.eventTimed.at(what));
  }
  for (const auto& [repeats, share] : tally.jitterAdequate) {
    figures.atLeast("jitter of readings, " + repeats + ": adequate", 95, share);
    figures.atLeast("jitter of readings, " + repeats + ": level within 20 %", 95, tally.jitterLevel.at(repeats));
  }
  addUniformity(tally, figures);
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

void Tally::Offsets::add(const Marks::Offsets& marked) {
  addAll(marked.inside, inside);
  beyond.add(marked.beyond);
  usableBeyond.add(marked.usableBeyond);
  widths.insert(widths.end(), marked.widths.begin(), marked.widths.end());
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

Tally tallyCases(const std::vector<Case>& cases) {
  Tally result;
  for (const Case& one : cases) {
    const Truth& truth = one.truth;
    const Marks marked = markAnswer(one);
    ++result.sets;
    const bool silent = one.answer.verdict.empty(); // never counts in favour
    result.withoutVerdict += silent;
    result.seconds.add(one.answer.seconds);
    addHonesty(one, marked, result);
    if (truth.group == "control" || truth.group == "catalogue") {
      result.falseUnknown.add(marked.unknownSaid);
    }
    result.machines = result.machines || truth.machine;
    if (truth.machine && truth.group == "control") {
      result.misfitSaid[truth.noise].add(marked.misfitSaid);
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
    } else if (marked.culpritNamed) {
      result.culpritNamed[truth.kind].add(marked.culpritNamed);
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
            {"misfitOnControls", sharesJson(tally.misfitSaid)},
            {"culpritsNamed", sharesJson(tally.culpritNamed)},
            {"byWitness", json::array()},
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
  for (const auto& [name, cell] : tally.byWitness) {
    file["byWitness"].push_back(cellJson(cell));
    file["byWitness"].back()["witness"] = name;
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

std::vector<Required> requiredFigures(const Tally& tally) {
  if (tally.machines) {
    return machineFigures(tally);
  }
  Figures figures;
  for (const auto& [regime, share] : tally.falseAlarms) {
    figures.atMost("false alarms on controls, " + regime, 7, share);
  }
  addPower(tally, figures);
  for (const auto& [size, percent] : {std::pair{20.0, 85.0}, {40.0, 95.0}, {100.0, 98.0}}) {
    figures.atLeast(fmt::format("right class at noncentrality {:g}", size), percent, cellAt(tally, size).inClass);
  }
  for (const auto& [size, percent] : {std::pair{20.0, 90.0}, {40.0, 97.0}}) {
    figures.atLeast(fmt::format("among the first three at {:g}", size), percent, cellAt(tally, size).top3);
  }
  figures.atLeast("two effects at once: each suggested or told to be trivial", 90, tally.bothFound);
  if (tally.extra.all > 0) {
    figures.value("extra suggestions per pair", "at most 0.05", tally.extra.value(), tally.extra.all,
                  tally.extra.value() <= 0.05);
  }
  figures.atLeast("outside the catalogue, 0.3°, clean: joint, driver, \"unknown\"", 90, tally.unknownClean);
  figures.atLeast("outside the catalogue, stiction, noncentrality 40 and 80", 90, tally.unknownSticking);
  figures.atMost("\"unknown\" on controls and catalogued effects", 5, tally.falseUnknown);
  const PooledSizes pooled = poolSizes(tally);
  figures.atLeast("the suggestion lowers the error on locked poses", 95, pooled.errorFell);
  figures.atLeast("... to within 10 % of the floor", 95, pooled.nearFloor);
  figures.between("95 % interval of the size covers the truth", 90, 98, pooled.covered);
  figures.atLeast("absorbed effects said to be untestable", 95, tally.saidUntestable);
  figures.atLeast("corrupted sets said to be corrupted", 95, tally.saidCorrupted);
  addHonesty(tally, figures);
  return std::move(figures).all();
}

} // namespace blind
