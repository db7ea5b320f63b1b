#include "lab/experiments/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

namespace quadrille::experiments {
namespace {

constexpr double kLeft = 70, kTop = 30, kWidth = 480, kHeight = 300, kPanel = 390, kLegend = 240;
/// Free space between the frame and the drawing, relative to the length of the axis.
constexpr double kMargin = 0.04;
constexpr std::array kColours = {"#1f77b4", "#d62728", "#2ca02c", "#ff7f0e", "#9467bd", "#8c564b",
                                 "#e377c2", "#7f7f7f", "#bcbd22", "#17becf", "#000000"};

/// One axis: the values that it shows, and their place on the page.
struct Axis {
  bool logarithmic;
  double from, length;
  double low = std::numeric_limits<double>::infinity(), high = -low;

  bool shows(double value) const { return std::isfinite(value) && (!logarithmic || value > 0); }
  double scaled(double value) const { return logarithmic ? std::log10(value) : value; }
  double unscaled(double value) const { return logarithmic ? std::pow(10.0, value) : value; }
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void finish() {
    if (!(low <= high)) low = high = 1.0;
    if (low == high) {
      const double margin = low == 0.0 ? 1.0 : 0.5 * std::abs(low);
      low -= margin, high += margin;
    }
    const double first = scaled(low), last = scaled(high);
    const double margin = (last - first) * kMargin / (1.0 - 2.0 * kMargin);
    low = unscaled(first - margin), high = unscaled(last + margin);
  }
  double units_per_pixel() const { return (scaled(high) - scaled(low)) / std::abs(length); }
  /// Widens a linear axis around its middle.
  void stretch_to(double units_per_pixel) {
    const double middle = 0.5 * (low + high), half = 0.5 * units_per_pixel * std::abs(length);
    low = middle - half, high = middle + half;
  }
  double place(double value) const {
    return from + length * (scaled(value) - scaled(low)) / (scaled(high) - scaled(low));
  }
};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  }
  return result;
}

std::string label(double x, double y, const std::string& anchor, const std::string& text,
                  const std::string& more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                     anchor, more, escaped(text));
}

std::string line(double x1, double y1, double x2, double y2, const std::string& style) {
  return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {}/>\n", x1, y1, x2, y2, style);
}

/// Index of the colour of each kind of line.
using Colours = std::map<std::string, std::size_t>;

const std::string& way_of(const Series& series) {
  return series.way.empty() ? series.name : series.way;
}

Colours colours_of(const std::vector<Plot>& plots) {
  Colours colours;
  for (const Plot& plot : plots) {
    for (const Series& series : plot.lines) colours.emplace(way_of(series), colours.size());
  }
  return colours;
}

std::string colour_of(std::size_t index) { return kColours[index % kColours.size()]; }

std::string style_of(const Series& series, std::size_t index) {
  // Pieces are too short to be dashed.
  if (series.drawn == Drawn::kPieces && series.dashed) {
    return fmt::format("stroke=\"{}\" stroke-width=\"5\" stroke-opacity=\"0.35\" fill=\"none\"",
                       colour_of(index));
  }
  // When the colours run out, they are used again with dotted lines.
  const char* dash = series.dashed ? " stroke-dasharray=\"6 3\"" : "";
  if (index >= kColours.size()) dash = " stroke-dasharray=\"2 2\"";
  return fmt::format("stroke=\"{}\" stroke-width=\"1.6\" fill=\"none\"{}", colour_of(index), dash);
}

std::string tick_label(double value) { return fmt::format("{:.7g}", value); }

std::string frame(const Plot& plot, const Axis& x, const Axis& y, double top) {
  const std::string grid = "stroke=\"#ddd\" fill=\"none\"";
  const double bottom = top + kHeight;
  std::string svg;
  for (const double value : ticks(x.low, x.high, plot.log_x)) {
    svg += line(x.place(value), top, x.place(value), bottom, grid);
    svg += label(x.place(value), bottom + 16, "middle", tick_label(value));
  }
  for (const double value : ticks(y.low, y.high, plot.log_y)) {
    svg += line(kLeft, y.place(value), kLeft + kWidth, y.place(value), grid);
    svg += label(kLeft - 6, y.place(value) + 4, "end", tick_label(value));
  }
  svg += fmt::format("<path d=\"M{0} {1}H{2}V{3}H{0}Z\" stroke=\"#000\" fill=\"none\"/>\n", kLeft,
                     top, kLeft + kWidth, bottom);
  const double middle = kLeft + kWidth / 2, half = top + kHeight / 2;
  svg += label(middle, top - 10, "middle", plot.title, " font-weight=\"bold\"");
  svg += label(middle, bottom + 34, "middle", plot.x_label);
  return svg + label(14, half, "middle", plot.y_label,
                     fmt::format(" transform=\"rotate(-90 14 {})\"", half));
}

/// Returns the positions on the page of the points that the axes show.
std::vector<std::pair<double, double>> placed(const Series& series, const Axis& x, const Axis& y) {
  std::vector<std::pair<double, double>> points;
  for (const auto& p : series.points) {
    if (x.shows(p.first) && y.shows(p.second))
      points.emplace_back(x.place(p.first), y.place(p.second));
  }
  return points;
}

std::string circles(const std::vector<std::pair<double, double>>& points, double radius,
                    std::size_t colour) {
  std::string svg;
  for (const auto& [at_x, at_y] : points) {
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"/>\n", at_x, at_y,
                       radius, colour_of(colour));
  }
  return svg;
}

/// Draws all pieces as one path.
std::string pieces(const Series& series, const Axis& x, const Axis& y, std::size_t colour) {
  std::string path;
  for (std::size_t i = 0; i + 1 < series.points.size(); i += 2) {
    const auto &a = series.points[i], &b = series.points[i + 1];
    path += fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", x.place(a.first), y.place(a.second),
                        x.place(b.first), y.place(b.second));
  }
  if (path.empty()) return "";
  return fmt::format("<path d=\"{}\" {}/>\n", path, style_of(series, colour));
}

std::string curve(const Series& series, const Axis& x, const Axis& y, std::size_t colour) {
  if (series.drawn == Drawn::kPieces) return pieces(series, x, y, colour);
  const auto points = placed(series, x, y);
  if (series.drawn == Drawn::kDots) return circles(points, 1.5, colour);
  const bool dotted = series.marked || points.size() == 1;
  std::string svg = dotted ? circles(points, 4, colour) : "", path;
  for (const auto& [at_x, at_y] : points) {
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", at_x, at_y);
  }
  // A path of one point would be invisible.
  if (points.size() < 2) return svg;
  return svg + fmt::format("<path d=\"{}\" {}/>\n", path, style_of(series, colour));
}

std::string panel(const Plot& plot, double top, const Colours& colours) {
  Axis x{plot.log_x, kLeft, kWidth}, y{plot.log_y, top + kHeight, -kHeight};
  for (const Series& series : plot.lines) {
    for (const auto& p : series.points) {
      if (x.shows(p.first) && y.shows(p.second)) x.include(p.first), y.include(p.second);
    }
  }
  for (const double value : plot.min_y_range) y.include(value);
  x.finish(), y.finish();
  if (plot.equal_axes) {
    const double scale = std::max(x.units_per_pixel(), y.units_per_pixel());
    x.stretch_to(scale), y.stretch_to(scale);
  }
  std::string svg = frame(plot, x, y, top);
  double height = top + 10;
  for (const Series& series : plot.lines) {
    const std::size_t colour = colours.at(way_of(series));
    svg += curve(series, x, y, colour);
    const double at = kLeft + kWidth + 12;
    svg += series.drawn == Drawn::kDots
               ? circles({{at + 12, height}}, 3, colour)
               : line(at, height, at + 24, height, style_of(series, colour));
    svg += label(at + 30, height + 4, "start", series.name);
    height += 16;
  }
  return svg;
}

}  // namespace

std::vector<double> ticks(double low, double high, bool logarithmic) {
  std::vector<double> result;
  if (logarithmic) {
    const double first = std::ceil(std::log10(low) - 1e-9),
                 last = std::floor(std::log10(high) + 1e-9);
    const double every = std::max(1.0, std::ceil((last - first) / 8.0));
    for (double k = first; k <= last; k += every) result.push_back(std::pow(10.0, k));
    if (result.size() >= 2) return result;
    result.clear();
  }
  const double rough = (high - low) / 5.0, power = std::pow(10.0, std::floor(std::log10(rough)));
  const double share = rough / power;
  const double step = power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) {
    result.push_back(k * step + 0.0);  // adding 0 avoids a negative zero
  }
  return result;
}

std::string to_svg(const std::vector<Plot>& plots) {
  const double width = kLeft + kWidth + kLegend;
  const double height = kPanel * static_cast<double>(plots.size());
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" font-family=\"sans-serif\" font-size=\"12\">\n<path d=\"M0 0H{0}V{1}H0Z\" "
      "fill=\"#fff\"/>\n",
      width, height);
  const Colours colours = colours_of(plots);
  for (std::size_t i = 0; i < plots.size(); ++i) {
    svg += panel(plots[i], kTop + kPanel * static_cast<double>(i), colours);
  }
  return svg + "</svg>\n";
}

}  // namespace quadrille::experiments
