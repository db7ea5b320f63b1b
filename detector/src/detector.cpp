#include "quadrille/detector/detector.hpp"

#include <algorithm>
#include <chrono>
#include <string>

#include "cloud/cloud_check.hpp"
#include "cloud/far_cloud.hpp"
#include "planes/plane_claims.hpp"
#include "planes/planes.hpp"
#include "samples/inliers.hpp"
#include "samples/sample_tree.hpp"
#include "search/search.hpp"
#include "surfaces/agglomerate.hpp"
#include "surfaces/aggregate.hpp"
#include "surfaces/measure.hpp"
#include "surfaces/plane_surface.hpp"

namespace quadrille {
namespace {

/// Wall time of the stages.
class StageClock {
 public:
  explicit StageClock(DetectionResult* result) : result_(result) {}
  /// Ends a stage; time of the same name adds up.
  void end(const std::string& stage) {
    const auto now = Clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    for (StageTime& known : result_->timings) {
      if (known.stage == stage) {
        known.ms += ms;
        return;
      }
    }
    result_->timings.push_back({stage, ms});
  }
  double total() const {
    return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  DetectionResult* result_;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

/// Samples of a level of which no accepted surface holds half.
std::vector<char> open_samples(const SampleTree& tree, int level,
                               const std::vector<char>& claimed) {
  std::vector<char> open(static_cast<std::size_t>(tree.level(level).size()));
  for (int i = 0; i < tree.level(level).size(); ++i) {
    int balance = 0;
    for (const int k : tree.under(level, i)) balance += claimed[k] ? -1 : 1;
    open[i] = balance > 0;
  }
  return open;
}

/// The candidate with its region in terms of the finest samples on it. Their normals do not count:
/// at fine levels they may be noise.
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

/// Coarse to fine: what a coarse level finds clearly, the finer ones need not search.
Aggregation find_surfaces(const SampleTree& tree, const DetectorOptions& options,
                          StageClock* clock) {
  Aggregation aggregation(tree.finest(), options.aggregate, options.inlier);
  for (int l = kLevels - 1; l >= 0; --l) {
    std::vector<Candidate> candidates =
        search(tree.level(l), open_samples(tree, l, aggregation.claimed()), options.search,
               options.inlier, options.seed + static_cast<std::uint64_t>(l));
    for (Candidate& c : candidates) c = on_finest(std::move(c), tree, l, options.inlier);
    if (options.agglomerate.enabled) {
      candidates =
          agglomerate(std::move(candidates), tree.finest(), options.inlier, options.agglomerate);
    }
    clock->end("search");
    aggregation.offer(std::move(candidates), l > 0);
    clock->end("aggregate");
  }
  return aggregation;
}

bool wanted(QuadricType type, const DetectorOptions& options) {
  return options.only.empty() ||
         std::find(options.only.begin(), options.only.end(), type) != options.only.end();
}

/// Measures the curved surfaces and the planes, and of the samples that both leave the planes.
std::vector<Detection> measure_all(const Aggregation& aggregation,
                                   const std::vector<PlaneRegion>& planes,
                                   const SurfaceSamples& coarse, const SurfaceSamples& finest,
                                   const DetectorOptions& options,
                                   const Eigen::Vector3d& viewpoint) {
  std::vector<Detection> detections;
  const auto report = [&](const Surface& surface) {
    const bool flat = surface.fit.family == Family::kPlane;
    if (flat && is_part_of(surface, finest, planes)) return;
    detections.push_back(measure(surface, finest, viewpoint));
  };
  for (const Surface& surface : aggregation.surfaces()) report(surface);
  if (wanted(QuadricType::kPlane, options)) {
    for (const PlaneRegion& plane : planes) {
      detections.push_back(measure(plane_surface(coarse, plane), coarse, viewpoint));
    }
    // The faces of boxes and the caps of cans have too few coarse samples, and among the finest
    // ones too much passes for flat before the curved surfaces have theirs.
    for (const PlaneRegion& plane : find_planes(finest, options.planes, aggregation.claimed())) {
      report(plane_surface(finest, plane));
    }
  }
  std::erase_if(detections, [&](const Detection& d) { return !wanted(d.type, options); });
  return detections;
}

/// Best score first, of equal ones the larger.
void rank(std::vector<Detection>* detections) {
  std::stable_sort(detections->begin(), detections->end(),
                   [](const Detection& a, const Detection& b) {
                     return a.score != b.score ? a.score > b.score : a.inliers > b.inliers;
                   });
  int id = 0;
  for (Detection& d : *detections) d.id = ++id;
}

/// All stages on a cloud near the origin.
void find_all(const PointCloud& cloud, const DetectorOptions& options, StageClock* clock,
              DetectionResult* result) {
  const std::unique_ptr<CellPyramid> pyramid = make_pyramid(cloud, options.sampling);
  clock->end("cells");
  if (!pyramid) return;
  for (int c = 0; c < pyramid->size(0); ++c) {
    result->points_used += static_cast<std::size_t>(pyramid->count(c));
  }

  const SurfaceSamples coarse = pyramid->coarse_samples();
  const std::vector<PlaneRegion> planes = find_planes(coarse, options.planes);
  const std::vector<char> keep = cells_off_planes(*pyramid, coarse, planes, options.planes.sigmas);
  clock->end("planes");

  const SampleTree tree(*pyramid, pyramid->samples(keep, options.threads));
  clock->end("samples");

  const Aggregation aggregation = find_surfaces(tree, options, clock);
  result->detections =
      measure_all(aggregation, planes, coarse, tree.finest(), options, cloud.viewpoint);
  rank(&result->detections);
  clock->end("measure");
}

}  // namespace

bool seeks_spheres_alone(const DetectorOptions& options) {
  return options.only == std::vector{QuadricType::kSphere};
}

DetectorOptions sphere_options(DetectorOptions options) {
  // Four parameters need no fine cells, few points, and few votes.
  options.sampling.cell *= 2.0;
  options.sampling.stride *= 6;
  options.sampling.noise.patches = std::min(options.sampling.noise.patches, 100);
  options.search.basis = BasisKind::kSphere;
  options.search.bases = std::min(options.search.bases, 2);
  options.search.voters = std::min(options.search.voters, 48);
  options.search.radii = {5.0, 10.0};
  options.search.grow.rounds = std::min(options.search.grow.rounds, 3);
  options.search.grow.families = {Family::kSphere};
  options.aggregate.families = {Family::kSphere};
  options.aggregate.max_residual = 1.6;
  // Of wider cells more lie at an edge.
  options.aggregate.min_confidence = std::min(options.aggregate.min_confidence, 0.3);
  return options;
}

DetectionResult detect(const PointCloud& cloud, const DetectorOptions& given) {
  given.check();
  const DetectorOptions options = seeks_spheres_alone(given) ? sphere_options(given) : given;
  DetectionResult result;
  StageClock clock(&result);
  const CloudCheck check = check_cloud(cloud);
  result.points_finite = check.finite;
  result.warnings = check.warnings;
  if (!check.usable) {
    result.total_ms = clock.total();
    return result;
  }
  if (is_far(check.centre)) {
    const Eigen::Vector3d shift = -check.centre.array().round().matrix();
    find_all(translated(cloud, shift), options, &clock, &result);
    for (Detection& d : result.detections) d = translated(std::move(d), -shift);
  } else {
    find_all(cloud, options, &clock, &result);
  }
  result.total_ms = clock.total();
  return result;
}

}  // namespace quadrille
