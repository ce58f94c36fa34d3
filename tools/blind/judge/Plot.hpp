#pragma once

#include <string>
#include <utility>
#include <vector>

namespace blind {

/// A small plot as SVG text: points with error bars, lines, labels on both axes. Values outside the axes are cut off.
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

/// For text inside HTML.
std::string escaped(const std::string& text);

} // namespace blind
