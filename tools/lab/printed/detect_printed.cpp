#include "lab/printed/detect_printed.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "detect_with.hpp"
#include "fit/family_spec.hpp"
#include "lab/printed/cluster.hpp"
#include "lab/printed/pool.hpp"
#include "lab/trials/search_samples.hpp"
#include "samples/region.hpp"
#include "surfaces/evidence/confidence.hpp"
#include "surfaces/evidence/sample_blocks.hpp"
#include "surfaces/weigh.hpp"

namespace quadrille::printed {
namespace {

std::vector<Candidate> clustered(std::vector<Candidate> candidates, const SurfaceSamples& samples,
                                 int min_members) {
  std::vector<int> all(static_cast<std::size_t>(samples.size()));
  std::iota(all.begin(), all.end(), 0);
  return cluster(std::move(candidates), normalisation_of(samples, all), samples.size(),
                 min_members);
}

FindCandidates way_of(const PrintedOptions& printed) {
  return [printed](const SampleTree& tree, int level, Mask open,
                   const DetectorOptions& options) -> std::vector<Candidate> {
    if (level >= printed.levels) return {};
    if (printed.pool == 0) return find_candidates(tree, level, std::move(open), options);
    return clustered(pool_hypotheses(tree, level, open, options, printed), tree.finest(),
                     printed.min_members);
  };
}

Detection detection_of(const Quadric& Q, double score, std::size_t inliers) {
  const CanonicalForm form = canonical_form(Q);
  Detection detection;
  detection.type = form.type;
  detection.Q_C = Q.normalized();
  detection.score = score;
  detection.inliers = static_cast<int>(inliers);
  detection.X_CQ = form.X;
  for (const auto& [name, value] : form.dimensions) detection.dimensions.push_back({name, value});
  return detection;
}

/// The confidence in a candidate as it is; nullopt if it hardly bends or is not credible.
std::optional<double> credibility(const EvidenceSource& source, const Candidate& candidate,
                                  const AggregateOptions& options) {
  if (normal_spread(source.samples, candidate.region) < options.min_spread) return std::nullopt;
  const CanonicalForm form = canonical_form(candidate.Q);
  const Evidence evidence = all_evidence(source, candidate.region, candidate.Q, form);
  const double value = confidence(
      confidence_terms(evidence, family_spec(candidate.family).dof, log_prior(form.type)),
      SurfaceKind::kCurved);
  if (value < options.min_confidence) return std::nullopt;
  return value;
}

std::vector<Candidate> candidates_of(const SampleTree& tree, const Settings& settings) {
  const FindCandidates find = way_of(settings.printed);
  std::vector<Candidate> all;
  for (int level = settings.printed.levels - 1; level >= 0; --level) {
    const Mask open(static_cast<std::size_t>(tree.level(level).size()), 1);
    for (Candidate& candidate : find(tree, level, open, settings.detector)) {
      const auto size = static_cast<int>(candidate.region.size());
      if (size >= settings.detector.aggregate.min_samples) all.push_back(std::move(candidate));
    }
  }
  return all;
}

}  // namespace

DetectionResult detect_printed(const PointCloud& cloud, const Settings& settings) {
  const DetectorOptions& options = settings.detector;
  settings.printed.check();
  if (settings.printed.surfaces == Surfaces::kRefitted) {
    return detect_with(way_of(settings.printed), cloud, options);
  }
  options.check();
  DetectionResult result;
  const auto scene = trials::search_samples(cloud, options);
  if (!scene) return result;
  const SurfaceSamples& samples = scene->tree->finest();
  const SampleBlocks blocks(samples);
  const EvidenceSource source{samples, blocks, scene->context, nullptr};
  const auto share_of = [](std::size_t part, int all) {
    return static_cast<double>(part) / static_cast<double>(all);
  };
  for (const PlaneRegion& plane : scene->planes) {
    Vector10d q = Vector10d::Zero();
    q.segment<3>(6) = 0.5 * plane.plane.head<3>();
    q[9] = plane.plane[3];
    result.detections.push_back(detection_of(
        Quadric(q), share_of(plane.samples.size(), scene->coarse.size()), plane.samples.size()));
  }
  for (const Candidate& candidate : clustered(candidates_of(*scene->tree, settings), samples, 1)) {
    const std::optional<double> score = settings.printed.surfaces == Surfaces::kInliers
                                            ? share_of(candidate.region.size(), samples.size())
                                            : credibility(source, candidate, options.aggregate);
    if (!score) continue;
    result.detections.push_back(detection_of(candidate.Q, *score, candidate.region.size()));
  }
  std::stable_sort(result.detections.begin(), result.detections.end(),
                   [](const Detection& a, const Detection& b) { return a.score > b.score; });
  int id = 0;
  for (Detection& detection : result.detections) detection.id = ++id;
  return result;
}

}  // namespace quadrille::printed
