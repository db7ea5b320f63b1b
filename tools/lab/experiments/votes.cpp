#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "lab/experiments/experiments.hpp"
#include "lab/experiments/measure.hpp"
#include "lab/experiments/neighbourhood.hpp"
#include "search/vote.hpp"
#include "variants/gradient_scales.hpp"

namespace quadrille::experiments {
namespace {

constexpr double kForeign = 0.3;

/// The vote of one point for λ.
struct Ballot {
  double lambda;
  /// True if the point's normal agrees with the gradient there, so that the vote counts.
  bool counts;
};

/// A basis, its highest peaks and their numbers of votes.
struct Election {
  Pencil pencil;
  std::vector<VotePeak> peaks;
};

std::optional<Election> hold_election(const Neighbourhood& from, const VoteOptions& options,
                                      RandomStream& random) {
  std::array<OrientedPoint, 3> basis;
  for (OrientedPoint& point : basis) {
    point = from.points.at(random.below(static_cast<int>(from.points.size())));
  }
  const auto pencil = make_scaled_pencil(basis, kScaleSoftness);
  if (!pencil) return std::nullopt;
  Election election{*pencil, vote(*pencil, from.voters, options)};
  if (election.peaks.empty()) return std::nullopt;
  return election;
}

/// Returns the election whose winner has the most votes.
std::optional<Election> clearest(const Neighbourhood& from, const VoteOptions& options, int bases,
                                 RandomStream& random) {
  std::optional<Election> best;
  for (int k = 0; k < bases; ++k) {
    const auto one = hold_election(from, options, random);
    if (one && (!best || one->peaks[0].votes > best->peaks[0].votes)) best = one;
  }
  return best;
}

std::vector<Ballot> ballots_of(const Pencil& pencil, const OrientedPointsd& points,
                               const VoteOptions& options) {
  std::vector<Ballot> ballots;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const OrientedPoint point = points.at(i);
    const Eigen::Vector4d X = point.x.homogeneous();
    const double z = pencil.plane.dot(X);
    if (std::abs(z) < options.min_height) continue;
    const double lambda = -X.dot(pencil.Q0 * X) / (z * z);
    const Eigen::Vector3d g = Quadric(pencil.at(lambda)).gradient(point.x);
    ballots.push_back({lambda, g.dot(point.n) > options.min_cosine * g.norm()});
  }
  return ballots;
}

double place(double lambda, const VoteOptions& options) {
  return options.quantisation.place_of(static_cast<float>(lambda));
}

/// Returns the share of the ballots in each bin, over all ballots or over those that count.
std::vector<double> bins_of(const std::vector<Ballot>& ballots, bool all,
                            const VoteOptions& options) {
  std::vector<double> bins(static_cast<std::size_t>(options.bins), 0.0);
  for (const Ballot& ballot : ballots) {
    if (!all && !ballot.counts) continue;
    const int bin = static_cast<int>(place(ballot.lambda, options) * options.bins);
    ++bins[static_cast<std::size_t>(std::clamp(bin, 0, options.bins - 1))];
  }
  return bins;
}

/// Returns the outline of a histogram over 0 to 1.
Series steps(const std::string& name, const std::vector<double>& bins, bool dashed) {
  Series line{name, {}, dashed};
  const double width = 1.0 / static_cast<double>(bins.size());
  for (std::size_t k = 0; k < bins.size(); ++k) {
    line.points.emplace_back(width * static_cast<double>(k), bins[k]);
    line.points.emplace_back(width * (static_cast<double>(k) + 1.0), bins[k]);
  }
  return line;
}

/// Returns the median λ of the exact points, which would all agree if the basis were exact as well.
double true_lambda(const Pencil& pencil, const OrientedPointsd& truth, const VoteOptions& options) {
  std::vector<double> values;
  for (const Ballot& ballot : ballots_of(pencil, truth, options)) values.push_back(ballot.lambda);
  return quantile(values, 0.5);
}

}  // namespace

Report run_votes(const Settings& settings) {
  VoteOptions options;
  options.min_height = 0.1;
  RandomStream random(settings.seed, 0);
  const Neighbourhood around = random_neighbourhood({.outliers = kForeign}, random);
  const auto best = clearest(around, options, settings.quick ? 250 : 500, random);
  settings.progress(1.0);
  if (!best) return {{"No basis has votes."}, {}, {}, {}};
  const std::vector<Ballot> ballots = ballots_of(best->pencil, around.points, options);
  const std::vector<double> all = bins_of(ballots, true, options),
                            counted = bins_of(ballots, false, options);
  const double truth = true_lambda(best->pencil, around.truth, options);
  const double top = *std::max_element(all.begin(), all.end());
  Report report;
  Plot plot{"Votes for λ of one basis", "place of λ: 1/2 + atan(λ/λ₀)/π", "votes", {}};
  plot.lines = {steps("all points", all, true), steps("normal agrees: votes", counted, false)};
  plot.lines.push_back({.name = "peaks, smoothed", .points = {}, .drawn = Drawn::kPieces});
  for (const VotePeak& peak : best->peaks) {
    const double at = place(peak.lambda, options);
    plot.lines.back().points.insert(plot.lines.back().points.end(), {{at, 0.0}, {at, peak.votes}});
  }
  const double at = place(truth, options);
  plot.lines.push_back(
      {.name = "λ of the quadric", .points = {{at, 0.0}, {at, top}}, .dashed = true});
  report.plots = {plot};
  const double found = best->peaks.front().lambda;
  report.findings = {fmt::format(
      "One of 300 points' bases, {:.0f} % of them foreign, noise 1 % of the radius: the "
      "highest peak is at λ = {}, the quadric at {}; {} of {} points vote there, and "
      "the quadric is {}.",
      100.0 * kForeign, number(found), number(truth), number(best->peaks[0].votes), ballots.size(),
      is_found(Quadric(best->pencil.at(found)), around, 0.06) ? "found" : "not found")};
  report.data.columns = {"place", "all", "votes"};
  for (std::size_t k = 0; k < all.size(); ++k) {
    report.data.row((static_cast<double>(k) + 0.5) / static_cast<double>(all.size()), all[k],
                    counted[k]);
  }
  return report;
}

}  // namespace quadrille::experiments
