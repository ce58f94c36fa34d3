#include "judge/Plot.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace blind {

namespace {
constexpr double width = 560, height = 320, left = 64, right = 16, top = 34, bottom = 60; // [px]
}

std::string escaped(const std::string& text) {
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
  body_ += fmt::format("<text x='{}' y='18' class='title'>{}</text>", left, escaped(title));
  for (const auto& [value, label] : x_.ticks) {
    body_ += fmt::format("<line x1='{0:.1f}' x2='{0:.1f}' y1='{1}' y2='{2}' class='grid'/><text x='{0:.1f}' y='{3}' "
                         "text-anchor='middle'>{4}</text>",
                         across(value), top, height - bottom, height - bottom + 16, escaped(label));
  }
  for (const auto& [value, label] : y_.ticks) {
    body_ += fmt::format("<line x1='{1}' x2='{2}' y1='{0:.1f}' y2='{0:.1f}' class='grid'/><text x='{3}' y='{4:.1f}' "
                         "text-anchor='end'>{5}</text>",
                         down(value), left, width - right, left - 6, down(value) + 4, escaped(label));
  }
  body_ += fmt::format("<text x='{}' y='{}' text-anchor='middle'>{}</text>", (left + width - right) / 2, height - 8,
                       escaped(x_.label));
  body_ += fmt::format("<text transform='translate(14 {}) rotate(-90)' text-anchor='middle'>{}</text>",
                       (top + height - bottom) / 2, escaped(y_.label));
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
                       colour, escaped(text));
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
                       colour, escaped(hover));
}

std::string Plot::svg() const {
  return fmt::format("<svg viewBox='0 0 {} {}' width='{}' height='{}'>{}</svg>\n", width, height, width, height, body_);
}

} // namespace blind
