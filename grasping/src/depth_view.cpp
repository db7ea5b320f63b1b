#include "quadrille/grasping/depth_view.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "gaps.hpp"
#include "pixel_pitch.hpp"

namespace quadrille {

namespace {

constexpr double kNearest = 0.02;
// Beyond 70° off its axis a pinhole has no use.
constexpr double kWidest = 2.7;
// Above what find_pixel_grid() allows: a last check before memory is taken.
constexpr double kMostPixels = 2e7;

bool in_front(const Eigen::Vector3d& p_V) {
  return p_V.z() > kNearest && std::abs(p_V.x()) < kWidest * p_V.z() &&
         std::abs(p_V.y()) < kWidest * p_V.z();
}

// The nearest whole number below or above, of at most 1e8: std::floor is a call on plain x86-64.
int whole_below(double x) {
  x = std::clamp(x, -1e8, 1e8);
  const int n = static_cast<int>(x);
  return n - (x < n);
}
int whole_above(double x) { return -whole_below(-x); }

}  // namespace

DepthView::DepthView(const PointCloud& cloud, double baseline, double thin)
    : p_CV_(cloud.viewpoint) {
  stray_.assign(cloud.points.size(), 0);
  if (!p_CV_.allFinite()) return;
  choose_axes(cloud);
  choose_grid(cloud);
  if (!valid()) return;
  project(cloud);
  // Only in the optical convention are rows those of the sensor, along its baseline.
  const GapRules rules{R_VC_.isIdentity() ? baseline : 0.0, thin};
  filled_ = fill_gaps(depth_, width_, {pitch_u_, pitch_v_}, rules);
  build_levels();
}

void DepthView::choose_axes(const PointCloud& cloud) {
  std::size_t finite = 0, before = 0;
  for (const Eigen::Vector3f& p : cloud.points) {
    if (!p.allFinite()) continue;
    ++finite;
    before += in_front(p.cast<double>() - p_CV_);
  }
  // The optical convention keeps the pixel grid regular; any other frame looks at its points' mean.
  if (before * 20 >= finite * 19) return;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : cloud.points) {
    const Eigen::Vector3d ray = p.cast<double>() - p_CV_;
    if (p.allFinite() && ray.norm() > kNearest) sum += ray.normalized();
  }
  if (sum.norm() < 1e-9) return;
  R_VC_ = Eigen::Quaterniond::FromTwoVectors(sum, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  spread_ = R_VC_.cwiseAbs().rowwise().sum();
}

void DepthView::choose_grid(const PointCloud& cloud) {
  std::vector<Eigen::Vector2d> tangents;
  tangents.reserve(cloud.points.size());
  Eigen::AlignedBox2d bounds;
  for (const Eigen::Vector3f& p : cloud.points) {
    const Eigen::Vector3d p_V = to_view(p.cast<double>());
    if (!p.allFinite() || !in_front(p_V)) continue;
    tangents.emplace_back(p_V.head<2>() / p_V.z());
    bounds.extend(tangents.back());
  }
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
  if (!(width * height < kMostPixels)) return;
  width_ = static_cast<int>(width);
  height_ = static_cast<int>(height);
}

void DepthView::project(const PointCloud& cloud) {
  depth_.assign(static_cast<std::size_t>(width_) * height_, 0.0F);
  std::vector<int> nearest(depth_.size(), -1);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (!cloud.points[i].allFinite()) continue;
    const Eigen::Vector3d p_V = to_view(cloud.points[i].cast<double>());
    if (!in_front(p_V)) continue;
    const Eigen::Vector2i uv = pixel(p_V);
    if (uv.x() < 0 || uv.x() >= width_ || uv.y() < 0 || uv.y() >= height_) continue;
    const std::size_t at = static_cast<std::size_t>(uv.y()) * width_ + uv.x();
    if (depth_[at] > 0.0F && depth_[at] <= p_V.z()) continue;
    depth_[at] = static_cast<float>(p_V.z());
    nearest[at] = static_cast<int>(i);
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
      int alike = 0;
      for (int y = std::max(v - 1, 0); y <= std::min(v + 1, height_ - 1) && alike <= kSupport;
           ++y) {
        for (int x = std::max(u - 1, 0); x <= std::min(u + 1, width_ - 1); ++x) {
          const float other = raw[static_cast<std::size_t>(y) * width_ + x];
          alike += other > 0.0F && std::abs(other - raw[at]) < tolerance;
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
  constexpr int kWidest = 20;
  if (u < 0 || v < 0 || u >= width_ || v >= height_) return -1;
  int best = -1;
  for (const int step : {-1, 1}) {
    for (int k = 1; k <= kWidest; ++k) {
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

Eigen::Vector2i DepthView::pixel(const Eigen::Vector3d& p_V) const {
  const double inverse = 1.0 / p_V.z();
  return {whole_below(p_V.x() * inverse * pixels_u_ + cu_ + 0.5),
          whole_below(p_V.y() * inverse * pixels_v_ + cv_ + 0.5)};
}

DepthView::Span DepthView::span(const Eigen::Vector3d& p_V, const Eigen::Vector3d& reach) const {
  // Tangents over the box lie between those at its nearest and farthest depth. A pixel more for
  // rounding does no harm: whoever asks looks at each.
  constexpr double kRounding = 1e-9;
  const double near = 1.0 / (p_V.z() - reach.z()), far = 1.0 / (p_V.z() + reach.z());
  const double lo_x = p_V.x() - reach.x(), hi_x = p_V.x() + reach.x();
  const double lo_y = p_V.y() - reach.y(), hi_y = p_V.y() + reach.y();
  return {whole_above(lo_x * (lo_x < 0.0 ? near : far) * pixels_u_ + cu_ - kRounding),
          whole_below(hi_x * (hi_x < 0.0 ? far : near) * pixels_u_ + cu_ + kRounding),
          whole_above(lo_y * (lo_y < 0.0 ? near : far) * pixels_v_ + cv_ - kRounding),
          whole_below(hi_y * (hi_y < 0.0 ? far : near) * pixels_v_ + cv_ + kRounding)};
}

DepthRange DepthView::range(const Eigen::Vector3d& p_V, const Eigen::Vector3d& reach) const {
  if (p_V.z() - reach.z() < kNearest) return {0.0, std::numeric_limits<double>::max()};
  Span s = span(p_V, reach);
  if (s.u0 > s.u1) s.u0 = s.u1 = pixel(p_V).x();
  if (s.v0 > s.v1) s.v0 = s.v1 = pixel(p_V).y();
  return range(s);
}

std::array<DepthRange, 8> DepthView::ranges(const EightPoints& p_V,
                                            const Eigen::Vector3d& reach) const {
  std::array<DepthRange, 8> result;
  if (p_V.col(2).minCoeff() - static_cast<float>(reach.z()) < 2.0F * static_cast<float>(kNearest)) {
    for (int n = 0; n < 8; ++n) {
      result[n] = range(Eigen::Vector3d(p_V.row(n).cast<double>().matrix().transpose()), reach);
    }
    return result;
  }
  // Floats are off by less than this many pixels. Shifted above zero, cutting off rounds down.
  constexpr float kRounding = 1e-3F, kShift = 8.0F;
  using Eight = Eigen::Array<float, 8, 1>;
  const Eigen::Array3f r = reach.cast<float>().array();
  const Eight near = (p_V.col(2) - r.z()).inverse(), far = (p_V.col(2) + r.z()).inverse();
  const auto below = [&](const Eight& x, double pixels, double centre, float rounding, int size) {
    const Eight t = static_cast<float>(pixels) * x + (static_cast<float>(centre) + rounding);
    return Eigen::Array<int, 8, 1>(
        (t.max(-4.0F).min(static_cast<float>(size) + 4.0F) + kShift).cast<int>());
  };
  const Eight x0 = p_V.col(0) - r.x(), x1 = p_V.col(0) + r.x();
  const Eight y0 = p_V.col(1) - r.y(), y1 = p_V.col(1) + r.y();
  const auto u0 = below((x0 * near).min(x0 * far), pixels_u_, cu_, -kRounding, width_);
  const auto u1 = below((x1 * near).max(x1 * far), pixels_u_, cu_, kRounding, width_);
  const auto v0 = below((y0 * near).min(y0 * far), pixels_v_, cv_, -kRounding, height_);
  const auto v1 = below((y1 * near).max(y1 * far), pixels_v_, cv_, kRounding, height_);
  constexpr int kWhole = static_cast<int>(kShift);
  for (int n = 0; n < 8; ++n) {
    const Span s{u0[n] + 1 - kWhole, u1[n] - kWhole, v0[n] + 1 - kWhole, v1[n] - kWhole};
    const bool none = s.u0 > s.u1 || s.v0 > s.v1;  // no centre of a pixel: the exact way
    result[n] = none ? range(Eigen::Vector3d(p_V.row(n).cast<double>().matrix().transpose()), reach)
                     : range(s);
  }
  return result;
}

// The level on which a region is at most two pixels wide and high, one pixel being 0 across.
int DepthView::level_of(int across_u, int across_v) const {
  const auto wide = static_cast<unsigned>(std::max(across_u, across_v));
  return std::min(wide < 2 ? 0 : static_cast<int>(std::bit_width(wide - 1)),
                  static_cast<int>(levels_.size()) - 1);
}

DepthRange DepthView::range(const Span& s) const {
  if (s.u1 < 0 || s.v1 < 0 || s.u0 >= width_ || s.v0 >= height_) return {0.0, 0.0};
  const bool cut = s.u0 < 0 || s.v0 < 0 || s.u1 >= width_ || s.v1 >= height_;
  const int u0 = std::max(s.u0, 0), u1 = std::min(s.u1, width_ - 1);
  const int v0 = std::max(s.v0, 0), v1 = std::min(s.v1, height_ - 1);
  const int k = level_of(u1 - u0, v1 - v0);
  const Level& level = levels_[k];
  float near = std::numeric_limits<float>::max(), far = 0.0F;
  for (int v = v0 >> k; v <= v1 >> k; ++v) {
    for (int u = u0 >> k; u <= u1 >> k; ++u) {
      const std::size_t at = static_cast<std::size_t>(v) * level.width + u;
      near = std::min(near, level.near[at]);
      far = std::max(far, level.far[at]);
    }
  }
  return {cut ? 0.0 : near, far};
}

bool DepthView::sees_past(const Eigen::Vector3d& centre_C, double half) const {
  return all_blockers(centre_C, half, [](int, int, double) { return false; });
}

double DepthView::nearest_surface(const Span& s) const {
  const int u0 = std::max(s.u0, 0), u1 = std::min(s.u1, width_ - 1);
  const int v0 = std::max(s.v0, 0), v1 = std::min(s.v1, height_ - 1);
  float nearest = std::numeric_limits<float>::infinity();
  if (u0 > u1 || v0 > v1) return nearest;
  const int k = level_of(u1 - u0, v1 - v0);
  const Level& level = levels_[k];
  for (int v = v0 >> k; v <= v1 >> k; ++v) {
    for (int u = u0 >> k; u <= u1 >> k; ++u) {
      nearest = std::min(nearest, level.surface[static_cast<std::size_t>(v) * level.width + u]);
    }
  }
  return nearest;
}

double DepthView::nearest_surface(const Eigen::Vector3d& p_V, const Eigen::Vector3d& reach) const {
  return p_V.z() - reach.z() < kNearest ? 0.0 : nearest_surface(span(p_V, reach));
}

bool DepthView::meets_surface(const Eigen::Vector3d& centre_C, double half) const {
  const Eigen::Vector3d p_V = to_view(centre_C), around = reach(half);
  if (p_V.z() - around.z() < kNearest) return false;
  const Eigen::Vector2i uv = pixel(p_V);
  if (measured(uv.x(), uv.y()) && depth(uv.x(), uv.y()) <= p_V.z()) return true;
  if (nearest_surface(span(p_V, around)) > p_V.z() + around.z()) return false;
  return !all_blockers(centre_C, half, [&](int u, int v, double) { return !measured(u, v); });
}

}  // namespace quadrille
