#include "judge/Page.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

namespace blind {

namespace {

/// A small SVG plot: points with error bars, lines, labelled axes. Values are clamped to the axes.
class Plot {
public:
  struct Axis {
    std::string label;
    double low, high;
    std::vector<std::pair<double, std::string>> ticks;
  };
  Plot(std::string title, Axis x, Axis y);

  void level(double y, const std::string& colour, const std::string& text);                   // a horizontal line
  void line(const std::vector<std::pair<double, double>>& points, const std::string& colour); // through points
  void point(double x, double y, double low, double high, const std::string& colour, const std::string& hover);
  void dot(double x, double y, const std::string& colour, const std::string& hover);
  std::string svg() const;

private:
  double across(double x) const;
  double down(double y) const;

  Axis x_, y_;
  std::string body_;
};

constexpr double width = 560, height = 320, left = 64, right = 16, top = 34, bottom = 60; // [px]

/// Escapes text for HTML.
std::string escapeHtml(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    result += letter == '<'   ? "&lt;"
              : letter == '>' ? "&gt;"
              : letter == '&' ? "&amp;"
              : letter == '"' ? "&quot;"
                              : std::string(1, letter);
  }
  return result;
}

Plot::Plot(std::string title, Axis x, Axis y) : x_{std::move(x)}, y_{std::move(y)} {
  body_ += fmt::format("<text x='{}' y='18' class='title'>{}</text>", left, escapeHtml(title));
  for (const auto& [value, label] : x_.ticks) {
    body_ += fmt::format("<line x1='{0:.1f}' x2='{0:.1f}' y1='{1}' y2='{2}' class='grid'/><text x='{0:.1f}' y='{3}' "
                         "text-anchor='middle'>{4}</text>",
                         across(value), top, height - bottom, height - bottom + 16, escapeHtml(label));
  }
  for (const auto& [value, label] : y_.ticks) {
    body_ += fmt::format("<line x1='{1}' x2='{2}' y1='{0:.1f}' y2='{0:.1f}' class='grid'/><text x='{3}' y='{4:.1f}' "
                         "text-anchor='end'>{5}</text>",
                         down(value), left, width - right, left - 6, down(value) + 4, escapeHtml(label));
  }
  body_ += fmt::format("<text x='{}' y='{}' text-anchor='middle'>{}</text>", (left + width - right) / 2, height - 8,
                       escapeHtml(x_.label));
  body_ += fmt::format("<text transform='translate(14 {}) rotate(-90)' text-anchor='middle'>{}</text>",
                       (top + height - bottom) / 2, escapeHtml(y_.label));
}

double Plot::across(double x) const {
  return left + (width - left - right) * (std::clamp(x, x_.low, x_.high) - x_.low) / (x_.high - x_.low);
}

double Plot::down(double y) const {
  return height - bottom - (height - top - bottom) * (std::clamp(y, y_.low, y_.high) - y_.low) / (y_.high - y_.low);
}

void Plot::level(double y, const std::string& colour, const std::string& text) {
  body_ += fmt::format("<line x1='{}' x2='{}' y1='{:.1f}' y2='{:.1f}' stroke='{}' stroke-dasharray='5 4'/>", left,
                       width - right, down(y), down(y), colour);
  body_ += fmt::format("<text x='{}' y='{:.1f}' text-anchor='end' fill='{}'>{}</text>", width - right - 4, down(y) - 4,
                       colour, escapeHtml(text));
}

void Plot::line(const std::vector<std::pair<double, double>>& points, const std::string& colour) {
  body_ += fmt::format("<polyline fill='none' stroke='{}' stroke-width='2' points='", colour);
  for (const auto& [x, y] : points) {
    body_ += fmt::format("{:.1f},{:.1f} ", across(x), down(y));
  }
  body_ += "'/>";
}

void Plot::point(double x, double y, double low, double high, const std::string& colour, const std::string& hover) {
  body_ += fmt::format("<line x1='{0:.1f}' x2='{0:.1f}' y1='{1:.1f}' y2='{2:.1f}' stroke='{3}' stroke-width='2'/>",
                       across(x), down(low), down(high), colour);
  dot(x, y, colour, hover);
}

void Plot::dot(double x, double y, const std::string& colour, const std::string& hover) {
  body_ += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='4' fill='{}'><title>{}</title></circle>", across(x), down(y),
                       colour, escapeHtml(hover));
}

std::string Plot::svg() const {
  return fmt::format("<svg viewBox='0 0 {} {}' width='{}' height='{}'>{}</svg>\n", width, height, width, height, body_);
}

const std::string blue = "#1f6fb2", grey = "#777", red = "#b23a1f";

const Plot::Axis percents(const std::string& label) {
  return {label, 0, 100, {{0, "0 %"}, {20, "20 %"}, {40, "40 %"}, {60, "60 %"}, {80, "80 %"}, {100, "100 %"}}};
}

std::string told(const Share& share) {
  return fmt::format("{:.1f} % of {} ({:.1f} to {:.1f} %)", 100 * share.rate(), share.all, 100 * share.low(),
                     100 * share.high());
}

void add(Plot& plot, double x, const Share& share, const std::string& colour, const std::string& what) {
  if (share.all > 0) {
    plot.point(x, 100 * share.rate(), 100 * share.low(), 100 * share.high(), colour, what + ": " + told(share));
  }
}

/// Short label of a noise regime for the axis.
std::string shortName(const std::string& regime) {
  for (const auto& [name, shorter] : {std::pair{"foreshortening", "slanted"},
                                      {"heavy tails", "tails"},
                                      {"picture bias", "shifted"},
                                      {"quantised", "steps"},
                                      {"pictures", "rendered"},
                                      {"stiction 0.02", "0.02°"},
                                      {"stiction 0.05", "0.05°"},
                                      {"stiction 0.10", "0.10°"}}) {
    if (regime == name) {
      return shorter;
    }
  }
  return regime;
}

std::string falseAlarms(const Tally& tally) {
  Plot::Axis regimes{"noise", 0, static_cast<double>(tally.falseAlarms.size()) + 1, {}};
  double x = 0;
  for (const auto& [name, share] : tally.falseAlarms) {
    regimes.ticks.emplace_back(++x, shortName(name));
  }
  Plot plot{"False alarms on robots without hidden effect",
            regimes,
            {"alarms", 0, 30, {{0, "0 %"}, {5, "5 %"}, {10, "10 %"}, {20, "20 %"}, {30, "30 %"}}}};
  plot.level(7, red, "at most 7 %");
  x = 0;
  for (const auto& [name, share] : tally.falseAlarms) {
    add(plot, ++x, share, blue, name);
  }
  return plot.svg();
}

/// Position on the logarithmic axis.
double across(double noncentrality) {
  return std::log10(noncentrality);
}

Plot::Axis sizes() {
  return {"noncentrality of the hidden effect (true noise, twin run)",
          across(7),
          across(140),
          {{across(10), "10"}, {across(20), "20"}, {across(40), "40"}, {across(100), "100"}}};
}

std::string power(const Tally& tally) {
  Plot plot{"Detection (line: the best any max-test can do)", sizes(), percents("detected")};
  std::vector<std::pair<double, double>> theory;
  for (const auto& [size, cell] : tally.bySize) {
    if (size > 0) {
      theory.emplace_back(across(size), 100 * cell.expected.value());
    }
  }
  plot.line(theory, grey);
  for (const auto& [size, cell] : tally.bySize) {
    if (size > 0) {
      add(plot, across(size), cell.detected, blue, fmt::format("noncentrality {:g}", size));
    }
  }
  return plot.svg();
}

std::string classes(const Tally& tally) {
  Plot plot{"Named right: class (blue), in first three (red), first (grey)", sizes(), percents("right")};
  for (const auto& [size, cell] : tally.bySize) {
    if (size > 0) {
      add(plot, across(size) - 0.015, cell.top1, grey, "first");
      add(plot, across(size), cell.inClass, blue, "class");
      add(plot, across(size) + 0.015, cell.top3, red, "first three");
    }
  }
  return plot.svg();
}

std::string families(const Tally& tally) {
  std::string rows;
  for (const auto& [name, cell] : tally.byFamily) {
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{:.0f} %</td><td>{:.0f} %</td><td>{:.0f} %</td><td>{:.0f} %</td>"
                        "<td>{}</td></tr>\n",
                        escapeHtml(name), cell.detected.all, 100 * cell.detected.rate(), 100 * cell.inClass.rate(),
                        100 * cell.top3.rate(), 100 * cell.covered.rate(),
                        cell.errorFell.all > 0 ? fmt::format("{:.0f} %", 100 * cell.errorFell.rate()) : "not asked");
  }
  return "<h2>By effect, noncentrality 20 and more</h2><table><tr><th>effect</th><th>sets</th><th>detected</th>"
         "<th>right class</th><th>first three</th><th>size covered</th><th>error fell</th></tr>\n" +
         rows + "</table>\n";
}

std::string lockedErrors(const std::vector<Case>& cases) {
  Plot plot{"Error on poses never used for choosing, over the noise floor",
            {"before the suggestion", 0.9, 3, {{1, "1"}, {1.5, "1.5"}, {2, "2"}, {2.5, "2.5"}, {3, "3"}}},
            {"after", 0.9, 3, {{1, "1"}, {1.5, "1.5"}, {2, "2"}, {2.5, "2.5"}, {3, "3"}}}};
  plot.line({{0.9, 0.9}, {3, 3}}, grey);
  plot.level(1.1, red, "10 % over the floor");
  for (const Case& one : cases) {
    const auto& [truth, answer] = one;
    if (truth.group == "catalogue" && !truth.pictures && answer.lockedBeforePx && answer.lockedAfterPx) {
      plot.dot(*answer.lockedBeforePx / truth.lockedFloorPx, *answer.lockedAfterPx / truth.lockedFloorPx, blue,
               truth.set + " " + truth.effects.front().name);
    }
  }
  return plot.svg();
}

std::string figures(const Tally& tally) {
  std::string rows;
  for (const Required& figure : requiredFigures(tally)) {
    rows +=
        fmt::format("<tr class='{}'><td>{}</td><td>{}</td><td>{}</td></tr>\n", figure.met ? "met" : "missed",
                    escapeHtml(figure.what), escapeHtml(figure.wanted),
                    figure.value ? fmt::format("{:.3f} of {}", *figure.value, figure.share.all) : told(figure.share));
  }
  return "<table><tr><th>figure</th><th>required</th><th>measured (95 % band)</th></tr>\n" + rows + "</table>\n";
}

constexpr const char* style =
    "body{font:15px/1.5 system-ui,sans-serif;max-width:76em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse}td,th{padding:.2em .9em .2em 0;text-align:left;border-bottom:1px solid #ddd}"
    ".missed td:last-child{color:#b23a1f}.met td:last-child{color:#1a7f37}"
    ".plots{display:flex;flex-wrap:wrap}svg{margin:1em 1em 0 0;font:12px system-ui,sans-serif}svg "
    ".title{font-weight:600;font-size:13px}"
    "svg .grid{stroke:#e4e4e4}";

} // namespace

std::string renderEvaluation(const Tally& tally, const std::vector<Case>& cases) {
  return fmt::format("<!doctype html><html lang='en'><meta charset='utf-8'><title>Blind benchmark</title>"
                     "<style>{}</style><h1>Blind benchmark of the diagnosis</h1>"
                     "<p>{} robots with sealed truths, {:.2f} s per diagnosis; {} without a verdict.</p>\n{}<div "
                     "class='plots'>{}{}{}{}</div>{}</html>\n",
                     style, tally.sets, tally.seconds.value(), tally.withoutVerdict, figures(tally), falseAlarms(tally),
                     power(tally), classes(tally), tally.machines ? "" : lockedErrors(cases), families(tally));
}

} // namespace blind
