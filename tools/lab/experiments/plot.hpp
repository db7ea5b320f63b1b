#pragma once

#include <string>
#include <utility>
#include <vector>

namespace quadrille::experiments {

/// What a series is drawn as: a line through its points, small dots, or separate pieces, each from
/// one point to the next.
enum class Drawn { kLine, kDots, kPieces };

/// A line of a plot.
struct Series {
  std::string name;
  std::vector<std::pair<double, double>> points;
  /// Pieces are drawn broad and pale instead.
  bool dashed = false;
  /// Each point as a dot, too; a single one always is.
  bool marked = false;
  /// Lines of one way have one colour in all plots of a document; empty: the name.
  std::string way = {};
  Drawn drawn = Drawn::kLine;
};

/// A line plot with two axes.
struct Plot {
  std::string title, x_label, y_label;
  std::vector<Series> lines;
  bool log_x = false, log_y = false;
  /// What the vertical axis shows in any case, from the least to the greatest; empty: the points.
  std::vector<double> min_y_range = {};
  /// One unit is as long on both axes: a drawing of what lies in a plane.
  bool equal_axes = false;
};

/// Tick values of an axis from low to high: 1, 2 or 5 times a power of ten, and on a logarithmic
/// axis the powers of ten, or more where there are fewer than two.
std::vector<double> ticks(double low, double high, bool logarithmic);

/// The plots below each other as one SVG document, each with its legend on the right.
///
/// Points that are not finite, or not positive on a logarithmic axis, are left out.
std::string to_svg(const std::vector<Plot>& plots);

}  // namespace quadrille::experiments
