#include "picture/box_layer.hpp"

#include <array>

namespace quadrille {
namespace {

constexpr double kWidth = 2.0;
constexpr float kSeen = 0.95f, kHidden = 0.3f;

/// Returns a corner of the box. Bits 1, 2 and 4 choose the upper side along x, y and z.
Eigen::Vector3d corner_of(const Box& box, int bits) {
  Eigen::Vector3d p_B = 0.5 * box.size;
  for (int i = 0; i < 3; ++i) {
    if (!(bits >> i & 1)) p_B[i] = -p_B[i];
  }
  return box.X_CB * p_B;
}

/// Returns the corner that all three hidden sides share.
int hidden_corner(const Box& box, const View& view) {
  const Eigen::Vector3d eye_B =
      box.X_CB.inverse() * Eigen::Vector3d(view.X_VC.inverse().translation());
  int bits = 0;
  for (int i = 0; i < 3; ++i) bits |= (eye_B[i] < 0.0 ? 1 : 0) << i;
  return bits;
}

}  // namespace

Sketch sketch_box(const Box& box, const Color& color, const View& view) {
  std::array<Eigen::Vector2d, 8> corners;
  bool any_in_view = false;
  for (int n = 0; n < 8; ++n) {
    const auto at = view.project(corner_of(box, n));
    if (!at) return {};
    corners[n] = *at;
    any_in_view |= view.holds(*at);
  }
  if (!any_in_view) return {};
  const int hidden = hidden_corner(box, view);
  Strokes seen{{}, kWidth, color, kSeen}, behind{{}, kWidth, color, kHidden};
  for (int n = 0; n < 8; ++n) {
    for (int i = 0; i < 3; ++i) {
      const int other = n | 1 << i;
      if (other == n) continue;
      (n == hidden || other == hidden ? behind : seen)
          .segments.push_back({corners[n], corners[other]});
    }
  }
  return {{behind, seen}, {}};
}

}  // namespace quadrille
