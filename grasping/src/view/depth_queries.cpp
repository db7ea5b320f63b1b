// Queries of a depth view about boxes and cubes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "quadrille/detector/vector_clones.hpp"
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
  // Nothing is known about a box behind the viewpoint: it counts as beyond all that was seen.
  constexpr double kLowest = std::numeric_limits<double>::lowest();
  if (p_V.z() + reach.z() < kMinDepth) return {kLowest, kLowest};
  if (p_V.z() - reach.z() < kMinDepth) return {0.0, std::numeric_limits<double>::max()};
  PixelSpan s = span(p_V, reach);
  if (s.min_u > s.max_u) s.min_u = s.max_u = pixel(p_V).x();
  if (s.min_v > s.max_v) s.min_v = s.max_v = pixel(p_V).y();
  return bounds_.range(s);
}

/// The pixels whose centres lie in the projections of eight boxes.
struct DepthView::EightSpans {
  std::array<int, 8> min_u, max_u, min_v, max_v;
};

QUADRILLE_VECTOR_CLONES
DepthView::EightSpans DepthView::spans(const EightPoints& p_V, const Eigen::Vector3f& reach) const {
  // Error bound of the floats in pixels. The shift makes all values positive, so that truncation
  // rounds down.
  constexpr float kRounding = 1e-3f, kShift = 8.0f;
  constexpr int kWhole = static_cast<int>(kShift);
  const float rx = reach.x(), ry = reach.y(), rz = reach.z();
  const float du = static_cast<float>(pixels_.x()), dv = static_cast<float>(pixels_.y());
  const float cu = static_cast<float>(cu_), cv = static_cast<float>(cv_);
  const auto below = [least = -0.5f * kShift](float x, int size) {
    const float most = static_cast<float>(size) - least;
    x = x > least ? x : least;
    x = x < most ? x : most;
    return static_cast<int>(x + kShift) - kWhole;
  };
  const auto less = [](float a, float b) { return a < b ? a : b; };
  const auto more = [](float a, float b) { return a > b ? a : b; };
  EightSpans s;
  for (int n = 0; n < 8; ++n) {
    const float near = 1.0f / (p_V.z[n] - rz), far = 1.0f / (p_V.z[n] + rz);
    const float x0 = p_V.x[n] - rx, x1 = p_V.x[n] + rx, y0 = p_V.y[n] - ry, y1 = p_V.y[n] + ry;
    s.min_u[n] = below(du * less(x0 * near, x0 * far) + (cu - kRounding), image_.width) + 1;
    s.max_u[n] = below(du * more(x1 * near, x1 * far) + (cu + kRounding), image_.width);
    s.min_v[n] = below(dv * less(y0 * near, y0 * far) + (cv - kRounding), image_.height) + 1;
    s.max_v[n] = below(dv * more(y1 * near, y1 * far) + (cv + kRounding), image_.height);
  }
  return s;
}

std::array<DepthRange, 8> DepthView::ranges(const EightPoints& p_V,
                                            const Eigen::Vector3d& reach) const {
  const float nearest = *std::min_element(p_V.z.begin(), p_V.z.end());
  const bool near = nearest - static_cast<float>(reach.z()) < 2.0f * static_cast<float>(kMinDepth);
  const EightSpans s = near ? EightSpans() : spans(p_V, reach.cast<float>());
  std::array<DepthRange, 8> result;
  for (int n = 0; n < 8; ++n) {
    // If no pixel's centre lies inside, the exact way is used too.
    const bool exact = near || s.min_u[n] > s.max_u[n] || s.min_v[n] > s.max_v[n];
    result[n] = exact ? range(Eigen::Vector3d(p_V.x[n], p_V.y[n], p_V.z[n]), reach)
                      : bounds_.range({s.min_u[n], s.max_u[n], s.min_v[n], s.max_v[n]});
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
  const bool inside =
      s.min_u >= 0 && s.min_v >= 0 && s.max_u < image_.width && s.max_v < image_.height;
  for (int v = s.min_v; v <= s.max_v; ++v) {
    // Unlike at(), a row does not check each access.
    const float* row = inside ? image_.depth.data() + image_.index(0, v) : nullptr;
    for (int u = s.min_u; u <= s.max_u; ++u) {
      const double z = inside ? row[u] : depth(u, v);
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
  if (p_V.z() + reach.z() < kMinDepth) return std::numeric_limits<double>::lowest();
  return p_V.z() - reach.z() < kMinDepth ? 0.0 : bounds_.nearest_surface(span(p_V, reach));
}

bool DepthView::meets_surface(const Eigen::Vector3d& centre_C, double half) const {
  const Eigen::Vector3d p_V = to_view(centre_C), around = reach(half);
  // Behind the viewpoint anything may be.
  if (p_V.z() < 0.0) return true;
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
