// Queries of a depth view about boxes and cubes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "view/depth_view.hpp"

namespace quadrille {

namespace {

// Greatest width of the band beside an edge in which a sensor with two eyes is blind: focal length
// times baseline over depth, with the values of common sensors at half a metre.
constexpr int kMaxBlindPixels = 20;

/// Rounds down to a whole number, limited to ±1e8, which lies outside any image; NaN becomes −1e8.
/// Avoids std::floor, which is a function call on plain x86-64.
int whole_below(double x) {
  x = x > -1e8 ? std::min(x, 1e8) : -1e8;
  const int n = static_cast<int>(x);
  return n - (x < n);
}
int whole_above(double x) { return -whole_below(-x); }

}  // namespace

Eigen::Vector2i DepthView::pixel(const Eigen::Vector3d& p_V) const {
  const double inverse = 1.0 / p_V.z();
  return {whole_below(p_V.x() * inverse * pixels_.x() + cu_ + 0.5),
          whole_below(p_V.y() * inverse * pixels_.y() + cv_ + 0.5)};
}

PixelSpan DepthView::span(const Eigen::Vector3d& p_V, const Eigen::Vector3d& reach) const {
  // Tangents over the box lie between those at its nearest and farthest depth. One pixel too many
  // because of rounding does no harm, since callers check each pixel.
  constexpr double kRounding = 1e-9;
  const double near = 1.0 / (p_V.z() - reach.z()), far = 1.0 / (p_V.z() + reach.z());
  const double lo_x = p_V.x() - reach.x(), hi_x = p_V.x() + reach.x();
  const double lo_y = p_V.y() - reach.y(), hi_y = p_V.y() + reach.y();
  return {whole_above(lo_x * (lo_x < 0.0 ? near : far) * pixels_.x() + cu_ - kRounding),
          whole_below(hi_x * (hi_x < 0.0 ? far : near) * pixels_.x() + cu_ + kRounding),
          whole_above(lo_y * (lo_y < 0.0 ? near : far) * pixels_.y() + cv_ - kRounding),
          whole_below(hi_y * (hi_y < 0.0 ? far : near) * pixels_.y() + cv_ + kRounding)};
}

DepthRange DepthView::range(const Eigen::Vector3d& p_V, const Eigen::Vector3d& reach) const {
  if (p_V.z() - reach.z() < kMinDepth) return {0.0, std::numeric_limits<double>::max()};
  PixelSpan s = span(p_V, reach);
  if (s.min_u > s.max_u) s.min_u = s.max_u = pixel(p_V).x();
  if (s.min_v > s.max_v) s.min_v = s.max_v = pixel(p_V).y();
  return bounds_.range(s);
}

std::array<DepthRange, 8> DepthView::ranges(const EightPoints& p_V,
                                            const Eigen::Vector3d& reach) const {
  std::array<DepthRange, 8> result;
  if (p_V.col(2).minCoeff() - static_cast<float>(reach.z()) <
      2.0f * static_cast<float>(kMinDepth)) {
    for (int n = 0; n < 8; ++n) {
      result[n] = range(Eigen::Vector3d(p_V.row(n).cast<double>().matrix().transpose()), reach);
    }
    return result;
  }
  // Error bound of the floats in pixels. The shift makes all values positive, so that truncation
  // rounds down.
  constexpr float kRounding = 1e-3f, kShift = 8.0f;
  using Eight = Eigen::Array<float, 8, 1>;
  const Eigen::Array3f r = reach.cast<float>().array();
  const Eight near = (p_V.col(2) - r.z()).inverse(), far = (p_V.col(2) + r.z()).inverse();
  const auto below = [&](const Eight& x, double pixels, double centre, float rounding, int size) {
    const Eight t = static_cast<float>(pixels) * x + (static_cast<float>(centre) + rounding);
    return Eigen::Array<int, 8, 1>(
        (t.max(-4.0f).min(static_cast<float>(size) + 4.0f) + kShift).cast<int>());
  };
  const Eight x0 = p_V.col(0) - r.x(), x1 = p_V.col(0) + r.x();
  const Eight y0 = p_V.col(1) - r.y(), y1 = p_V.col(1) + r.y();
  const auto u0 = below((x0 * near).min(x0 * far), pixels_.x(), cu_, -kRounding, image_.width);
  const auto u1 = below((x1 * near).max(x1 * far), pixels_.x(), cu_, kRounding, image_.width);
  const auto v0 = below((y0 * near).min(y0 * far), pixels_.y(), cv_, -kRounding, image_.height);
  const auto v1 = below((y1 * near).max(y1 * far), pixels_.y(), cv_, kRounding, image_.height);
  constexpr int kWhole = static_cast<int>(kShift);
  for (int n = 0; n < 8; ++n) {
    const PixelSpan s{u0[n] + 1 - kWhole, u1[n] - kWhole, v0[n] + 1 - kWhole, v1[n] - kWhole};
    const bool none =
        s.min_u > s.max_u || s.min_v > s.max_v;  // no pixel centre inside: use the exact way
    result[n] = none ? range(Eigen::Vector3d(p_V.row(n).cast<double>().matrix().transpose()), reach)
                     : bounds_.range(s);
  }
  return result;
}

/// Calls visit(u, v, depth) for each pixel whose ray passes through the cube without seeing past
/// it, until one call returns false. The pixel that the cube's centre projects to always counts.
template <class Visitor>
bool DepthView::visit_blockers(const Eigen::Vector3d& centre_C, double half,
                               Visitor&& visit) const {
  const Eigen::Vector3d p_V = to_view(centre_C);
  const Eigen::Vector3d around = reach(half);
  const double beyond = p_V.z() + around.z();
  if (p_V.z() - around.z() <= 0.0) return visit(-1, -1, 0.0);
  const Eigen::Array3d to_low = (centre_C - p_CV_).array() - half;
  const Eigen::Vector2i middle = pixel(p_V);
  const double z_middle = depth(middle.x(), middle.y());
  if (z_middle <= p_V.z() && !visit(middle.x(), middle.y(), z_middle)) return false;
  const PixelSpan s = span(p_V, around);
  for (int v = s.min_v; v <= s.max_v; ++v) {
    for (int u = s.min_u; u <= s.max_u; ++u) {
      const double z = depth(u, v);
      if (z > beyond) continue;
      const Eigen::Array3d inverse = ray_C(u, v).array().inverse();
      const Eigen::Array3d t0 = to_low * inverse, t1 = (to_low + 2.0 * half) * inverse;
      const double enter = t0.min(t1).maxCoeff(), leave = t0.max(t1).minCoeff();
      if (enter <= leave && z <= leave && !visit(u, v, z)) return false;
    }
  }
  return true;
}

bool DepthView::sees_past(const Eigen::Vector3d& centre_C, double half) const {
  return visit_blockers(centre_C, half, [](int, int, double) { return false; });
}

double DepthView::nearest_surface(const Eigen::Vector3d& p_V, const Eigen::Vector3d& reach) const {
  return p_V.z() - reach.z() < kMinDepth ? 0.0 : bounds_.nearest_surface(span(p_V, reach));
}

bool DepthView::meets_surface(const Eigen::Vector3d& centre_C, double half) const {
  const Eigen::Vector3d p_V = to_view(centre_C), around = reach(half);
  if (p_V.z() - around.z() < kMinDepth) return false;
  const Eigen::Vector2i uv = pixel(p_V);
  if (measured(uv.x(), uv.y()) && depth(uv.x(), uv.y()) <= p_V.z()) return true;
  if (bounds_.nearest_surface(span(p_V, around)) > p_V.z() + around.z()) return false;
  return !visit_blockers(centre_C, half, [&](int u, int v, double) { return !measured(u, v); });
}

bool DepthView::hidden_only_by(const Eigen::Vector3d& centre_C, double half,
                               const std::function<bool(const Eigen::Vector3d&)>& holds) const {
  int blockers = 0;
  const bool all = visit_blockers(centre_C, half, [&](int u, int v, double z) {
    ++blockers;
    const int edge = z > 0.0 && measured(u, v) ? u : nearer_end_of_gap(u, v);
    if (edge < 0) return false;
    return holds(Eigen::Vector3d(p_CV_ + depth(edge, v) * ray_C(edge, v)));
  });
  return all && blockers > 0;
}

int DepthView::nearer_end_of_gap(int u, int v) const {
  if (!image_.holds(u, v)) return -1;
  int best = -1;
  for (const int step : {-1, 1}) {
    for (int k = 1; k <= kMaxBlindPixels; ++k) {
      if (!measured(u + k * step, v)) continue;
      if (best < 0 || depth(u + k * step, v) < depth(best, v)) best = u + k * step;
      break;
    }
  }
  return best;
}

bool any_sees_past(std::span<const DepthView> views, const Eigen::Vector3d& centre_C, double half) {
  return std::any_of(views.begin(), views.end(), [&](const DepthView& view) {
    return view.valid() && view.sees_past(centre_C, half);
  });
}

}  // namespace quadrille
