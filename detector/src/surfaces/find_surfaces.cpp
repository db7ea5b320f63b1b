#include "surfaces/find_surfaces.hpp"

#include <iterator>
#include <optional>
#include <utility>

#include "planes/planes.hpp"
#include "quadrille/detector/parallel_for.hpp"
#include "samples/inliers.hpp"
#include "search/axes/axis_votes.hpp"
#include "search/axes/coaxial.hpp"
#include "search/search.hpp"
#include "surfaces/evidence/upright.hpp"

namespace quadrille {
namespace {

// Number of candidates that explain a sample of the coarsest level before it is no longer a seed.
// Chance decides whether a candidate becomes a good surface. The coarsest level has the fewest
// samples, so several candidates cost little there, and those that are refused are offered again on
// the finer levels.
constexpr int kCoarsestCovers = 3;

/// Marks the samples of a level of which accepted surfaces hold less than half.
Mask open_samples(const SampleTree& tree, int level, const Mask& free) {
  Mask open(static_cast<std::size_t>(tree.level(level).size()));
  for (int i = 0; i < tree.level(level).size(); ++i) {
    int balance = 0;
    for (const int k : tree.under(level, i)) balance += free[k] ? 1 : -1;
    open[i] = balance > 0;
  }
  return open;
}

/// Replaces a candidate's region by the finest samples under it that lie on its quadric. Their
/// normals are ignored, since at fine levels they may be noise.
Candidate on_finest(Candidate candidate, const SampleTree& tree, int level, InlierTest test) {
  test.min_cosine = -1.0;
  const Eigen::Matrix4f Q = candidate.Q.matrix().cast<float>();
  std::vector<int> fine;
  for (const int i : candidate.region) {
    for (const int k : tree.under(level, i)) {
      if (is_inlier(tree.finest(), k, Q, test)) fine.push_back(k);
    }
  }
  candidate.region = std::move(fine);
  return candidate;
}

/// Candidates about the axes on which things may stand. The wide samples suffice to vote; necks and
/// rims need the finest to be found.
std::vector<Candidate> standing_candidates(const SampleTree& tree, const Eigen::Vector3d& up,
                                           const DetectorOptions& options) {
  const std::vector<Axis> axes = vote_for_axes(tree.level(1), {}, up, options.search.axes);
  return coaxial_candidates(tree.finest(), {}, axes, options.inlier, options.aggregate.min_samples,
                            options.threads);
}

/// Axes of accepted surfaces, which may lie or lean.
std::vector<Axis> axes_of(const std::vector<Surface>& surfaces) {
  std::vector<Axis> axes;
  for (const Surface& surface : surfaces) {
    const CanonicalForm form = form_of(surface);
    if (is_flat(surface) || !has_axis(form.type)) continue;
    axes.push_back({form.X.translation(), form.X.linear().col(2)});
  }
  return axes;
}

}  // namespace

std::vector<Candidate> find_candidates(const SampleTree& tree, int level, Mask open,
                                       const DetectorOptions& options, Propose propose) {
  // The few samples of the coarsest level are searched beside the axes. A caller's own way to
  // propose may remember what it proposed before.
  const bool coarsest = level == kLevels - 1;
  const int threads = coarsest || propose ? 1 : options.threads;
  std::vector<Candidate> candidates =
      search(tree.level(level), std::move(open), options.search, options.inlier,
             options.seed + static_cast<std::uint64_t>(level), std::move(propose),
             coarsest ? kCoarsestCovers : 1, threads);
  for (Candidate& c : candidates) c = on_finest(std::move(c), tree, level, options.inlier);
  return candidates;
}

Aggregation find_surfaces(const SampleTree& tree, SceneContext context,
                          const DetectorOptions& options, StageClock& clock, TrialObserver observer,
                          const FindCandidates& find) {
  const std::optional<Eigen::Vector3d> up = context.up;
  Aggregation aggregation(tree.finest(), options.aggregate, options.inlier, std::move(context),
                          std::move(observer), options.threads);
  for (int level = kLevels - 1; level >= 0; --level) {
    Mask open = open_samples(tree, level, aggregation.free());
    const bool with_standing = level == kLevels - 1 && up;
    std::vector<Candidate> candidates, standing;
    parallel_for(with_standing ? 2 : 1, options.threads, [&](int task) {
      if (task == 1) {
        standing = standing_candidates(tree, *up, options);
      } else if (find) {
        candidates = find(tree, level, std::move(open), options);
      } else {
        candidates = find_candidates(tree, level, std::move(open), options);
      }
    });
    std::move(standing.begin(), standing.end(), std::back_inserter(candidates));
    clock.end("search");
    aggregation.offer(std::move(candidates),
                      level > 0 ? SearchLevel::kCoarse : SearchLevel::kFinest);
    clock.end("aggregate");
  }
  aggregation.divide();
  // The small pieces of a body share the axis of a larger one.
  if (options.search.axes > 0) {
    aggregation.offer(
        coaxial_candidates(tree.finest(), aggregation.free(), axes_of(aggregation.surfaces()),
                           options.inlier, options.aggregate.min_samples, options.threads),
        SearchLevel::kFinest);
    clock.end("aggregate");
  }
  // The faces of boxes and the caps of cans have too few coarse samples for the first search for
  // planes. Among the finest samples they are sought last, since before that many curved surfaces
  // would pass for flat.
  aggregation.offer_planes(find_planes(tree.finest(), options.planes, aggregation.free()));
  clock.end("aggregate");
  return aggregation;
}

}  // namespace quadrille
