#include "setups/SetUpSearch.hpp"

#include "calibration/Calibration.hpp"
#include "inference/Thresholds.hpp"
#include "io/InputError.hpp"
#include "math/Angles.hpp"
#include "math/LinearAlgebra.hpp"
#include "math/Parallel.hpp"
#include "setups/CaptureSelection.hpp"
#include "setups/Catalogue.hpp"
#include "setups/SetUpFit.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace naocal {

namespace {

constexpr double grossError = 10;  // usual noises: 3 px, 5 mm, 0.6°; an error that no calibrated robot has
constexpr double largeError = 4;   // usual noises: 1 px, 2 mm, 0.2°; more than most effects leave
constexpr double soundError = 40;  // usual noises: 12 px, 20 mm, 2°; more than a robot with unmodelled physics leaves
constexpr double beyondDoubt = 50; // evidence of a mistake that leaves much of the error, or none of a far turn [2 ln]
constexpr double mostOdds = 1e6;   // no model is surer of itself

/// A mistake and one way to undo it.
struct Hypothesis {
  const SetUp* setUp = nullptr;
  std::string place;
  Mending mending;
  double cost = 0; // 2 ln of the ways in which a mistake of its kind could be made, times the kinds

  std::string label() const { return setUp->labelAt(place); }
};

/// All mistakes that these captures can have. `known`: undone already.
std::vector<Hypothesis> listHypotheses(const Measurements& measurements, const std::vector<Hypothesis>& known) {
  std::vector<Hypothesis> places;
  for (const SetUp& setUp : allSetUps()) {
    for (const std::string& place : setUp.listPlaces(measurements)) {
      const bool isKnown = std::any_of(
          known.begin(), known.end(), [&](const Hypothesis& one) { return one.setUp == &setUp && one.place == place; });
      if (!isKnown) {
        places.push_back({&setUp, place, {}});
      }
    }
  }
  std::vector<std::vector<Mending>> ways(places.size());
  parallelFor(places.size(),
              [&](std::size_t i) { ways[i] = places[i].setUp->listMendings(measurements, places[i].place); });
  std::map<const SetUp*, double> counts;
  for (std::size_t i = 0; i < places.size(); ++i) {
    counts[places[i].setUp] += static_cast<double>(ways[i].size());
  }
  std::vector<Hypothesis> result;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double cost = 2 * std::log(counts[places[i].setUp] * static_cast<double>(allSetUps().size()));
    for (Mending& way : ways[i]) {
      result.push_back({places[i].setUp, places[i].place, std::move(way), cost});
    }
  }
  return result;
}

/// Whether a step takes the error to that of a robot, or as good an error without a far turn.
bool removesError(const SetUpFit& before, const SetUpFit& after) {
  constexpr double asGood = 1.1;                   // of the error: a coarse search ends a little above its minimum
  const bool hadFit = std::isfinite(before.error); // else whatever can be fitted falls
  const bool falls = after.typicalError < threshold::correctionShare * before.typicalError;
  const bool imitates = !before.farPlace.empty() && after.farPlace.empty() && after.error < asGood * before.error;
  return (hadFit ? after.typicalError : after.error) < soundError && (falls || imitates);
}

/// Captures with some mistakes undone.
struct Explained {
  std::vector<Hypothesis> mistakes;
  Recording recording;
  SetUpFit fit;
  std::shared_ptr<const Explained> parent = nullptr; // the same without the last step's mistakes; of one step: null

  double length() const {
    double sum = fit.length;
    for (const Hypothesis& mistake : mistakes) {
      sum += mistake.cost;
    }
    return sum;
  }
  bool has(const std::string& label) const {
    return std::any_of(mistakes.begin(), mistakes.end(),
                       [&](const Hypothesis& mistake) { return mistake.label() == label; });
  }
};

class SetUpSearch {
public:
  SetUpSearch(const Measurements& measurements, AskedModel asked, SetUpFit asTheyAre)
      : samePlace_{measurements.samePlace}, asked_{std::move(asked)},
        start_{{}, {*measurements.sets, measurements.robot}, std::move(asTheyAre), nullptr}, best_{start_} {}

  /// Undoes mistake after mistake while that shortens the description.
  void run() {
    std::vector<Explained> front{start_};
    for (int depth = 0; depth < most && !front.empty() && !isSound(best_.fit); ++depth) {
      std::vector<Explained> longer;
      for (const Explained& explained : front) {
        for (Explained& next : extend(explained)) {
          longer.push_back(std::move(next));
        }
      }
      std::stable_sort(longer.begin(), longer.end(),
                       [](const Explained& a, const Explained& b) { return a.length() < b.length(); });
      for (const Explained& one : longer) {
        rivals_.push_back({one.mistakes, {}, one.fit, nullptr});
      }
      const double toBeat = lengthToBeat();
      std::erase_if(longer, [&](const Explained& one) { return !(one.length() < toBeat); });
      longer.resize(std::min<std::size_t>(longer.size(), beam));
      front = std::move(longer);
      best_ = front.empty() ? best_ : front.front();
    }
    dropLast();
    dropSuperfluous();
    trySigns();
  }

  const Explained& best() const { return best_; }

  /// The best explanation without all of the best one's mistakes.
  const Explained* rival() const {
    const Explained* least = nullptr;
    for (const Explained& other : rivals_) {
      const bool hasAll = std::all_of(best_.mistakes.begin(), best_.mistakes.end(),
                                      [&](const Hypothesis& mistake) { return other.has(mistake.label()); });
      if (!hasAll && (!least || other.length() < least->length())) {
        least = &other;
      }
    }
    return least;
  }

private:
  static constexpr int most = 3;             // mistakes together
  static constexpr std::size_t beam = 2;     // explanations that are extended where the first mistake is not all
  static constexpr double leastGain = 0.3;   // of a further mistake, per number measured: an error 14 % smaller
  static constexpr std::size_t refitted = 8; // of the mistakes that a part of the captures makes likely

  bool isSound(const SetUpFit& fit) const {
    const bool wasGross = start_.fit.typicalError >= grossError;
    return fit.farPlace.empty() && fit.typicalError < grossError &&
           (!wasGross || fit.typicalError < threshold::correctionShare * start_.fit.typicalError);
  }

  std::optional<SetUpFit> fit(Recording recording, const FitEffort& effort) const {
    try {
      const Measurements measurements = buildMeasurements(std::move(recording.sets), recording.robot, samePlace_);
      return fitAnew(measurements, asked_.build(measurements), effort);
    } catch (const InputError&) {
      return std::nullopt;
    }
  }

  /// The likeliest explanations with one more mistake.
  std::vector<Explained> extend(const Explained& from) const {
    const Measurements all = buildMeasurements(from.recording.sets, from.recording.robot, samePlace_);
    std::vector<std::vector<Hypothesis>> choices;
    for (Hypothesis& hypothesis : listHypotheses(all, from.mistakes)) {
      choices.push_back({std::move(hypothesis)});
    }
    return extend(from, all, choices);
  }

  /// The likeliest explanations with one of these choices of further mistakes. `all`: the measurements of `from`.
  std::vector<Explained> extend(const Explained& from, const Measurements& all,
                                const std::vector<std::vector<Hypothesis>>& choices) const {
    const CaptureSelection few = selectCaptures(all, asked_.build(all).unknownCount());
    const Recording part = few.of(from.recording);
    std::vector<std::pair<double, std::size_t>> ranked(choices.size());
    parallelFor(choices.size(), [&](std::size_t i) {
      constexpr FitEffort quick{.iterations = 15, .robust = false};
      const bool needsAll = std::any_of(choices[i].begin(), choices[i].end(),
                                        [](const Hypothesis& one) { return one.setUp->needsNeighbours; });
      Recording mended = needsAll ? from.recording : part;
      double cost = 0;
      for (const Hypothesis& mistake : choices[i]) {
        mistake.mending.apply(mended);
        cost += mistake.cost;
      }
      const auto left = fit(needsAll ? few.of(mended) : std::move(mended), quick);
      ranked[i] = {left ? left->length + cost : std::numeric_limits<double>::infinity(), i};
    });
    std::sort(ranked.begin(), ranked.end());
    const auto parent = from.mistakes.empty() ? nullptr : std::make_shared<const Explained>(from);
    std::vector<Explained> result;
    for (std::size_t i = 0; i < std::min(refitted, ranked.size()) && std::isfinite(ranked[i].first); ++i) {
      Explained next{from.mistakes, from.recording, {}, parent};
      for (const Hypothesis& mistake : choices[ranked[i].second]) {
        next.mistakes.push_back(mistake);
        mistake.mending.apply(next.recording);
      }
      if (auto left = fit(next.recording, {})) {
        next.fit = *std::move(left);
        result.push_back(std::move(next));
      }
    }
    return result;
  }

  /// How much shorter a description must be than the best one's [2 ln].
  double lengthToBeat() const {
    return best_.length() - std::max(threshold::veryStrong, leastGain * best_.fit.numbers);
  }

  /// Tries all sets of joints with the wrong sign where mistake after mistake leaves a large error: each of several
  /// wrong signs alone may leave it as large, and other mistakes then seem to explain part of it.
  void trySigns() {
    constexpr std::size_t mostJoints = 7; // an arm's: 127 sets
    if (best_.fit.typicalError < largeError) {
      return;
    }
    const Measurements all = buildMeasurements(start_.recording.sets, start_.recording.robot, samePlace_);
    std::vector<Hypothesis> signs = listHypotheses(all, {});
    std::erase_if(signs, [](const Hypothesis& one) { return one.setUp->name != setUpName::reversedJoint; });
    if (signs.size() > mostJoints) {
      return;
    }
    std::vector<std::vector<Hypothesis>> choices;
    for (std::size_t chosen = 1; chosen < std::size_t{1} << signs.size(); ++chosen) {
      std::vector<Hypothesis>& choice = choices.emplace_back();
      for (std::size_t i = 0; i < signs.size(); ++i) {
        if ((chosen >> i & 1) != 0) {
          choice.push_back(signs[i]);
        }
      }
    }
    std::vector<Explained> found = extend(start_, all, choices);
    const auto shortest = std::min_element(
        found.begin(), found.end(), [](const Explained& a, const Explained& b) { return a.length() < b.length(); });
    for (const Explained& one : found) {
      rivals_.push_back({one.mistakes, {}, one.fit, nullptr});
    }
    if (shortest != found.end() && shortest->length() < lengthToBeat() && removesError(start_.fit, shortest->fit)) {
      best_ = std::move(*shortest);
      dropSuperfluous();
    }
  }

  /// Takes back last mistakes that do what an effect does: shorten the description, but leave much of the error.
  void dropLast() {
    while (best_.parent && !removesError(best_.parent->fit, best_.fit)) {
      best_ = Explained{*best_.parent};
    }
  }

  /// Takes back mistakes that later ones made superfluous.
  void dropSuperfluous() {
    for (std::size_t i = 0; best_.mistakes.size() > 1 && i + 1 < best_.mistakes.size();) {
      Explained without{best_.mistakes, start_.recording, {}, nullptr};
      without.mistakes.erase(without.mistakes.begin() + static_cast<std::ptrdiff_t>(i));
      for (const Hypothesis& mistake : without.mistakes) {
        mistake.mending.apply(without.recording);
      }
      auto left = fit(without.recording, {});
      without.fit = left ? *std::move(left) : SetUpFit{};
      if (without.length() < best_.length() + threshold::veryStrong) {
        best_ = std::move(without);
      } else {
        ++i;
      }
    }
  }

  const bool samePlace_;
  const AskedModel asked_;
  const Explained start_;
  Explained best_;
  std::vector<Explained> rivals_;
};

/// The fit with the likeliest physical effects: those of the likeliest explanations, together and alone, where they
/// come out plausible. A wrong sign is a gain of -2, which is no physics.
SetUpFit fitWithEffects(const FittedModel& fitted, const AskedModel& asked) {
  constexpr std::size_t most = 3; // explanations
  std::vector<std::vector<std::string>> tries;
  for (std::size_t i = 0; i < std::min(most, fitted.fit.explanations.size()); ++i) {
    const std::vector<std::string>& effects = fitted.fit.explanations[i].effects;
    tries.push_back(effects);
    for (const std::string& effect : effects) {
      tries.push_back({effect});
    }
  }
  std::sort(tries.begin(), tries.end());
  tries.erase(std::unique(tries.begin(), tries.end()), tries.end());
  std::vector<SetUpFit> fits(tries.size());
  parallelFor(tries.size(), [&](std::size_t i) {
    AskedModel larger = asked;
    larger.with.insert(larger.with.end(), tries[i].begin(), tries[i].end());
    try {
      const Model model = larger.build(fitted.measurements);
      auto left = fitAnew(fitted.measurements, model, {});
      const auto isPlausible = [&](const std::string& label) {
        const Term* const term = model.find(label);
        return term &&
               (Eigen::VectorXd::Map(term->values(left->unknowns).data(), eigenIndex(term->effect.unknowns.size()))
                    .cwiseQuotient(term->sigmas())
                    .cwiseAbs()
                    .maxCoeff() < threshold::implausible);
      };
      if (left && std::all_of(tries[i].begin(), tries[i].end(), isPlausible)) {
        fits[i] = *std::move(left);
      }
    } catch (const InputError&) {
      return; // an effect that these captures cannot drive
    }
  });
  const auto best = std::min_element(fits.begin(), fits.end(),
                                     [](const SetUpFit& x, const SetUpFit& y) { return x.length < y.length; });
  return best == fits.end() ? SetUpFit{} : *best;
}

/// Whether the misfit is large and its likeliest explanation multiplies something: a wrong sign, unit or size would.
bool suspectsScale(const FittedModel& fitted, const SetUpFit& before) {
  constexpr double likely = 0.5;
  if (before.error < largeError || fitted.fit.explanations.empty() || fitted.fit.explanations.front().weight < likely) {
    return false;
  }
  const std::vector<std::string>& effects = fitted.fit.explanations.front().effects;
  return std::any_of(effects.begin(), effects.end(), [&](const std::string& label) {
    const std::vector<Effect>& all = allEffects();
    const auto effect =
        std::find_if(all.begin(), all.end(), [&](const Effect& one) { return label.starts_with(one.name + '@'); });
    return effect != all.end() && std::all_of(effect->unknowns.begin(), effect->unknowns.end(),
                                              [](const Unknown& unknown) { return unknown.unit == "1"; });
  });
}

/// What mended captures leave with the likeliest physical effects: another one may be hidden there, too.
SetUpFit fitMended(const Recording& mended, const AskedModel& asked, bool samePlace) {
  try {
    const Measurements measurements = buildMeasurements(mended.sets, mended.robot, samePlace);
    const Model model = asked.build(measurements);
    const CalibrationResult result = calibrate(measurements, model);
    return fitWithEffects({measurements, model, result}, asked);
  } catch (const InputError&) {
    return {};
  }
}

/// What else the captures leave possible: ", or ...: these captures cannot tell".
std::string describeDoubt(const SetUpSearch& search, const SetUpFit& before) {
  std::vector<std::string> others;
  const Explained* const rival = search.rival();
  if (!before.farPlace.empty() && !before.isMountFar && before.error < 1.1 * search.best().fit.error) {
    others.push_back(fmt::format("{}'s zero is off by {:.0f}°", before.farPlace, degrees(before.farTurn)));
  }
  if (rival && rival->length() < search.best().length() + threshold::equallyLikely) {
    for (const Hypothesis& mistake : rival->mistakes) {
      if (!search.best().has(mistake.label())) {
        others.push_back(mistake.mending.what);
      }
    }
  }
  return others.empty() ? "" : fmt::format(", or {}: these captures cannot tell", fmt::join(others, " or "));
}

/// What the captures as they are leave: without and with the likeliest physical effects.
struct AsTheyAre {
  SetUpFit fit, physics;

  const SetUpFit& least() const { return physics.length < fit.length ? physics : fit; }
};

/// By how much undoing the mistakes shortens the description, beyond any physics [2 ln]. Absent if that is too little,
/// or if the error stays. Where an effect hides the mistake or leaves an error of its own, both sides have one.
std::optional<double> assessGain(const Explained& best, const AsTheyAre& asTheyAre, const AskedModel& asked,
                                 bool samePlace) {
  const SetUpFit& before = asTheyAre.fit;
  if (best.mistakes.empty() || !(best.length() < before.length - threshold::veryStrong)) {
    return std::nullopt;
  }
  const bool isDoubtful = before.error >= grossError && !before.farPlace.empty();
  const double gain = asTheyAre.least().length - best.length();
  if (gain > (isDoubtful ? beyondDoubt : threshold::veryStrong) && removesError(before, best.fit)) {
    return gain;
  }
  const SetUpFit after = fitMended(best.recording, asked, samePlace);
  const double gainBeside = asTheyAre.least().length - (best.length() - best.fit.length + after.length);
  return gainBeside > beyondDoubt && removesError(asTheyAre.least(), after) ? std::optional{gainBeside} : std::nullopt;
}

/// The mistakes with their sentences; the last one's says what is left.
std::vector<WrongSetUp> describeMistakes(const SetUpSearch& search, const SetUpFit& before, double odds) {
  const Explained& best = search.best();
  std::vector<WrongSetUp> found;
  for (const Hypothesis& mistake : best.mistakes) {
    found.push_back({mistake.label(), mistake.mending.what,
                     fmt::format(fmt::runtime(mistake.setUp->question), mistake.place), odds});
  }
  const std::string doubt = describeDoubt(search, before);
  const bool hasSize = doubt.empty() && !best.fit.size.empty();
  found.back().why += hasSize ? fmt::format(" (so corrected the error is {})", best.fit.size) : doubt;
  return found;
}

std::vector<WrongSetUp> search(const Measurements& measurements, const AskedModel& asked, const AsTheyAre& asTheyAre) {
  SetUpSearch search{measurements, asked, asTheyAre.fit};
  search.run();
  const auto gain = assessGain(search.best(), asTheyAre, asked, measurements.samePlace);
  if (!gain) {
    return {};
  }
  const Explained* const rival = search.rival();
  const double lead = std::min(*gain, rival ? rival->length() - search.best().length() : *gain);
  return describeMistakes(search, asTheyAre.fit, std::exp(std::clamp(lead / 2, 0.0, std::log(mostOdds))));
}

} // namespace

std::vector<WrongSetUp> findSetUps(const FittedModel& fitted) {
  const SetUpFit before = assessFit(fitted.measurements, fitted.model, fitted.fit.unknowns);
  if (before.error < grossError && before.farPlace.empty() && !suspectsScale(fitted, before)) {
    return {};
  }
  const AskedModel asked = AskedModel::of(fitted.measurements, fitted.model);
  const SetUpFit anew = fitAnew(fitted.measurements, fitted.model, {}).value_or(SetUpFit{});
  return search(fitted.measurements, asked,
                {anew.length < before.length ? anew : before, fitWithEffects(fitted, asked)});
}

std::vector<WrongSetUp> findSetUps(const Measurements& measurements, const Model& model) {
  return search(measurements, AskedModel::of(measurements, model),
                {fitAnew(measurements, model, {}).value_or(SetUpFit{}), {}});
}

std::vector<WrongSetUp> findSlippedCounts(const FittedModel& fitted) {
  std::vector<WrongSetUp> result;
  const std::map<std::string, double>& steps = fitted.measurements.sets->front().slipSteps;
  for (const Term& term : fitted.model.terms()) {
    const auto step = steps.find(term.placeName);
    if (term.effect.name != effectName::jointOffset || step == steps.end() || !(step->second > 0)) {
      continue;
    }
    const Estimate& offset = fitted.fit.estimates[term.first];
    const long turns = std::lround(offset.value / step->second);
    if (turns != 0 && offset.learned > threshold::learned) {
      result.push_back(
          {fmt::format("{}@{}", setUpName::countSlip, term.placeName),
           fmt::format("{}'s zero is off by {:.1f}°, about {} turn{} of its motor ({:.1f}° each): the "
                       "count slipped",
                       term.placeName, degrees(offset.value), turns, turns == 1 ? "" : "s", degrees(step->second)),
           fmt::format(fmt::runtime(countSlip().question), term.placeName), 0});
    }
  }
  return result;
}

} // namespace naocal
