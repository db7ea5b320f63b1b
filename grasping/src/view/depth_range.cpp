#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "view/depth_view.hpp"
#include "view/nearest_depth.hpp"

namespace quadrille {

namespace {

// The nearest whole number below or above, of at most 1e8: std::floor is a call on plain x86-64.
int whole_below(double x) {
  x = std::clamp(x, -1e8, 1e8);
  const int n = static_cast<int>(x);
  return n - (x < n);
}
int whole_above(double x) { return -whole_below(-x); }

}  // namespace

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
  if (p_V.z() - reach.z() < kNearestDepth) return {0.0, std::numeric_limits<double>::max()};
  Span s = span(p_V, reach);
  if (s.u0 > s.u1) s.u0 = s.u1 = pixel(p_V).x();
  if (s.v0 > s.v1) s.v0 = s.v1 = pixel(p_V).y();
  return range(s);
}

std::array<DepthRange, 8> DepthView::ranges(const EightPoints& p_V,
                                            const Eigen::Vector3d& reach) const {
  std::array<DepthRange, 8> result;
  if (p_V.col(2).minCoeff() - static_cast<float>(reach.z()) <
      2.0F * static_cast<float>(kNearestDepth)) {
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
  return p_V.z() - reach.z() < kNearestDepth ? 0.0 : nearest_surface(span(p_V, reach));
}

bool DepthView::meets_surface(const Eigen::Vector3d& centre_C, double half) const {
  const Eigen::Vector3d p_V = to_view(centre_C), around = reach(half);
  if (p_V.z() - around.z() < kNearestDepth) return false;
  const Eigen::Vector2i uv = pixel(p_V);
  if (measured(uv.x(), uv.y()) && depth(uv.x(), uv.y()) <= p_V.z()) return true;
  if (nearest_surface(span(p_V, around)) > p_V.z() + around.z()) return false;
  return !all_blockers(centre_C, half, [&](int u, int v, double) { return !measured(u, v); });
}

}  // namespace quadrille
