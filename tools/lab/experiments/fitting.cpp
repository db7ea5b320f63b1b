#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "fits/contenders.hpp"
#include "fits/likelihood_fit.hpp"
#include "lab/experiments/experiments.hpp"
#include "lab/experiments/fit_errors.hpp"
#include "lab/experiments/fit_times.hpp"
#include "lab/experiments/measure.hpp"
#include "lab/experiments/random_quadric.hpp"

namespace quadrille::experiments {
namespace {

constexpr std::array kLevels = {0.0, 0.01, 0.02, 0.03, 0.04, 0.05};
constexpr int kNeighbours = 16;
// Smaller errors than this are rounding: exact fits of exact data count as equally good.
constexpr double kExact = 1e-9;

/// The source of the normals.
enum class Normals { kExact, kNoisy, kEstimated };
constexpr std::array kModes = {Normals::kExact, Normals::kNoisy, Normals::kEstimated};

std::string name_of(Normals mode) {
  constexpr std::array kNames = {"exact", "noisy", "estimated"};
  return kNames.at(static_cast<std::size_t>(mode));
}

std::string describe(Normals mode) {
  const std::array texts = {
      std::string("exact normals, noise on the points alone, as the paper has it"),
      std::string("normals turned by noise of 2σ rad about each axis"),
      fmt::format("normals estimated from the {} nearest noisy points", kNeighbours)};
  return texts.at(static_cast<std::size_t>(mode));
}

/// Mean errors of every contender in one mode at one noise level, in the contenders' order.
using Means = std::vector<FitErrors>;

struct Size {
  int quadrics, fits, points;
};

std::vector<Contender> contenders_for(QuadricType type, Normals mode) {
  std::vector<Contender> all = contenders(type);
  for (Contender& contender : all) {
    if (mode != Normals::kEstimated || contender.name != "likelihood") continue;
    // This fit needs to know how many points each normal was estimated from.
    contender.fit = [](const OrientedPointsd& points) {
      return fit_likelihood(points, {.points_per_normal = kNeighbours});
    };
  }
  return all;
}

OrientedPointsd noisy(OrientedPointsd data, double level, Normals mode, double size,
                      RandomStream& random) {
  add_point_noise(&data, level * size, random);
  if (mode == Normals::kNoisy) add_normal_noise(&data, 2.0 * level, random);
  if (mode == Normals::kEstimated) estimate_normals(&data, kNeighbours);
  return data;
}

Means mean_errors(Normals mode, double level, const Size& size, std::uint64_t seed) {
  Means means(contenders(QuadricType::kSphere).size());
  const double weight = 1.0 / (size.quadrics * size.fits);
  for (int k = 0; k < size.quadrics; ++k) {
    const QuadricType type = curved_type(k);
    const std::vector<Contender> all = contenders_for(type, mode);
    RandomStream shape(seed, static_cast<std::uint64_t>(k));
    const Quadric Q = random_quadric(type, shape);
    for (int fit = 0; fit < size.fits; ++fit) {
      // Every level and mode uses the same points and the same noise, apart from the noise's size.
      RandomStream random(seed, static_cast<std::uint64_t>(100 + k * size.fits + fit));
      const OrientedPointsd truth = sample(Q, size.points, random);
      const double extent = size_of(truth.points);
      const OrientedPointsd data = noisy(truth, level, mode, extent, random);
      for (std::size_t m = 0; m < all.size(); ++m) {
        const FitErrors errors = errors_of(all[m].fit(data), Q, truth, extent);
        means[m].point += weight * errors.point;
        means[m].angle += weight * errors.angle;
        means[m].gradient += weight * errors.gradient;
      }
    }
  }
  return means;
}

struct Row {
  Normals mode;
  double level;
  Means means;
};

/// Returns the index of the contender that is best in one measure, leaving out our own.
std::size_t best_baseline(const std::vector<Contender>& all, const Means& means,
                          double FitErrors::*measure) {
  std::size_t best = all.size();
  for (std::size_t m = 0; m < all.size(); ++m) {
    if (all[m].ours) continue;
    if (best == all.size() || means[m].*measure < means[best].*measure) best = m;
  }
  return best;
}

bool is_rounding(const FitErrors& ours, double point, double angle) {
  return std::max({ours.point, ours.angle, point, angle}) < kExact;
}

bool no_worse(double ours, double theirs) { return ours <= theirs || ours < kExact; }

/// Sums up the comparison for one mode, from the levels at which our fit is not best and those at
/// which all are equal.
std::string verdict(Normals mode, const std::string& lost, const std::string& equal) {
  std::string text = describe(mode) + ": the likelihood fit ";
  text += lost.empty() ? "is best in point and angle error at every level of noise"
                       : "is not best in both errors at σ =" + lost;
  if (!equal.empty()) text += "; at σ =" + equal + " it and the best are equal to rounding";
  return text + ".";
}

/// Compares our fit with the best of all others, one row per mode and level.
Table comparison(const std::vector<Contender>& all, const std::vector<Row>& rows,
                 std::vector<std::string>* findings) {
  Table table{"The likelihood fit beside the best baseline",
              {"normals", "σ [%]", "point: ours", "best baseline", "which", "angle: ours",
               "best baseline", "which", "ours is best in both"},
              {}};
  const std::size_t ours = static_cast<std::size_t>(find_contender(all, "likelihood") - all.data());
  std::map<Normals, std::string> lost, equal;
  for (const Row& row : rows) {
    const FitErrors& mine = row.means[ours];
    const std::size_t p = best_baseline(all, row.means, &FitErrors::point);
    const std::size_t a = best_baseline(all, row.means, &FitErrors::angle);
    const bool won =
        no_worse(mine.point, row.means[p].point) && no_worse(mine.angle, row.means[a].angle);
    const bool rounding = is_rounding(mine, row.means[p].point, row.means[a].angle);
    const std::string level = fmt::format(" {:g} %", 100.0 * row.level);
    if (!won) lost[row.mode] += level;
    if (rounding) equal[row.mode] += level;
    table.row(name_of(row.mode), fmt::format("{:g}", 100.0 * row.level), mine.point,
              row.means[p].point, all[p].name, mine.angle, row.means[a].angle, all[a].name,
              rounding ? "equal to rounding"
              : won    ? "yes"
                       : "no");
  }
  for (const Normals mode : kModes) {
    findings->push_back(verdict(mode, lost[mode], equal[mode]));
  }
  return table;
}

Table error_table(const std::vector<Contender>& all, const std::vector<Row>& rows, Normals mode,
                  const std::string& what, double FitErrors::*measure) {
  Table table{what + "; " + describe(mode), {"fit", "from"}, {}};
  for (const double level : kLevels) table.columns.push_back(fmt::format("{:g} %", 100.0 * level));
  for (std::size_t m = 0; m < all.size(); ++m) {
    std::vector<std::string> cells = {std::string(all[m].name), std::string(all[m].source)};
    for (const Row& row : rows) {
      if (row.mode == mode) cells.push_back(number(row.means[m].*measure));
    }
    table.add(cells);
  }
  return table;
}

Plot error_plot(const std::vector<Contender>& all, const std::vector<Row>& rows, Normals mode,
                const std::string& what, double FitErrors::*measure) {
  Plot plot{what + ", " + name_of(mode) + " normals", "σ [% of the size]", what, {}, false, true};
  for (std::size_t m = 0; m < all.size(); ++m) {
    // Tasdizen's errors equal those of the compact fit, whose line would be covered.
    const bool covered = all[m].name == "compact";
    plot.lines.push_back({std::string(all[m].name), {}, all[m].minimal, covered});
    for (const Row& row : rows) {
      if (row.mode != mode || row.level == 0.0) continue;
      plot.lines.back().points.emplace_back(100.0 * row.level, row.means[m].*measure);
    }
  }
  return plot;
}

Table all_errors(const std::vector<Contender>& all, const std::vector<Row>& rows,
                 const std::vector<Series>& times) {
  Table table{"", {"measure", "fit", "normals", "x", "value"}, {}};
  for (const Row& row : rows) {
    for (std::size_t m = 0; m < all.size(); ++m) {
      const auto add = [&](const std::string& measure, double value) {
        table.row(measure, all[m].name, name_of(row.mode), row.level, value);
      };
      add("point", row.means[m].point);
      add("angle", row.means[m].angle);
      add("gradient", row.means[m].gradient);
    }
  }
  for (const Series& line : times) {
    for (const auto& [points, time] : line.points) {
      table.row("time_us", line.name, "exact", points, time);
    }
  }
  return table;
}

Table time_table(const std::vector<Series>& times) {
  Table table{"Time of a fit [µs] against the number of points", {"fit"}, {}};
  for (const auto& point : times.front().points) table.columns.push_back(number(point.first));
  for (const Series& line : times) {
    std::vector<std::string> cells = {line.name};
    for (const auto& point : line.points) cells.push_back(number(point.second));
    table.add(cells);
  }
  return table;
}

}  // namespace

Report run_fitting(const Settings& settings) {
  const Size size = settings.quick ? Size{10, 1, 80} : Size{10, 20, 300};
  const std::vector<Contender> all = contenders(QuadricType::kSphere);
  std::vector<Row> rows;
  for (const Normals mode : kModes) {
    for (const double level : kLevels) {
      rows.push_back({mode, level, mean_errors(mode, level, size, settings.seed)});
      settings.progress(static_cast<double>(rows.size()) / (kModes.size() * kLevels.size() + 1));
    }
  }
  const std::vector<Series> times = fit_times(settings);
  Report report;
  report.findings.push_back(fmt::format(
      "{} quadrics, {} fits each of {} points; errors are means over all, 1 where a fit found "
      "nothing. σ is the noise of a coordinate in longest sides of the bounding box. Minimal fits "
      "see their first few points alone.",
      size.quadrics, size.fits, size.points));
  report.tables.push_back(comparison(all, rows, &report.findings));
  const auto add = [&](Normals mode, const std::string& what, double FitErrors::*measure) {
    report.tables.push_back(error_table(all, rows, mode, what, measure));
    report.plots.push_back(error_plot(all, rows, mode, what, measure));
  };
  for (const Normals mode : kModes) {
    add(mode, "Point error [sizes]", &FitErrors::point);
    add(mode, "Angle error [1 − cos]", &FitErrors::angle);
  }
  add(Normals::kExact, "Error of the gradient norm", &FitErrors::gradient);
  report.tables.push_back(time_table(times));
  report.plots.push_back({"Time of a fit", "points", "µs", times, true, true});
  report.data = all_errors(all, rows, times);
  settings.progress(1.0);
  return report;
}

}  // namespace quadrille::experiments
