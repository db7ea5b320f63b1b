#include "quadrille/detector/detector.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "quadrille/detector/aggregate.hpp"
#include "quadrille/detector/depth_cells.hpp"
#include "quadrille/detector/depth_samples.hpp"
#include "quadrille/detector/model_selection.hpp"
#include "quadrille/detector/noise.hpp"
#include "quadrille/detector/planes.hpp"
#include "quadrille/detector/region.hpp"
#include "quadrille/detector/search.hpp"

namespace quadrille {
namespace {

class StageClock {
 public:
  explicit StageClock(DetectionResult* result) : result_(result) {}
  void mark(const char* stage) {
    const auto now = std::chrono::steady_clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
    for (StageTime& t : result_->timings) {
      if (t.stage == stage) {
        t.ms += ms;
        last_ = now;
        return;
      }
    }
    result_->timings.push_back({stage, ms});
    last_ = now;
  }
  void finish() {
    result_->total_ms = std::chrono::duration<double, std::milli>(
                            std::chrono::steady_clock::now() - start_).count();
  }

 private:
  DetectionResult* result_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(), last_ = start_;
};

}  // namespace

DetectionResult detect(const PointCloud& cloud, const DetectorOptions& options) {
  options.check();
  DetectionResult result;
  StageClock clock(&result);
  const auto view = find_view(cloud);
  if (!view) { result.warnings.push_back("no view"); clock.finish(); return result; }
  clock.mark("view");
  // cell size
  std::vector<float> depth;
  for (std::size_t i = 0; i < cloud.points.size(); i += 101) {
    const Eigen::Vector3f q = view->X_VC * cloud.points[i];
    if (q.z() > 0) depth.push_back(q.z());
  }
  std::nth_element(depth.begin(), depth.begin() + depth.size() * 3 / 10, depth.end());
  const float z = depth[depth.size() * 3 / 10];
  const int pixels = std::clamp(static_cast<int>(std::lround(0.0036 / (view->pitch * z))), 1, 16);
  std::array<DepthCells, 3> cells;
  cells[0] = make_depth_cells(cloud, *view, pixels);
  cells[1] = coarser(cells[0], {});
  cells[2] = coarser(cells[1], {});
  clock.mark("cells");
  const std::vector<NoiseModel> noise = measure_noise(cells, {});
  for (int l = 0; l < 3; ++l) {
    if (getenv("QDEBUG")) fprintf(stderr, "level %d: pixels %d %dx%d noise %.5f exp %.2f sigma(z=%.2f) %.5f\n", l, cells[l].pixels, cells[l].width, cells[l].height, noise[l].factor, noise[l].exponent, z, noise[l].sigma(z));
  }
  clock.mark("noise");
  std::vector<char> keep(cells[0].size(), 1);
  const SurfaceSamples coarse = make_depth_samples(cells[2], {}, noise[2], 1);
  const std::vector<PlaneRegion> planes = find_planes(coarse, {});
  {
    std::vector<std::vector<int>> plane_of(cells[2].size());
    for (std::size_t k = 0; k < planes.size(); ++k) {
      for (const int s : planes[k].samples) {
        const int c = coarse.source[s], ci = c % cells[2].width, cj = c / cells[2].width;
        for (int y = std::max(0, cj - 1); y <= std::min(cells[2].height - 1, cj + 1); ++y)
          for (int x = std::max(0, ci - 1); x <= std::min(cells[2].width - 1, ci + 1); ++x) {
            auto& list = plane_of[y * cells[2].width + x];
            if (list.empty() || list.back() != static_cast<int>(k)) list.push_back(static_cast<int>(k));
          }
      }
    }
    const Eigen::Isometry3f X_CV = view->X_VC.inverse();
    for (int c = 0; c < cells[0].size(); ++c) {
      if (!cells[0].count[c]) continue;
      const int x = c % cells[0].width, y = c / cells[0].width;
      const Eigen::Vector3f p = X_CV * cells[0].position_V(c);
      for (const int k : plane_of[(y / 4) * cells[2].width + x / 4]) {
        const double d = planes[k].plane.head<3>().dot(p.cast<double>()) + planes[k].plane[3];
        if (std::abs(d) < 3 * noise[0].sigma(1 / cells[0].w[c])) keep[c] = 0;
      }
    }
  }
  clock.mark("planes");
  std::array<DepthCells, 3> rest;
  rest[0] = cells[0];
  rest[1] = coarser(rest[0], keep);
  rest[2] = coarser(rest[1], {});
  std::array<SurfaceSamples, 3> samples;
  for (int l = 0; l < 3; ++l) samples[l] = make_depth_samples(rest[l], l ? std::vector<char>{} : keep, noise[l], 2);
  clock.mark("samples");
  SearchOptions search_options;
  std::vector<int> sample_of0(cells[0].size(), -1), sample_of1(cells[1].size(), -1);
  for (int i = 0; i < samples[0].size(); ++i) sample_of0[samples[0].source[i]] = i;
  for (int i = 0; i < samples[1].size(); ++i) sample_of1[samples[1].source[i]] = i;
  SurfaceSamples finest = samples[0];
  for (int i = 0; i < finest.size(); ++i) {
    const int c = finest.source[i];
    const int k = sample_of1[(c / rest[0].width / 2) * rest[1].width + (c % rest[0].width) / 2];
    if (k >= 0) finest.n[i] = (finest.n[i] + samples[1].n[k]).normalized();
  }
  Aggregation aggregation(finest, {});
  for (int l = 2; l >= 0; --l) {
    std::vector<char> open(samples[l].p.size());
    const int span = 1 << l;
    for (int s = 0; s < samples[l].size(); ++s) {
      const int cell = samples[l].source[s];
      const int cx = cell % rest[l].width, cy = cell / rest[l].width;
      int free = 0, taken = 0;
      for (int y = cy * span; y < std::min(rest[0].height, (cy + 1) * span); ++y)
        for (int x = cx * span; x < std::min(rest[0].width, (cx + 1) * span); ++x) {
          const int i = sample_of0[y * rest[0].width + x];
          if (i < 0) continue;
          ++(aggregation.claimed()[i] ? taken : free);
        }
      open[s] = free > taken;
    }
    std::vector<Candidate> candidates = search(samples[l], open, search_options, options.seed + l);
    for (Candidate& c : candidates) {
      std::vector<int> fine;
      const Eigen::Matrix4f Q = c.Q.matrix().cast<float>();
      for (const int s : c.region) {
        const int cell = samples[l].source[s];
        const int cx = cell % rest[l].width, cy = cell / rest[l].width;
        for (int y = cy * span; y < std::min(rest[0].height, (cy + 1) * span); ++y)
          for (int x = cx * span; x < std::min(rest[0].width, (cx + 1) * span); ++x) {
            const int i = sample_of0[y * rest[0].width + x];
            if (i < 0) continue;
            InlierTest test = search_options.inlier;
            test.least_cosine = -1;
            if (is_inlier(samples[0], i, Q, test)) fine.push_back(i);
          }
      }
      c.region = std::move(fine);
    }
    if (getenv("QDEBUG")) fprintf(stderr, "level %d: samples %d candidates %zu\n", l, samples[l].size(), candidates.size());
    clock.mark(l == 0 ? "search0" : l == 1 ? "search1" : "search2");
    aggregation.offer(std::move(candidates), l > 0);
    clock.mark(l == 0 ? "select0" : l == 1 ? "select1" : "select2");
  }
  for (const Surface& s : aggregation.surfaces()) {
    Detection d;
    d.id = result.detections.size() + 1;
    d.Q_C = s.Q;
    d.rms = s.rms;
    d.inliers = s.region.size();
    d.score = 0.5;
    switch (s.fit.family) {
      case Family::kPlane: d.type = QuadricType::kPlane; break;
      case Family::kSphere: d.type = QuadricType::kSphere; break;
      case Family::kCylinder: d.type = QuadricType::kCylinder; break;
      case Family::kCone: d.type = QuadricType::kCone; break;
      case Family::kParaboloid: d.type = QuadricType::kEllipticParaboloid; break;
      case Family::kRevolution: d.type = QuadricType::kEllipsoid; break;
      case Family::kEllipticCylinder: d.type = QuadricType::kEllipticCylinder; break;
      case Family::kGeneral: d.type = QuadricType::kHyperboloidOneSheet; break;
    }
    const Evidence& e = s.evidence;
    d.dimensions = {{"log_count", e.log_count}, {"spread", e.spread}, {"n1", e.smooth_border}, {"two_planes", e.two_planes}, {"share", s.effective_size}, {"dof", double(family_spec(s.fit.family).dof)}};
    d.score = s.confidence;
    result.detections.push_back(d);
  }
  clock.mark("select");
  for (const PlaneRegion& p : planes) {
    Detection d;
    Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
    Q.topRightCorner<3, 1>() = Q.bottomLeftCorner<1, 3>().transpose() = 0.5 * p.plane.head<3>();
    Q(3, 3) = p.plane[3];
    d.Q_C = Quadric(Q).normalized();
    d.type = QuadricType::kPlane;
    d.inliers = p.samples.size() * 16;
    d.score = 1;
    result.detections.push_back(d);
  }
  clock.finish();
  return result;
}

}  // namespace quadrille
