#include "lab/printed/pool.hpp"

#include <cmath>
#include <utility>

#include "base/random.hpp"
#include "fits/linear_system.hpp"
#include "fits/solution_space.hpp"
#include "samples/inliers.hpp"
#include "samples/region.hpp"
#include "samples/sample_buckets.hpp"
#include "search/vote.hpp"
#include "variants/triplet_set.hpp"

namespace quadrille::printed {
namespace {

// Rank of the compact system of three oriented points.
constexpr Eigen::Index kRank = 9;
// A voter decides on λ if its distance from the plane of the basis exceeds this multiple of the
// distance within which it would lie on the quadric anyway.
constexpr double kMinHeightLimits = 2.0;

/// Draws three of the open samples, the others within `radius` cells of the first; nullopt if a
/// basis of them was drawn before, or two of them are one.
std::optional<std::array<int, 3>> draw_triplet(const SurfaceSamples& samples,
                                               const SampleBuckets& buckets,
                                               const std::vector<int>& all, const Mask& open,
                                               double radius, RandomStream& random,
                                               TripletSet* seen) {
  const int first = all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
  const float far = static_cast<float>(radius) * samples.cell[first];
  std::vector<int> near = buckets.near(samples.raw[first], far);
  std::erase_if(near, [&](int i) {
    return i == first || (!open.empty() && !open[i]) ||
           (samples.raw[i] - samples.raw[first]).norm() > far;
  });
  if (near.size() < 2) return std::nullopt;
  const int count = static_cast<int>(near.size());
  const int second = random.below(count), third = random.below(count);
  if (second == third) return std::nullopt;
  const std::array triplet = {first, near[static_cast<std::size_t>(second)],
                              near[static_cast<std::size_t>(third)]};
  if (!seen->insert(triplet)) return std::nullopt;
  return triplet;
}

/// The finest samples that lie on a quadric.
std::vector<int> all_inliers(const SurfaceSamples& samples, const Quadric& quadric,
                             const InlierTest& test) {
  const Eigen::Matrix4f Q = quadric.matrix().cast<float>();
  std::vector<int> region;
  for (int i = 0; i < samples.size(); ++i) {
    if (is_inlier(samples, i, Q, test)) region.push_back(i);
  }
  return region;
}

}  // namespace

std::optional<Pencil> printed_pencil(const std::array<OrientedPoint, 3>& basis, double weight,
                                     double lambda_scale) {
  std::optional<Pencil> pencil = make_pencil(basis);
  if (!pencil) return std::nullopt;
  OrientedPointsd points(3);
  for (Eigen::Index i = 0; i < 3; ++i) {
    points.points.col(i) = basis[static_cast<std::size_t>(i)].x;
    points.normals.col(i) = basis[static_cast<std::size_t>(i)].n;
  }
  const SolutionSpace space = solution_space(compact_system(points, weight));
  if (space.rank != kRank) return std::nullopt;
  pencil->Q0 = Quadric(Vector10d(space.p)).matrix();
  Eigen::Vector4d& plane = pencil->plane;
  const double norm = Quadric(Eigen::Matrix4d(plane * plane.transpose())).coefficients().norm();
  plane *= std::sqrt(lambda_scale / norm);
  return pencil;
}

std::vector<Candidate> pool_hypotheses(const SampleTree& tree, int level, const Mask& open,
                                       const DetectorOptions& options,
                                       const PrintedOptions& printed) {
  const SurfaceSamples& samples = tree.level(level);
  std::vector<int> all;
  double limit = 0.0;
  for (int i = 0; i < samples.size(); ++i) {
    if (!open.empty() && !open[i]) continue;
    all.push_back(i);
    limit += options.inlier.sigmas * samples.sigma[i] + options.inlier.cells * samples.cell[i];
  }
  if (all.empty()) return {};
  limit /= static_cast<double>(all.size());
  const Normalisation scene = normalisation_of(samples, all);
  const OrientedPointsf voters = fit_points(samples, all, scene, options.search.voters);
  VoteOptions how;
  how.bins = printed.bins;
  how.min_cosine = options.inlier.min_cosine;
  how.min_height = kMinHeightLimits * limit / scene.scale;
  const SampleBuckets buckets(samples);
  RandomStream random(options.seed, static_cast<std::uint64_t>(level));
  TripletSet seen;
  std::vector<Candidate> pool;
  for (int trial = 0; trial < printed.pool; ++trial) {
    const auto triplet =
        draw_triplet(samples, buckets, all, open, options.search.radii.back(), random, &seen);
    if (!triplet) continue;
    const OrientedPointsf three = fit_points(samples, *triplet, scene, 3);
    const auto pencil = printed_pencil({three.at(0), three.at(1), three.at(2)}, printed.weight,
                                       printed.lambda_scale);
    if (!pencil) continue;
    for (const VotePeak& peak : vote(*pencil, voters, how)) {
      Candidate candidate;
      candidate.Q = scene.to_frame(pencil->at(peak.lambda)).normalized();
      candidate.region = all_inliers(tree.finest(), candidate.Q, options.inlier);
      if (static_cast<int>(candidate.region.size()) < options.aggregate.min_samples) continue;
      pool.push_back(std::move(candidate));
    }
  }
  return pool;
}

}  // namespace quadrille::printed
