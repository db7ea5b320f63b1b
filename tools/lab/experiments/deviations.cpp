#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "lab/experiments/experiments.hpp"
#include "lab/experiments/generated_scenes.hpp"
#include "lab/experiments/measure.hpp"
#include "lab/scoring/score.hpp"
#include "quadrille/detector/detector.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille::experiments {
namespace {

const std::vector<scene::Family> kDeviationFamilies = {scene::Family::kEasy, scene::Family::kMedium,
                                                       scene::Family::kHard};

/// A published dimension and the true one.
struct Observation {
  std::string family, type, dimension;
  double published, truth, std;

  double error() const { return std::abs(published - truth); }
};

/// Returns the true dimensions: those of the quadric, and for a cylinder the length of the body.
std::map<std::string, double> dimensions_of(const scoring::TrueSurface& surface) {
  const CanonicalForm form =
      canonical_form(surface.Q_C.transformed(surface.X_CS.inverse()).normalized(), 1e-6);
  std::map<std::string, double> truth(form.dimensions.begin(), form.dimensions.end());
  if (surface.type.ends_with("cylinder")) truth["length"] = surface.box_S.sizes().z();
  return truth;
}

/// The dimensions of all surfaces that were found and named correctly.
struct Observations {
  std::vector<Observation> known;
  /// Number of measured lengths and angles that the detector marked as guesses.
  int guesses = 0;
};

void observe(const scoring::Frame& frame, Observations* all) {
  const DetectionResult result = detect(frame.cloud);
  const auto pairs = scoring::pair_up(frame, scoring::findings_of(result));
  for (const scoring::TrueSurface& surface : frame.surfaces) {
    const auto pair = pairs.find(surface.id);
    if (pair == pairs.end()) continue;
    const Detection& d = result.detections[static_cast<std::size_t>(pair->second)];
    if (surface.type != to_string(d.type)) continue;
    const std::map<std::string, double> truth = dimensions_of(surface);
    for (const Dimension& dimension : d.dimensions) {
      const auto known = truth.find(dimension.name);
      if (known == truth.end()) continue;
      if (!std::isfinite(dimension.std)) {
        ++all->guesses;
        continue;
      }
      all->known.push_back({frame.family, surface.type, dimension.name, dimension.value,
                            known->second, dimension.std});
    }
  }
}

using Group = std::vector<const Observation*>;

double share_within(const Group& group, double sigmas) {
  const auto n = std::count_if(group.begin(), group.end(),
                               [&](const auto* o) { return o->error() <= sigmas * o->std; });
  return static_cast<double>(n) / static_cast<double>(group.size());
}

template <class Value>
double median(const Group& group, const Value& value) {
  std::vector<double> values;
  for (const Observation* o : group) values.push_back(value(*o));
  return quantile(values, 0.5);
}

std::vector<std::string> row_of(std::vector<std::string> name, const Group& group) {
  const auto percent = [](double share) { return fmt::format("{:.0f} %", 100.0 * share); };
  const auto relative_std = [](const Observation& o) { return o.std / o.truth; };
  const auto relative_error = [](const Observation& o) {
    return std::abs(o.published / o.truth - 1.0);
  };
  for (std::string cell : {number(static_cast<double>(group.size())),
                           percent(share_within(group, 1.0)), percent(share_within(group, 2.0)),
                           fmt::format("{:.2g} %", 100.0 * median(group, relative_std)),
                           fmt::format("{:.2g} %", 100.0 * median(group, relative_error))}) {
    name.push_back(std::move(cell));
  }
  return name;
}

std::vector<std::string> columns_of(std::vector<std::string> name) {
  for (const char* column :
       {"dimensions", "within 1 std", "within 2 std", "median std", "median error"}) {
    name.emplace_back(column);
  }
  return name;
}

/// Plots the shares within a number of standard deviations, beside those of the normal
/// distribution.
Plot plot_of(const std::map<std::string, Group>& families) {
  Plot plot{"How far the truth lies",
            "published standard deviations",
            "share within",
            {},
            false,
            false,
            {0.0, 1.0}};
  Series normal{"normal distribution", {}, true, false, "normal distribution"};
  constexpr int kTenths = 40;
  for (int k = 0; k <= kTenths; ++k) {
    normal.points.emplace_back(0.1 * k, std::erf(0.1 * k / std::numbers::sqrt2));
  }
  plot.lines.push_back(normal);
  for (const auto& [family, group] : families) {
    Series line{family, {}, false, false, family};
    for (int k = 0; k <= kTenths; ++k) {
      line.points.emplace_back(0.1 * k, share_within(group, 0.1 * k));
    }
    plot.lines.push_back(line);
  }
  return plot;
}

Report report_of(const Observations& observations, int scenes) {
  const std::vector<Observation>& all = observations.known;
  Report report;
  std::map<std::string, Group> families;
  std::map<std::tuple<std::string, std::string>, Group> kinds;
  Group shape, length;
  report.data.columns = {"family", "type", "dimension", "published", "truth", "std"};
  for (const Observation& o : all) {
    families[o.family].push_back(&o);
    kinds[{o.type, o.dimension}].push_back(&o);
    (o.dimension == "length" ? length : shape).push_back(&o);
    report.data.row(o.family, o.type, o.dimension, o.published, o.truth, o.std);
  }
  Table by_family{"By scenes", columns_of({"scenes"}), {}};
  for (const auto& [family, group] : families) by_family.add(row_of({family}, group));
  if (!shape.empty()) by_family.add(row_of({"all, of the quadric"}, shape));
  if (!length.empty()) by_family.add(row_of({"all, lengths"}, length));
  Table by_kind{"By dimension", columns_of({"type", "dimension"}), {}};
  for (const auto& [kind, group] : kinds) {
    by_kind.add(row_of({std::get<0>(kind), std::get<1>(kind)}, group));
  }
  report.findings = {
      fmt::format("{} scenes of each family; the dimensions of all surfaces that are found and "
                  "named right. Of a normal distribution 68 % lie within one and 95 % within two "
                  "standard deviations. {} more are published as guesses, without a deviation.",
                  scenes, observations.guesses)};
  if (!shape.empty()) {
    report.findings.push_back(fmt::format(
        "Of {} dimensions {:.0f} % lie within one published standard deviation of the "
        "truth and {:.0f} % within two.",
        shape.size(), 100.0 * share_within(shape, 1.0), 100.0 * share_within(shape, 2.0)));
  }
  report.tables = {by_family, by_kind};
  report.plots = {plot_of(families)};
  return report;
}

}  // namespace

Report run_deviations(const Settings& settings) {
  const int scenes = settings.quick ? 3 : 40;
  Observations all;
  for_each_scene(kDeviationFamilies, scenes, settings,
                 [&](const scene::Scene& made) { observe(scoring::frame_of(made), &all); });
  return report_of(all, scenes);
}

}  // namespace quadrille::experiments
