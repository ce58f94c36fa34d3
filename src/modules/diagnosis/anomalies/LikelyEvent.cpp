#include "diagnosis/anomalies/LikelyEvent.hpp"

#include "calibration/ReadingNoise.hpp"
#include "diagnosis/StepwiseSelection.hpp"
#include "diagnosis/anomalies/Events.hpp"
#include "diagnosis/anomalies/WrongAngles.hpp"
#include "inference/NoiseLevels.hpp"
#include "inference/ScoreTest.hpp"
#include "inference/Thresholds.hpp"
#include "io/InputError.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>

namespace naocal {

namespace {

bool areSame(const Noise& one, const Noise& other) {
  return one.pose == other.pose && one.reapproach == other.reapproach && one.readings == other.readings;
}

/// Noise levels to try: those of the fit and, with few poses, lower scatter, since a single bad pose inflates the
/// scatter of all. Where the noise of readings was estimated, lower levels of it, all of them together with the scatter
/// and each alone: what moved inflates them, and what only shifted inflates that of places, not that of turns.
std::vector<Noise> lowerLevels(const Noise& noise, const Measurements& measurements) {
  Noise fitted = noise;
  fitted.readings.clear();
  std::vector<std::size_t> estimated;
  for (std::size_t level = 0; level < measurements.levels.size(); ++level) {
    fitted.readings.push_back(sigmaOf(measurements, noise, level));
    if (!measurements.levels[level].isGiven) {
      estimated.push_back(level);
    }
  }
  std::vector<Noise> result{fitted};
  const auto add = [&](double ofScatter, const std::vector<std::size_t>& read, double ofReadings) {
    Noise less = fitted;
    less.pose *= ofScatter;
    less.reapproach *= ofScatter;
    for (const std::size_t level : read) {
      double& sigma = less.readings[level];
      sigma = std::max(std::min(sigma, threshold::leastReadingNoise), ofReadings * sigma);
    }
    if (std::none_of(result.begin(), result.end(), [&](const Noise& known) { return areSame(known, less); })) {
      result.push_back(std::move(less));
    }
  };
  const bool scatters = noise.pose + noise.reapproach > 0;
  if (scatters && measurements.poses.size() < threshold::fewPoses) {
    for (const double part : {0.0, 0.25, 0.5}) {
      add(part, {}, 1);
    }
    if (measurements.quantities.scene().hasLinkSteps) { // what moved for long inflates it more than one bad pose
      add(0.1, {}, 1);
    }
  }
  for (const double part : {1.0 / 2, 1.0 / 4, 1.0 / 8, 1.0 / 16, 1.0 / 32}) {
    if (!estimated.empty()) {
      add(part, estimated, part);
    }
    for (const std::size_t level : estimated) {
      add(1, {level}, part);
    }
  }
  return result;
}

/// -2 ln likelihood of the model without groups at the tests' noise level, up to a constant that is the same at all
/// levels.
double devianceOf(const MeasuredTests& tests, const Measurements& measurements) {
  const Noise& noise = tests.alone.noise();
  double result = tests.outcome.deviance[0] + poseNoisePenalty(noise.pose) + poseNoisePenalty(noise.reapproach);
  for (const PoseRows& pose : *tests.alone.problem().poses) {
    result += pose.squares / (noise.pixel * noise.pixel);
  }
  return result + logNoiseOfReadings(measurements, noise);
}

/// Best Bayes factor of each group over the noise levels, relative to the model at the first level, that of the fit,
/// whose evidence is already computed.
std::vector<double> findBestAtAnyLevel(const CandidateTests& candidateTests, const FittedModel& fitted,
                                       const std::vector<Noise>& levels) {
  std::vector<double> result;
  for (const GroupEvidence& group : candidateTests.evidence().groups) {
    result.push_back(group.bayes);
  }
  const double first = devianceOf(candidateTests.measured(), fitted.measurements);
  for (auto level = levels.begin() + 1; level != levels.end(); ++level) {
    std::optional<WideModel> anew; // rows are in units of the readings' noise
    if (level->readings != levels.front().readings) {
      Noise read = levels.front();
      read.readings = level->readings;
      anew.emplace(fitted.measurements, fitted.model, candidateTests.candidates(),
                   FittedPoint{fitted.fit.state, read, fitted.fit.loss}, candidateTests.curveCount() > 0);
    }
    const MeasuredTests measured{anew ? anew->problem() : candidateTests.problem(), *level};
    const double rise = devianceOf(measured, fitted.measurements) - first;
    const Evidence evidence = computeEvidence(measured);
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] = std::max(result[i], evidence.groups[i].bayes - rise);
    }
  }
  return result;
}

/// Strongest evidence of competing explanations, at any noise level. Steps over time count as events, not as rivals.
struct Rivals {
  double lasting = 0; // a permanent effect
  double passing = 0; // a transient effect, or an unnamed curve

  double best() const { return std::max(lasting, passing); }
};

Rivals findRivals(const CandidateTests& candidateTests, const FittedModel& fitted, const std::vector<Noise>& levels) {
  const std::vector<double> all = findBestAtAnyLevel(candidateTests, fitted, levels);
  const std::size_t named = candidateTests.candidates().size();
  Rivals result;
  for (std::size_t i = 0; i < named; ++i) {
    double& best = isTransient(candidateTests.candidates()[i].effect) ? result.passing : result.lasting;
    best = std::max(best, all[i]);
  }
  for (std::size_t i = named; i < all.size(); ++i) {
    if (candidateTests.curveBasis(i - named).shape != DriverBasis::Shape::step) {
      result.passing = std::max(result.passing, all[i]);
    }
  }
  return result;
}

/// Candidate events with their evidence.
struct Asked {
  std::vector<TransientEvent> events;
  std::vector<double> bayes;           // at the best noise level, prior included
  std::vector<GroupEvidence> evidence; // at the noise level of the fit
  std::vector<std::size_t> order = {}; // by decreasing evidence

  const TransientEvent& event(std::size_t place) const { return events[order[place]]; }
};

Asked askEvents(std::vector<TransientEvent> events, const FittedModel& fitted, const std::vector<Noise>& levels) {
  std::vector<Term> terms;
  for (const TransientEvent& event : events) {
    terms.push_back(event.term);
  }
  const CandidateTests candidateTests{fitted, terms, {.draws = 0, .map = false}};
  Asked result{std::move(events), findBestAtAnyLevel(candidateTests, fitted, levels), candidateTests.evidence().groups};
  for (std::size_t i = 0; i < result.events.size(); ++i) {
    result.bayes[i] += result.events[i].prior;
  }
  result.order.resize(result.events.size());
  std::iota(result.order.begin(), result.order.end(), std::size_t{0});
  std::stable_sort(result.order.begin(), result.order.end(),
                   [&](std::size_t a, std::size_t b) { return result.bayes[a] > result.bayes[b]; });
  return result;
}

/// Evidence that the best of so many events may reach by chance.
double expectedByChance(const Asked& events, const Measurements& measurements) {
  const std::size_t possible = std::max(events.events.size(), measurements.pictures.size()); // or untested
  return threshold::veryStrong + 2 * std::log(static_cast<double>(possible));
}

bool leads(double bayes, const Rivals& rivals) {
  return bayes > std::max(rivals.lasting + threshold::veryStrong, rivals.passing + threshold::unnamed);
}

/// Whether the likeliest event leads its rivals and is large enough to matter.
bool isConvincing(const Asked& events, const Rivals& rivals) {
  const std::size_t first = events.order.front();
  const GroupEvidence& evidence = events.evidence[first];
  return leads(events.bayes[first], rivals) &&
         (events.events[first].from ? evidence.movedPx > threshold::negligiblePx : evidence.matters());
}

/// The likeliest few events; those with a moment at all possible moments.
std::vector<TransientEvent> expandMoments(const Asked& coarse, const Measurements& measurements) {
  constexpr std::size_t most = 8;
  std::vector<TransientEvent> things;
  for (std::size_t place = 0; place < coarse.order.size() && things.size() < most; ++place) {
    const TransientEvent& event = coarse.event(place);
    if (std::none_of(things.begin(), things.end(),
                     [&](const TransientEvent& one) { return isSameThing(one, event); })) {
      things.push_back(event);
    }
  }
  std::vector<TransientEvent> result = spreadOverTime(things, measurements);
  std::copy_if(things.begin(), things.end(), std::back_inserter(result),
               [](const TransientEvent& one) { return !one.from; });
  return result;
}

/// A fitted event.
struct Tried {
  TransientEvent event;
  double bayes = 0; // evidence, corrected by the chi2 decrease of the fit
  double fall = 0;  // that decrease
  Eigen::VectorXd values;
};

/// Fits the likeliest events, each object at its best three moments; best first.
std::vector<Tried> tryLikeliest(const Asked& events, const FittedModel& fitted) {
  constexpr std::size_t most = 12, moments = 3;
  std::vector<std::size_t> chosen;
  std::vector<TransientEvent> some;
  for (const std::size_t i : events.order) {
    const TransientEvent& event = events.events[i];
    const auto before = static_cast<std::size_t>(std::count_if(
        some.begin(), some.end(), [&](const TransientEvent& other) { return isSameThing(event, other); }));
    if (some.size() < most && before < moments) {
      chosen.push_back(i);
      some.push_back(event);
    }
  }
  const std::vector<std::optional<EventFit>> fits = fitEvents(some, fitted);
  std::vector<Tried> result;
  for (std::size_t i = 0; i < some.size(); ++i) {
    if (fits[i]) {
      const double gained = fits[i]->fall - events.evidence[chosen[i]].likelihoodRatio;
      result.push_back({some[i], events.bayes[chosen[i]] + gained, fits[i]->fall, fits[i]->values});
    }
  }
  std::stable_sort(result.begin(), result.end(), [](const Tried& a, const Tried& b) { return a.bayes > b.bayes; });
  return result;
}

/// Widens an event's bounds to all moments that are almost as likely.
TransientEvent widenEvent(TransientEvent event, const Asked& fine) {
  double best = -std::numeric_limits<double>::infinity();
  const auto ofThis = [&](const auto& look) {
    for (std::size_t i = 0; i < fine.events.size(); ++i) {
      if (isSameThing(fine.events[i], event)) {
        look(*fine.events[i].from, fine.bayes[i]);
      }
    }
  };
  ofThis([&](const Moment& moment, double bayes) { best = moment.time == event.from->time ? bayes : best; });
  ofThis([&](const Moment& moment, double bayes) {
    if (bayes > best - threshold::equallyLikely) {
      event.from->since = std::min(event.from->since, moment.since);
      event.from->until = std::max(event.from->until, moment.until);
    }
  });
  return event;
}

/// Alternatives that are almost as likely: ", unless it was board B (1 to 3)".
std::string formatAlternatives(const std::vector<Tried>& tried) {
  std::string text;
  std::vector<const TransientEvent*> told{&tried.front().event};
  for (const Tried& other : tried) {
    const double behind = tried.front().bayes - other.bayes;
    const bool is = std::any_of(told.begin(), told.end(),
                                [&](const TransientEvent* one) { return isSameThing(other.event, *one); });
    if (behind < threshold::equallyLikely && !is) {
      const double odds = std::exp(behind / 2);
      text += fmt::format("{}{} ({})", text.empty() ? ", unless it was " : " or ", other.event.who,
                          odds < 1.5 ? "as likely" : fmt::format("1 to {:.0f}", odds));
      told.push_back(&other.event);
    }
  }
  return text;
}

/// Fit with full weight for all measurements. Absent if it puts a corner behind its camera.
std::optional<CalibrationResult> calibrateInFull(const FittedModel& fitted, const Measurements& given) {
  CalibrationOptions options;
  options.noise = fitted.fit.noise;
  options.start = fitted.fit.unknowns;
  options.estimateNoise = options.testMissingEffects = options.robust = false;
  try {
    return calibrate(given, fitted.model, options);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Evidence per pose that makes a displacement of a camera, tracker or board a knock: 3 sigma in each.
constexpr double noticed = 9;

std::size_t posesAfter(const TransientEvent& event, const Measurements& measurements) {
  const auto isLater = [&](std::size_t index) {
    const ImageObservation& picture = measurements.pictures[index];
    return picture.set == event.set && picture.instant.time.count() > event.from->time;
  };
  return static_cast<std::size_t>(
      std::count_if(measurements.poses.begin(), measurements.poses.end(), [&](const PoseGroup& pose) {
        return std::any_of(pose.readings.begin(), pose.readings.end(), [&](const EncoderSample& reading) {
          return std::any_of(reading.pictures.begin(), reading.pictures.end(), isLater);
        });
      }));
}

/// Whether noise explains what an event leaves of the misfit. Noise that was estimated without repeated poses would
/// hold part of any misfit, and proves nothing.
bool explainsMisfit(const Tried& tried, const FittedModel& fitted) {
  const Measurements& measurements = fitted.measurements;
  const bool isGiven = std::all_of(measurements.levels.begin(), measurements.levels.end(),
                                   [](const ReadingLevel& level) { return level.isGiven; });
  const double freedom = fitted.fit.misfitFreedom - static_cast<double>(tried.values.size());
  const double left = fitted.fit.misfit * fitted.fit.misfitFreedom - tried.fall;
  return isGiven && freedom > 0 && left <= threshold::mostMisfit(freedom) * freedom;
}

/// The event with its estimates, at the moment that fits best at the noise that it leaves.
struct Estimated {
  TransientEvent event;
  std::vector<EventValue> values;
  bool isRefuted = false;
};

/// Values without sigmas, of a search that failed.
std::vector<EventValue> valuesOf(const Tried& tried) {
  std::vector<EventValue> values;
  for (std::size_t i = 0; i < tried.event.term.effect.unknowns.size(); ++i) {
    const Unknown& unknown = tried.event.term.effect.unknowns[i];
    values.push_back({unknown.name, unknown.unit, tried.values[static_cast<Eigen::Index>(i)]});
  }
  return values;
}

/// Estimates the likeliest event with the noise levels estimated beside it; tries its moments again at these.
Estimated estimateLikeliest(const std::vector<Tried>& tried, const FittedModel& fitted) {
  const Tried& best = tried.front();
  const auto estimate = estimateEvent(best.event, fitted, best.values);
  if (!estimate) {
    return {best.event, valuesOf(best)};
  }
  std::vector<TransientEvent> moments;
  for (const Tried& other : tried) {
    if (isSameThing(other.event, best.event)) {
      moments.push_back(other.event);
    }
  }
  if (moments.size() == 1) {
    return {best.event, estimate->values, estimate->isRefuted};
  }
  CalibrationResult sharper = fitted.fit;
  sharper.noise = estimate->noise;
  const std::vector<std::optional<EventFit>> fits = fitEvents(moments, {fitted.measurements, fitted.model, sharper});
  const auto fallOf = [&](std::size_t i) { return fits[i] ? fits[i]->fall : 0; };
  std::size_t likeliest = 0;
  for (std::size_t i = 1; i < moments.size(); ++i) {
    likeliest = fallOf(i) > fallOf(likeliest) ? i : likeliest;
  }
  if (likeliest == 0 || !fits[likeliest]) {
    return {best.event, estimate->values, estimate->isRefuted};
  }
  const auto again = estimateEvent(moments[likeliest], fitted, fits[likeliest]->values);
  return again ? Estimated{moments[likeliest], again->values, again->isRefuted}
               : Estimated{best.event, estimate->values, estimate->isRefuted};
}

/// Whether something that stands anyhow moved so little that a sum of small effects which vary with time is likelier.
bool isRatherDrift(const Tried& tried, const FittedModel& fitted) {
  return isMoveAnyhow(tried.event) && !explainsMisfit(tried, fitted) &&
         tried.bayes < noticed * static_cast<double>(posesAfter(tried.event, fitted.measurements));
}

/// Tells the likeliest of the fitted events. Absent if its estimate refutes it.
std::optional<LikelyEvent> tellLikeliest(const std::vector<Tried>& tried, const Asked& fine, const Rivals& rivals,
                                         const FittedModel& fitted) {
  const Tried& best = tried.front();
  constexpr double mostOdds = 1e12;
  LikelyEvent result{best.event, std::min(mostOdds, std::exp((best.bayes - rivals.best()) / 2)), best.fall, {}};
  const bool isSized = best.event.from || !best.event.moved.empty();
  if (isSized || best.event.captures.size() > 1) {
    Estimated estimated = estimateLikeliest(tried, fitted);
    if (estimated.isRefuted) {
      return std::nullopt;
    }
    result.event = best.event.from ? widenEvent(std::move(estimated.event), fine) : std::move(estimated.event);
    result.values = isSized ? std::move(estimated.values) : std::vector<EventValue>{};
  }
  result.sentence = describeEvent(result.event, result.values) + formatAlternatives(tried);
  return result;
}

std::optional<LikelyEvent> findLikeliestAt(const FittedModel& fitted, const CandidateTests& candidateTests) {
  std::vector<TransientEvent> events = enumerateEvents(fitted.measurements, fitted.fit);
  const std::vector<TransientEvent> angles = enumerateWrongAngles(fitted);
  events.insert(events.end(), angles.begin(), angles.end());
  if (events.empty()) {
    return std::nullopt;
  }
  const std::vector<Noise> levels = lowerLevels(candidateTests.noise(), fitted.measurements);
  const Rivals rivals = findRivals(candidateTests, fitted, levels);
  const Asked coarse = askEvents(std::move(events), fitted, levels);
  constexpr double within = 0.5; // of what the rivals explain, where the best moments are not among the first few
  if (coarse.bayes[coarse.order.front()] <
      std::max(expectedByChance(coarse, fitted.measurements), within * rivals.best())) {
    return std::nullopt;
  }
  const Asked fine = askEvents(expandMoments(coarse, fitted.measurements), fitted, levels);
  if (!isConvincing(fine, rivals)) {
    return std::nullopt;
  }
  std::vector<Tried> tried = tryLikeliest(fine, fitted);
  while (!tried.empty() && !isRatherDrift(tried.front(), fitted)) {
    if (auto event = tellLikeliest(tried, fine, rivals, fitted)) {
      return event;
    }
    const TransientEvent refuted = tried.front().event;
    std::erase_if(tried,
                  [&](const Tried& one) { return isSameThing(one.event, refuted) || !leads(one.bayes, rivals); });
  }
  return std::nullopt;
}

} // namespace

std::optional<LikelyEvent> findLikeliestEvent(const FittedModel& fitted, const CandidateTests& candidateTests,
                                              const Measurements& given) {
  const bool lostAny =
      !fitted.fit.doubtfulReadings.empty() ||
      std::any_of(fitted.fit.outliers.begin(), fitted.fit.outliers.end(), std::mem_fn(&Outlier::whole));
  const std::optional<CalibrationResult> all = lostAny ? calibrateInFull(fitted, given) : std::nullopt;
  if (!all) {
    return findLikeliestAt(fitted, candidateTests);
  }
  const FittedModel inFull{given, fitted.model, *all};
  const CandidateTests again{inFull, candidateTests.candidates(), {.draws = 0}};
  constexpr double most = 0.5; // share of what the accidents explain; a move that explains less leaves them
  auto event = findLikeliestAt(inFull, again);
  const bool explains = event && (!event->event.from || event->fall >= most * (all->chi2 - fitted.fit.chi2));
  return explains ? std::move(event) : findLikeliestAt(fitted, candidateTests);
}

} // namespace naocal
