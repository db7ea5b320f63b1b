#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "lab/experiments/experiments.hpp"
#include "lab/experiments/generated_scenes.hpp"
#include "lab/experiments/random_quadric.hpp"
#include "lab/experiments/section.hpp"
#include "lab/scoring/score.hpp"
#include "quadrille/detector/detector.hpp"
#include "search/vote.hpp"
#include "variants/gradient_scales.hpp"

namespace quadrille::experiments {
namespace {

constexpr int kPoints = 400;
/// Noise of the points in radii of the neighbourhood, and of a normal's components [rad].
constexpr double kPointNoise = 0.01, kTurn = 0.05;
/// Largest distance of a point that lies on a hypothesis, in radii.
constexpr double kOnSurface = 0.03;

/// Returns points of two planes in the unit ball that meet at this angle in the edge y and open
/// downward.
OrientedPointsd wedge(double degrees, RandomStream& random) {
  OrientedPointsd points(kPoints);
  const double slope = 0.5 * degrees * M_PI / 180.0;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const double side = i % 2 ? 1.0 : -1.0, along = 0.95 * random.uniform();
    points.points.col(i) << side * along * std::sin(slope), 1.4 * random.uniform() - 0.7,
        -along * std::cos(slope);
    points.normals.col(i) << side * std::cos(slope), 0.0, std::sin(slope);
  }
  add_point_noise(&points, kPointNoise, random);
  add_normal_noise(&points, kTurn, random);
  return points;
}

int count_on(const Quadric& Q, const OrientedPointsd& points) {
  int count = 0;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d x = points.points.col(i), g = Q.gradient(x);
    count += std::abs(Q.distance(x)) < kOnSurface && g.dot(points.normals.col(i)) > 0.85 * g.norm();
  }
  return count;
}

/// A hypothesis and the number of points that lie on it.
struct Winner {
  Quadric Q;
  int support = 0;
};

/// Returns the quadric of the vote with the most points, as in the paper's method without removal
/// of planes.
Winner best_vote(const OrientedPointsd& points, int bases, RandomStream& random) {
  OrientedPointsf voters(points.size());
  voters.points = points.points.cast<float>();
  voters.normals = points.normals.cast<float>();
  Winner best;
  for (int k = 0; k < bases; ++k) {
    std::array<OrientedPoint, 3> basis;
    for (OrientedPoint& point : basis) point = points.at(random.below(kPoints));
    const auto pencil = make_scaled_pencil(basis, kScaleSoftness);
    if (!pencil) continue;
    for (const VotePeak& peak : vote(*pencil, voters, {})) {
      const Quadric Q(pencil->at(peak.lambda));
      const int support = count_on(Q, points);
      if (support > best.support) best = {Q, support};
    }
  }
  return best;
}

Plot draw_wedge(double degrees, const OrientedPointsd& points, const Winner& winner) {
  const SectionPlane plane{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(),
                           Eigen::Vector3d::UnitZ()};
  Plot plot{fmt::format("Two planes at {:g}°, and the quadric that most points lie on", degrees),
            "across the edge",
            "height",
            {}};
  plot.equal_axes = true;
  Series dots{.name = "points of the planes", .points = {}, .drawn = Drawn::kDots};
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    dots.points.emplace_back(points.points(0, i), points.points(2, i));
  }
  plot.lines = {dots,
                {.name = fmt::format("quadric, {:.0f} % of the points on it",
                                     100.0 * winner.support / kPoints),
                 .points = section(winner.Q, plane, 1.2),
                 .way = "quadric",
                 .drawn = Drawn::kPieces}};
  return plot;
}

/// Compares the whole detector with and without the removal of planes before the search.
Table whole_detector(const Settings& settings) {
  DetectorOptions first, without;
  // No plane has this many samples.
  without.planes.min_samples = 1000000;
  scoring::FrameScore scores[2];
  for_each_scene(
      {scene::Family::kMedium}, settings.quick ? 2 : 16, settings, [&](const scene::Scene& made) {
        const scoring::Frame frame = scoring::frame_of(made);
        scores[0] += scoring::score(frame, scoring::findings_of(detect(frame.cloud, first)));
        scores[1] += scoring::score(frame, scoring::findings_of(detect(frame.cloud, without)));
      });
  Table table{"Medium scenes, the whole detector",
              {"planes", "curved surfaces", "found", "curved that are none", "planes found"},
              {}};
  for (int k = 0; k < 2; ++k) {
    table.row(k ? "not taken out" : "taken out first", scores[k].wanted, scores[k].found,
              scores[k].wrong, fmt::format("{:.3f}", scores[k].plane_recall()));
  }
  return table;
}

}  // namespace

Report run_planes(const Settings& settings) {
  Report report;
  report.data.columns = {"degrees", "type", "support", "points"};
  for (const double degrees : {60.0, 90.0, 150.0}) {
    RandomStream random(settings.seed, static_cast<std::uint64_t>(degrees));
    const OrientedPointsd points = wedge(degrees, random);
    const Winner winner = best_vote(points, settings.quick ? 100 : 1000, random);
    const std::string type(to_string(canonical_form(winner.Q).type));
    report.data.row(degrees, type, winner.support, kPoints);
    report.findings.push_back(fmt::format(
        "Two planes at {:g}°: the quadric that most points lie on, {} of {}, is of type "
        "{}.",
        degrees, winner.support, kPoints, type));
    report.plots.push_back(draw_wedge(degrees, points, winner));
  }
  report.tables = {whole_detector(settings)};
  return report;
}

}  // namespace quadrille::experiments
