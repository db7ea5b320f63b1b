#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fits/contenders.hpp"
#include "lab/experiments/experiments.hpp"
#include "lab/experiments/fit_errors.hpp"
#include "lab/experiments/random_quadric.hpp"
#include "lab/experiments/section.hpp"

namespace quadrille::experiments {
namespace {

constexpr std::array kShown = {QuadricType::kEllipsoid, QuadricType::kCylinder, QuadricType::kCone,
                               QuadricType::kHyperboloidOneSheet, QuadricType::kEllipticParaboloid};
constexpr std::array kFits = {"likelihood", "full", "compact", "taubin"};
/// Noise of a coordinate, relative to the longest side of the bounding box.
constexpr double kNoise = 0.03;
/// Points within this distance of the section plane are drawn in it.
constexpr double kSlab = 0.15;

Series near_points(const OrientedPointsd& data, const SectionPlane& plane) {
  Series dots{.name = "points beside it", .points = {}, .drawn = Drawn::kDots};
  const Eigen::Vector3d normal = plane.u.cross(plane.v);
  for (Eigen::Index i = 0; i < data.size(); ++i) {
    const Eigen::Vector3d x = data.points.col(i) - plane.origin;
    if (std::abs(normal.dot(x)) < kSlab) dots.points.emplace_back(plane.u.dot(x), plane.v.dot(x));
  }
  return dots;
}

/// Returns the part of a section that lies near points: within the unit ball and slightly beyond.
Series drawn_section(const std::string& name, const Quadric& Q, const SectionPlane& plane,
                     bool dashed) {
  Series series{.name = name, .points = {}, .dashed = dashed, .drawn = Drawn::kPieces};
  const auto ends = section(Q, plane, 1.1);
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    if (std::hypot(ends[i].first, ends[i].second) > 1.1) continue;
    series.points.insert(series.points.end(), {ends[i], ends[i + 1]});
  }
  return series;
}

/// Draws one quadric with its noisy points and the results of the fits.
Plot draw_example(QuadricType type, std::uint64_t seed, int points, Report* report) {
  RandomStream random(seed, static_cast<std::uint64_t>(type));
  const Quadric Q = random_quadric(type, random);
  const OrientedPointsd truth = sample(Q, points, random);
  const double size = size_of(truth.points);
  OrientedPointsd data = truth;
  add_point_noise(&data, kNoise * size, random);
  const Eigen::Matrix3d axes = canonical_form(Q).X.linear();
  const SectionPlane plane{Eigen::Vector3d::Zero(), axes.col(0), axes.col(2)};
  const std::string name = std::string(to_string(type));
  Plot plot{
      fmt::format("{}, σ = {:.0f} % of the size", name, 100.0 * kNoise), "along x", "along z", {}};
  plot.equal_axes = true;
  plot.lines = {near_points(data, plane), drawn_section("truth", Q, plane, true)};
  const std::vector<Contender> all = contenders(type);
  for (const char* fit : kFits) {
    const auto found = find_contender(all, fit)->fit(data);
    const FitErrors errors = errors_of(found, Q, truth, size);
    report->data.row(name, fit, errors.point, errors.angle);
    const std::string label = fmt::format("{}: off by {:.1f} %", fit, 100.0 * errors.point);
    if (found) plot.lines.push_back(drawn_section(label, *found, plane, false));
    if (found) plot.lines.back().way = fit;
  }
  return plot;
}

}  // namespace

Report run_examples(const Settings& settings) {
  Report report;
  report.data.columns = {"quadric", "fit", "point", "angle"};
  for (const QuadricType type : kShown) {
    report.plots.push_back(draw_example(type, settings.seed, settings.quick ? 100 : 300, &report));
    settings.progress(static_cast<double>(report.plots.size()) / kShown.size());
  }
  report.findings = {
      fmt::format("Fits to points with noise of {:.0f} % of the size and exact normals, drawn in a "
                  "section with "
                  "the points beside it; errors are mean distances from the true surface in sizes.",
                  100.0 * kNoise)};
  Table table = report.data;
  table.title = "Errors";
  report.tables = {table};
  return report;
}

}  // namespace quadrille::experiments
