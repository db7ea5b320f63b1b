#pragma once

#include <string>
#include <utility>
#include <vector>

namespace quadrille::experiments {

/// How a series is drawn: as a line through its points, as small dots, or as separate pieces, each
/// from one point to the next.
enum class Drawn { kLine, kDots, kPieces };

/// A line of a plot.
struct Series {
  std::string name;
  std::vector<std::pair<double, double>> points;
  /// Draws a dashed line; pieces are drawn broad and pale instead.
  bool dashed = false;
  /// Also draws each point as a dot; a single point always is.
  bool marked = false;
  /// Lines with the same value have the same colour in all plots of a document; if empty, the name
  /// counts.
  std::string way = {};
  Drawn drawn = Drawn::kLine;
};

/// A line plot with two axes.
struct Plot {
  std::string title, x_label, y_label;
  std::vector<Series> lines;
  bool log_x = false, log_y = false;
  /// Least and greatest value that the vertical axis shows in any case; if empty, the points
  /// decide.
  std::vector<double> min_y_range = {};
  /// Gives both axes the same scale, for drawings of geometry in a plane.
  bool equal_axes = false;
};

/// Returns a script by which gnuplot draws the plots, one below the other, as one SVG document,
/// each with its legend on the right.
///
/// Points that are not finite, or not positive on a logarithmic axis, are left out.
std::string to_gnuplot(const std::vector<Plot>& plots);

}  // namespace quadrille::experiments
