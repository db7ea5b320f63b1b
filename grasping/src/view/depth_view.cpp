#include "view/depth_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "view/gaps.hpp"
#include "view/nearest_depth.hpp"
#include "view/pixel_pitch.hpp"

namespace quadrille {

namespace {

// Beyond 70° off its axis a pinhole has no use.
constexpr double kWidest = 2.7;
// Above what find_pixel_grid() allows: a last check before memory is taken.
constexpr double kMaxPixels = 2e7;

bool in_front(const Eigen::Vector3d& p_V) {
  return p_V.z() > kNearestDepth && std::abs(p_V.x()) < kWidest * p_V.z() &&
         std::abs(p_V.y()) < kWidest * p_V.z();
}

}  // namespace

DepthView::DepthView(const PointCloud& cloud, double baseline, double thin)
    : p_CV_(cloud.viewpoint) {
  stray_.assign(cloud.points.size(), 0);
  if (!p_CV_.allFinite()) return;
  choose_axes(cloud);
  const Projected seen = project(cloud);
  choose_grid(seen.tangents);
  if (!valid()) return;
  keep_nearest(seen);
  // Only in the optical convention are rows those of the sensor, along its baseline.
  const GapRules rules{R_VC_.isIdentity() ? baseline : 0.0, thin};
  filled_ = fill_gaps(depth_, width_, {pitch_u_, pitch_v_}, rules);
  build_levels();
}

void DepthView::choose_axes(const PointCloud& cloud) {
  // So many tell.
  const std::size_t stride = std::max<std::size_t>(1, cloud.points.size() / 20000);
  std::size_t finite = 0, before = 0;
  for (std::size_t n = 0; n < cloud.points.size(); n += stride) {
    const Eigen::Vector3f& p = cloud.points[n];
    if (!p.allFinite()) continue;
    ++finite;
    before += in_front(p.cast<double>() - p_CV_);
  }
  // The optical convention keeps the pixel grid regular; any other frame looks at its points' mean.
  if (before * 20 >= finite * 19) return;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : cloud.points) {
    const Eigen::Vector3d ray = p.cast<double>() - p_CV_;
    if (p.allFinite() && ray.norm() > kNearestDepth) sum += ray.normalized();
  }
  if (sum.norm() < 1e-9) return;
  R_VC_ = Eigen::Quaterniond::FromTwoVectors(sum, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  spread_ = R_VC_.cwiseAbs().rowwise().sum();
}

DepthView::Projected DepthView::project(const PointCloud& cloud) const {
  Projected seen;
  seen.tangents.reserve(cloud.points.size());
  seen.depths.reserve(cloud.points.size());
  seen.points.reserve(cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Eigen::Vector3d p_V = to_view(cloud.points[i].cast<double>());
    if (!cloud.points[i].allFinite() || !in_front(p_V)) continue;
    seen.tangents.emplace_back(p_V.head<2>() / p_V.z());
    seen.depths.push_back(static_cast<float>(p_V.z()));
    seen.points.push_back(static_cast<int>(i));
  }
  return seen;
}

void DepthView::choose_grid(const std::vector<Eigen::Vector2d>& tangents) {
  Eigen::AlignedBox2d bounds;
  for (const Eigen::Vector2d& t : tangents) bounds.extend(t);
  if (tangents.empty()) return;
  const PixelGrid grid = find_pixel_grid(tangents, bounds);
  pitch_u_ = grid.pitch.x();
  pitch_v_ = grid.pitch.y();
  pixels_u_ = 1.0 / pitch_u_;
  pixels_v_ = 1.0 / pitch_v_;
  const Eigen::Vector2d first = (bounds.min() - grid.phase).cwiseQuotient(grid.pitch);
  const Eigen::Vector2d last = (bounds.max() - grid.phase).cwiseQuotient(grid.pitch);
  const double u0 = std::round(first.x()), v0 = std::round(first.y());
  cu_ = -grid.phase.x() / pitch_u_ - u0;
  cv_ = -grid.phase.y() / pitch_v_ - v0;
  const double width = std::round(last.x()) - u0 + 1.0, height = std::round(last.y()) - v0 + 1.0;
  if (!(width * height < kMaxPixels)) return;
  width_ = static_cast<int>(width);
  height_ = static_cast<int>(height);
}

void DepthView::keep_nearest(const Projected& seen) {
  depth_.assign(static_cast<std::size_t>(width_) * height_, 0.0F);
  std::vector<int> nearest(depth_.size(), -1);
  for (std::size_t n = 0; n < seen.points.size(); ++n) {
    const Eigen::Vector2d& t = seen.tangents[n];
    const Eigen::Vector2i uv = pixel({t.x(), t.y(), 1.0});
    if (uv.x() < 0 || uv.x() >= width_ || uv.y() < 0 || uv.y() >= height_) continue;
    const std::size_t at = static_cast<std::size_t>(uv.y()) * width_ + uv.x();
    if (depth_[at] > 0.0F && depth_[at] <= seen.depths[n]) continue;
    depth_[at] = seen.depths[n];
    nearest[at] = seen.points[n];
  }
  refuse_strays(nearest);
  fill_holes();
  fill_holes();
}

void DepthView::refuse_strays(const std::vector<int>& nearest) {
  constexpr int kSupport = 2;
  const std::vector<float> raw = depth_;
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) {
      const std::size_t at = static_cast<std::size_t>(v) * width_ + u;
      if (raw[at] == 0.0F) continue;
      const float tolerance = 0.02F * raw[at];
      const auto like = [&](std::size_t other) {
        return raw[other] > 0.0F && std::abs(raw[other] - raw[at]) < tolerance;
      };
      // Mostly both neighbours in its row are.
      if (u > 0 && u + 1 < width_ && like(at - 1) && like(at + 1)) continue;
      int alike = 0;
      for (int y = std::max(v - 1, 0); y <= std::min(v + 1, height_ - 1) && alike <= kSupport;
           ++y) {
        for (int x = std::max(u - 1, 0); x <= std::min(u + 1, width_ - 1); ++x) {
          alike += like(static_cast<std::size_t>(y) * width_ + x);
        }
      }
      if (alike > kSupport) continue;  // the pixel itself counts once
      depth_[at] = 0.0F;
      stray_[nearest[at]] = 1;
    }
  }
}

void DepthView::fill_holes() {
  const std::vector<float> raw = depth_;
  for (int v = 1; v + 1 < height_; ++v) {
    for (int u = 1; u + 1 < width_; ++u) {
      const std::size_t at = static_cast<std::size_t>(v) * width_ + u;
      if (raw[at] > 0.0F) continue;
      int known = 0;
      float least = std::numeric_limits<float>::max();
      for (int y = v - 1; y <= v + 1; ++y) {
        for (int x = u - 1; x <= u + 1; ++x) {
          const float z = raw[static_cast<std::size_t>(y) * width_ + x];
          if (z == 0.0F) continue;
          ++known;
          least = std::min(least, z);
        }
      }
      if (known >= 3) depth_[at] = least;
    }
  }
}

std::vector<float> DepthView::surface() const {
  std::vector<float> depth = depth_;
  for (std::size_t n = 0; n < depth.size(); ++n) {
    if (depth[n] == 0.0F || filled_[n]) depth[n] = std::numeric_limits<float>::infinity();
  }
  return depth;
}

void DepthView::build_levels() {
  levels_.push_back({width_, height_, depth_, depth_, surface()});
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    const Level& fine = levels_.back();
    Level coarse;
    coarse.width = (fine.width + 1) / 2;
    coarse.height = (fine.height + 1) / 2;
    coarse.near.resize(static_cast<std::size_t>(coarse.width) * coarse.height);
    coarse.far.resize(coarse.near.size());
    coarse.surface.resize(coarse.near.size());
    for (int v = 0; v < coarse.height; ++v) {
      const std::size_t row0 = static_cast<std::size_t>(2 * v) * fine.width;
      const std::size_t row1 =
          static_cast<std::size_t>(std::min(2 * v + 1, fine.height - 1)) * fine.width;
      for (int u = 0; u < coarse.width; ++u) {
        const int u0 = 2 * u, u1 = std::min(2 * u + 1, fine.width - 1);
        const std::size_t at = static_cast<std::size_t>(v) * coarse.width + u;
        coarse.near[at] = std::min(std::min(fine.near[row0 + u0], fine.near[row0 + u1]),
                                   std::min(fine.near[row1 + u0], fine.near[row1 + u1]));
        coarse.far[at] = std::max(std::max(fine.far[row0 + u0], fine.far[row0 + u1]),
                                  std::max(fine.far[row1 + u0], fine.far[row1 + u1]));
        coarse.surface[at] = std::min(std::min(fine.surface[row0 + u0], fine.surface[row0 + u1]),
                                      std::min(fine.surface[row1 + u0], fine.surface[row1 + u1]));
      }
    }
    levels_.push_back(std::move(coarse));
  }
}

int DepthView::nearer_end_of_gap(int u, int v) const {
  // Focal length times baseline over depth, as common sensors have it at half a metre.
  constexpr int kMaxPixels = 20;
  if (u < 0 || v < 0 || u >= width_ || v >= height_) return -1;
  int best = -1;
  for (const int step : {-1, 1}) {
    for (int k = 1; k <= kMaxPixels; ++k) {
      if (!measured(u + k * step, v)) continue;
      if (best < 0 || depth(u + k * step, v) < depth(best, v)) best = u + k * step;
      break;
    }
  }
  return best;
}

double DepthView::depth(int u, int v) const {
  if (u < 0 || v < 0 || u >= width_ || v >= height_) return 0.0;
  return depth_[static_cast<std::size_t>(v) * width_ + u];
}

}  // namespace quadrille
