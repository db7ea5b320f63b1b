#include <fmt/format.h>

#include <algorithm>

#include "lab/experiments/cylinder_match.hpp"
#include "lab/experiments/experiments.hpp"
#include "lab/experiments/generated_scenes.hpp"
#include "lab/experiments/measure.hpp"
#include "lab/experiments/pair_features.hpp"
#include "lab/scene/bin.hpp"
#include "lab/scoring/score.hpp"
#include "lab/trials/search_samples.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille::experiments {
namespace {

constexpr int kCounts[] = {8, 20, 40};
constexpr double kNoises[] = {0.25, 0.5, 1.0};
/// Least visible share of the side's pixels, relative to those visible without other bodies, at
/// which a cylinder has to be found.
constexpr double kMinSeen = 0.4;

/// The results at one level of clutter and noise.
struct CylinderOutcome {
  int cylinders;
  double noise;
  /// Number of cylinders found with the right axis and radius; the score counts those found as any
  /// quadric.
  int exact = 0;
  scoring::FrameScore score;
  std::vector<double> times;
  /// The same count for the matcher of point pairs, and the number of cylinders that it claims.
  int matched = 0, claimed = 0;
  std::vector<double> match_times;
};

/// Runs the matcher of point pairs, which knows radius and length, on a cloud. It starts from the
/// detector's finest samples off the planes.
DetectionResult match_cloud(const PointCloud& cloud) {
  const auto samples = trials::search_samples(cloud, {});
  DetectionResult result;
  if (!samples) return result;
  const SurfaceSamples& all = samples->tree->finest();
  OrientedPointsd points(all.size());
  double cell = 0.0;
  for (int i = 0; i < all.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    points.points.col(i) = all.p[k].cast<double>();
    points.normals.col(i) = all.n[k].cast<double>();
    cell += all.cell[k] / all.size();
  }
  for (const KnownCylinder& cylinder : match_pairs(points, cell, {})) {
    Detection& found = result.detections.emplace_back();
    found.type = QuadricType::kCylinder;
    found.dimensions = {{"radius", cylinder.radius}};
    found.X_CQ.translation() = cylinder.centre_C;
    found.X_CQ.linear() =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), cylinder.axis_C)
            .toRotationMatrix();
  }
  return result;
}

void run(const scene::Scene& made, CylinderOutcome* outcome) {
  scoring::Frame frame = scoring::frame_of(made);
  frame.noise = outcome->noise;
  std::vector<KnownCylinder> known;
  for (scoring::TrueSurface& surface : frame.surfaces) {
    surface.sigma = scene::depth_noise(outcome->noise, surface.X_CS.translation().z());
    if (!surface.curved) continue;
    const auto id = static_cast<std::size_t>(surface.id);
    const int visible = made.ideal.visible[id];
    surface.evaluate = visible >= kMinPixels && visible >= kMinSeen * made.ideal.alone[id];
    if (!surface.evaluate) continue;
    known.push_back(
        {surface.X_CS.translation(), surface.X_CS.linear().col(2), surface.box_S.max().x()});
  }
  DetectionResult result;
  outcome->times.push_back(1e-3 * microseconds([&] { result = detect(frame.cloud); }));
  for (const char found : found_cylinders(result, known)) outcome->exact += found;
  outcome->score += scoring::score(frame, scoring::findings_of(result));
  outcome->match_times.push_back(1e-3 * microseconds([&] { result = match_cloud(frame.cloud); }));
  for (const char found : found_cylinders(result, known)) outcome->matched += found;
  outcome->claimed += static_cast<int>(result.detections.size());
}

scene::Scene make_bin(int cylinders, std::uint64_t seed) {
  scene::Scene made;
  scene::BinOptions options;
  options.cylinders = cylinders;
  scene::Random random(seed, static_cast<std::uint64_t>(cylinders));
  made.layout = scene::fill_bin(options, &random);
  made.ideal = scene::render(made.camera, made.layout.bodies, made.layout.X_CW);
  return made;
}

void observe(double noise, std::uint64_t seed, scene::Scene* made) {
  scene::FamilyTraits traits = scene::traits_of(scene::Family::kMedium);
  traits.noise = noise;
  scene::Random pixels(seed, 1);
  made->view = scene::observe(made->camera, made->ideal, traits, &pixels);
}

std::string percent(int part, int whole) {
  return whole ? fmt::format("{:.1f} %", 100.0 * part / whole) : "-";
}

Report report_of(const std::vector<CylinderOutcome>& outcomes, int bins) {
  Report report;
  Table table{"Cylinders of which enough is seen",
              {"cylinders a bin", "noise [mm]", "asked for", "axis and radius right", "any quadric",
               "precision", "detection [ms]", "pairs matched", "claimed", "matching [ms]"},
              {}};
  report.data.columns = {"cylinders", "noise",     "known",   "exact",   "any",
                         "wrong",     "median_ms", "matched", "claimed", "match_ms"};
  Plot plot{"Cylinders found", "cylinders a bin", "share", {}, false, false, {0.0, 1.0}};
  int known = 0, exact = 0, any = 0, matched = 0;
  const double height = scene::BinOptions().height;
  for (const CylinderOutcome& o : outcomes) {
    const double ms = quantile(o.times, 0.5);
    known += o.score.wanted, exact += o.exact, any += o.score.found;
    matched += o.matched;
    table.row(o.cylinders, 1e3 * scene::depth_noise(o.noise, height), o.score.wanted,
              percent(o.exact, o.score.wanted), percent(o.score.found, o.score.wanted),
              fmt::format("{:.3f}", o.score.precision()), ms, percent(o.matched, o.score.wanted),
              o.claimed, quantile(o.match_times, 0.5));
    report.data.row(o.cylinders, o.noise, o.score.wanted, o.exact, o.score.found, o.score.wrong, ms,
                    o.matched, o.claimed, quantile(o.match_times, 0.5));
  }
  for (const double noise : kNoises) {
    const std::string name =
        fmt::format("noise {:.2g} mm", 1e3 * scene::depth_noise(noise, height));
    Series right{name + ", axis and radius", {}, false, false, name},
        covered{name + ", any quadric", {}, true, false, name};
    for (const CylinderOutcome& o : outcomes) {
      if (o.noise != noise || !o.score.wanted) continue;
      right.points.emplace_back(o.cylinders, static_cast<double>(o.exact) / o.score.wanted);
      covered.points.emplace_back(o.cylinders, static_cast<double>(o.score.found) / o.score.wanted);
    }
    plot.lines.push_back(right);
    plot.lines.push_back(covered);
  }
  report.findings = {
      fmt::format("{} bins at each clutter and noise; asked for are cylinders of which {:.0f} % of "
                  "the pixels that their side would have alone, and {} pixels, are seen. Right: "
                  "axis to 5° and a fifth of the radius, radius to a tenth.",
                  bins, 100.0 * kMinSeen, kMinPixels),
      fmt::format(
          "Of {} cylinders {} are found with axis and radius, {} with any quadric, and {} by a "
          "matcher of point pairs that is told radius and length.",
          known, percent(exact, known), percent(any, known), percent(matched, known))};
  report.tables = {table};
  report.plots = {plot};
  return report;
}

}  // namespace

Report run_cylinders(const Settings& settings) {
  const int bins = settings.quick ? 1 : 12;
  std::vector<CylinderOutcome> outcomes;
  for (const int cylinders : kCounts) {
    for (const double noise : kNoises) {
      outcomes.push_back(
          {.cylinders = cylinders, .noise = noise, .score = {}, .times = {}, .match_times = {}});
    }
  }
  double done = 0.0;
  for (int k = 0; k < bins; ++k) {
    const std::uint64_t seed = settings.seed * 1000 + static_cast<std::uint64_t>(k);
    for (const int cylinders : kCounts) {
      scene::Scene made = make_bin(cylinders, seed);
      for (CylinderOutcome& outcome : outcomes) {
        if (outcome.cylinders != cylinders) continue;
        observe(outcome.noise, seed, &made);
        run(made, &outcome);
        settings.progress(++done / (bins * static_cast<double>(outcomes.size())));
      }
    }
  }
  return report_of(outcomes, bins);
}

}  // namespace quadrille::experiments
