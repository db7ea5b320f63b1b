#include "lab/experiments/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace quadrille::experiments {
namespace {

/// Size of one plot with its legend [pixels].
constexpr int kWidth = 790, kHeight = 390;
constexpr std::array kColours = {"1f77b4", "d62728", "2ca02c", "ff7f0e", "9467bd", "8c564b",
                                 "e377c2", "7f7f7f", "bcbd22", "17becf", "000000"};

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

/// Returns a text in gnuplot's single quotes, within which only the quote itself has a meaning.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c == '\n' ? ' ' : c);
  return result + "'";
}

/// Returns how gnuplot draws a series.
std::string style_of(const Series& series, std::size_t points, std::size_t index) {
  const char* colour = kColours[index % kColours.size()];
  if (series.drawn == Drawn::kDots) {
    return fmt::format("with points pt 7 ps 0.3 lc rgb '#{}'", colour);
  }
  // Pieces are too short to be dashed.
  if (series.drawn == Drawn::kPieces && series.dashed) {
    return fmt::format("with lines lw 5 lc rgb '#a6{}'", colour);
  }
  // When the colours run out, they are used again with dotted lines.
  const char* dash = index >= kColours.size() ? " dt 3" : series.dashed ? " dt (12, 6)" : "";
  // A line of one point would be invisible.
  const bool marked = series.drawn == Drawn::kLine && (series.marked || points == 1);
  return fmt::format("with {} lw 1.6 lc rgb '#{}'{}", marked ? "linespoints pt 7 ps 0.7" : "lines",
                     colour, dash);
}

/// Returns the points that the axes can show, one a line; an empty line ends a piece.
std::string data_of(const Series& series, const Plot& plot, std::size_t* count) {
  const auto shows = [](double value, bool logarithmic) {
    return std::isfinite(value) && (!logarithmic || value > 0.0);
  };
  std::string data;
  for (std::size_t i = 0; i < series.points.size(); ++i) {
    const auto& [x, y] = series.points[i];
    if (shows(x, plot.log_x) && shows(y, plot.log_y)) {
      data += fmt::format("{:.9g} {:.9g}\n", x, y);
      ++*count;
    }
    if (series.drawn == Drawn::kPieces && i % 2 == 1) data += "\n";
  }
  return data;
}

std::string panel(const Plot& plot, const Colours& colours) {
  std::string text = fmt::format("set title {}\nset xlabel {}\nset ylabel {}\nunset logscale\n",
                                 quoted(plot.title), quoted(plot.x_label), quoted(plot.y_label));
  if (plot.log_x) text += "set logscale x\n";
  if (plot.log_y) text += "set logscale y\n";
  text += plot.equal_axes ? "set size ratio -1\n" : "set size noratio\n";
  text += "set xrange [*:*]\nset yrange [*:*]\n";
  if (!plot.min_y_range.empty()) {
    const auto [low, high] = std::minmax_element(plot.min_y_range.begin(), plot.min_y_range.end());
    text += fmt::format("set yrange [*<{}:{}<*]\n", *low, *high);
  }
  std::string drawn;
  for (const Series& series : plot.lines) {
    std::size_t count = 0;
    const std::string data = data_of(series, plot, &count);
    if (count == 0) continue;
    const std::string name = fmt::format("$series{}", std::count(drawn.begin(), drawn.end(), '$'));
    text += fmt::format("{} << END\n{}END\n", name, data);
    drawn += fmt::format("{}{} {} title {}", drawn.empty() ? "plot " : ", ", name,
                         style_of(series, count, colours.at(way_of(series))), quoted(series.name));
  }
  // gnuplot draws no axes without a range.
  return text + (drawn.empty() ? "plot [0:1][0:1] NaN notitle" : drawn) + "\n";
}

}  // namespace

std::string to_gnuplot(const std::vector<Plot>& plots) {
  std::string text = fmt::format(
      "set terminal svg size {},{} font 'sans-serif,12' background 'white' noenhanced\n"
      "set multiplot layout {},1\nset key outside right top Left reverse samplen 2\n"
      "set grid lc rgb '#dddddd' lt 1\nset offsets graph 0.04, graph 0.04, graph 0.04, graph "
      "0.04\n",
      kWidth, kHeight * plots.size(), plots.size());
  const Colours colours = colours_of(plots);
  for (const Plot& plot : plots) text += panel(plot, colours);
  return text;
}

}  // namespace quadrille::experiments
