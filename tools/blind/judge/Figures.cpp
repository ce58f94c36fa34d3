#include "judge/Figures.hpp"

#include "judge/Statistics.hpp"

#include <fmt/format.h>

namespace blind {

void Figures::atLeast(std::string what, double percent, const Share& share) {
  add(std::move(what), fmt::format("at least {:g} %", percent), share, share.rate() >= percent / 100);
}

void Figures::atMost(std::string what, double percent, const Share& share) {
  add(std::move(what), fmt::format("at most {:g} %", percent), share, share.rate() <= percent / 100);
}

void Figures::between(std::string what, double low, double high, const Share& share) {
  add(std::move(what), fmt::format("{:g} to {:g} %", low, high), share,
      share.rate() >= low / 100 && share.rate() <= high / 100);
}

void Figures::value(std::string what, std::string wanted, double value, std::size_t sets, bool met) {
  if (sets > 0) {
    figures_.push_back({std::move(what), std::move(wanted), {0, sets}, met, value});
  }
}

void Figures::add(std::string what, std::string wanted, const Share& share, bool met) {
  if (share.all > 0) {
    figures_.push_back({std::move(what), std::move(wanted), share, met});
  }
}

Cell cellAt(const Tally& tally, double size) {
  const auto found = tally.bySize.find(size);
  return found == tally.bySize.end() ? Cell{} : found->second;
}

void addPower(const Tally& tally, Figures& figures) {
  for (const double size : {10.0, 20.0, 40.0}) {
    const Cell cell = cellAt(tally, size);
    const double theory = cell.expected.value();
    figures.add(fmt::format("detected at noncentrality {:g}", size), fmt::format("{:.0f} % ± 10", 100 * theory),
                cell.detected, cell.detected.rate() >= theory - 0.1);
  }
}

void addOffsets(const Tally& tally, Figures& figures) {
  const std::vector<std::pair<std::string, const Tally::Offsets*>> all{
      {"sound sets", &tally.sound}, {"effect hidden", &tally.hidden}, {"what is suggested added", &tally.added}};
  for (const auto& [which, offsets] : all) { // offsets are dependent within a set: intervals are slightly too narrow
    figures.between("offsets inside their 95 % interval, " + which, 94, 97, offsets->inside);
    figures.atMost("a result with an offset beyond its 99.95 % bound, " + which, 1, offsets->beyond);
    figures.atMost("the same, called usable, " + which, 1, offsets->usableBeyond);
    if (!offsets->widths.empty()) {
      const double middle = median(offsets->widths);
      figures.value("width of that bound over 7 sigma, median, " + which, "at most 1.3", middle, offsets->widths.size(),
                    middle <= 1.3);
    }
  }
  for (const auto& [group, share] : tally.insideByGroup) {
    figures.between("offsets inside their 95 % interval, " + group, 94, 97, share);
  }
}

void addUniformity(const Tally& tally, Figures& figures) {
  for (const auto& [regime, numbers] : tally.pValues) {
    if (numbers.size() < fewestForUniformity) { // too few for a test
      continue;
    }
    const double p = uniformityP(numbers);
    figures.value("solve's p on sound sets uniform (KS), " + regime, "p above 0.01", p, numbers.size(), p > 0.01);
  }
}

PooledSizes poolSizes(const Tally& tally) {
  PooledSizes pooled;
  for (const auto& [size, cell] : tally.bySize) {
    for (const auto& [sum, part] : {std::pair{&pooled.errorFell, &cell.errorFell},
                                    {&pooled.nearFloor, &cell.nearFloor},
                                    {&pooled.covered, &cell.covered}}) {
      sum->yes += part->yes;
      sum->all += part->all;
    }
  }
  return pooled;
}

} // namespace blind
