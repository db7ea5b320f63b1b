#include "boxes/face_edge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/quantile.hpp"
#include "boxes/edge_rows.hpp"
#include "boxes/mixed_edge.hpp"
#include "boxes/onto_plane.hpp"

namespace quadrille {
namespace {

// An edge counts as seen if at least this share of the rows see it.
constexpr double kMinSeenShare = 0.3;
// So many points beside the end of a row tell whether the face ends there: two columns of a row,
// which is 2.5 pitches wide. With two points 16 of 176 boxes in simulated scenes change by more
// than half a millimetre and three are lost, with ten 11 change and four are lost.
constexpr std::size_t kBeside = 5;
// A point beside a row touches the row's end if it is no farther from it than this many times their
// distance within the plane (true of a table that is seen at 14° or more), plus the edge's
// rounding.
constexpr double kMaxSlant = 4.0;
// A surface that leaves a face is fitted to points in this many bands of height, each as wide as
// the tolerance and with at least this many points.
constexpr std::size_t kLeavingBands = 3;
constexpr int kMinBandPoints = 8;
// A surface that falls away from a face is another side if it leans out by less than this (20°), as
// lean_of() has it; otherwise it is the face's own rounded edge.
constexpr double kMaxLean = 0.36;

/// True if most of the nearest points beside the end of a row show that the face ends there. A
/// sensor may mix a single point from the face and from what stands before it.
bool most_show_end(std::vector<Beside>* points) {
  const std::size_t count = std::min(points->size(), kBeside);
  std::partial_sort(points->begin(), points->begin() + static_cast<std::ptrdiff_t>(count),
                    points->end(),
                    [](const Beside& a, const Beside& b) { return a.distance < b.distance; });
  const auto shown =
      std::count_if(points->begin(), points->begin() + static_cast<std::ptrdiff_t>(count),
                    [](const Beside& point) { return point.shows_end; });
  return 2 * static_cast<std::size_t>(shown) > count;
}

/// Records for each row what was seen beside its end.
void look_beside(const Face& face, const Eigen::Vector3d& out_C,
                 const std::vector<SeenThrough>& around, Rows& rows) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Row& row : rows.all()) {
    if (!row.empty()) nearest = std::min(nearest, row.end);
  }
  for (const SeenThrough& seen : around) {
    const double place = out_C.dot(seen.on_C);
    if (!(place > nearest)) continue;
    Row* row = rows.at(seen.on_C);
    if (!row || row->empty()) continue;
    const double beyond = place - row->end;
    if (!(beyond > 0.0 && beyond < kAround)) continue;
    const bool behind = seen.height < -face.tolerance();
    // A point in the plane beyond the end is no sign of an end.
    const bool touches =
        seen.height > face.tolerance() &&
        (seen.p_C - row->last_C).norm() < kMaxSlant * beyond + face.tolerance() + kRounding;
    row->beside.push_back({beyond, seen.height, behind || touches});
  }
  for (Row& row : rows.all()) row.seen = most_show_end(&row.beside);
}

/// How far a surface that falls away from a face leads outward for each metre that it falls, by
/// least squares to its points: 0 for a side at a right angle, more for a rounded or slanted edge.
double lean_of(const Face& face, const Eigen::Vector3d& out_C, double end,
               const std::vector<SeenThrough>& around, Rows& rows) {
  const double tolerance = face.tolerance();
  Eigen::Matrix2d S = Eigen::Matrix2d::Zero();
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
  for (const SeenThrough& seen : around) {
    const double depth = -seen.height / tolerance;
    if (!(depth >= 1.0 && depth < 1.0 + kLeavingBands) || !rows.at(seen.on_C)) continue;
    const double beyond = out_C.dot(seen.p_C) - end;
    if (std::abs(beyond) > kMaxSlant * depth * tolerance) continue;
    const Eigen::Vector2d terms(1.0, depth);
    S += terms * terms.transpose();
    b += beyond * terms;
  }
  return S(0, 0) < kMinBandPoints ? 0.0 : S.ldlt().solve(b).y() / tolerance;
}

/// Position at which the surface that leaves a face at its edge would meet the face's plane. Its
/// points next to the edge still lie within the face's tolerance and seem to continue the face, so
/// the line place = edge + slope · height is fitted by least squares to its points farther off.
/// Nullopt if there is no such surface, as at an outline.
std::optional<double> meeting_of(const Face& face, const Eigen::Vector3d& out_C, double end,
                                 const std::vector<SeenThrough>& around, Rows& rows) {
  const double tolerance = face.tolerance();
  Eigen::Matrix2d S = Eigen::Matrix2d::Zero();
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
  std::array<int, kLeavingBands> bands = {};
  for (const SeenThrough& seen : around) {
    if (std::abs(seen.height) < tolerance) continue;
    const double height = std::abs(seen.height) / tolerance;
    if (height >= 1.0 + kLeavingBands) continue;
    const double beyond = out_C.dot(seen.on_C) - end;
    if (std::abs(beyond) > kMaxSlant * height * tolerance || !rows.at(seen.on_C)) continue;
    const Eigen::Vector2d terms(1.0, height);
    S += terms * terms.transpose();
    b += beyond * terms;
    ++bands[static_cast<std::size_t>(height) - 1];
  }
  // A surface has points in all bands, and more than chance would put there.
  if (*std::min_element(bands.begin(), bands.end()) < kMinBandPoints) return std::nullopt;
  const Eigen::Vector2d line = S.ldlt().solve(b);
  // At the height of the tolerance the surface must pass near the end of the rows.
  if (!(line.y() > 0.0) || std::abs(line.sum()) > 2.0 * face.pitch) return std::nullopt;
  return end + line.x();
}

double deviation(std::vector<double> values, double middle) {
  for (double& value : values) value -= middle;
  return robust_std(values);
}

}  // namespace

std::vector<SeenThrough> look_through(const Face& face,
                                      const std::vector<Eigen::Vector3d>& points_C,
                                      const DirectionIndex& sight) {
  const double away = sight.single() && face.height(sight.eye()) < 0.0 ? -1.0 : 1.0;
  std::vector<SeenThrough> seen;
  seen.reserve(points_C.size());
  const OntoPlane onto_plane(face, sight);
  for (const Eigen::Vector3d& p : points_C) {
    seen.push_back({p, onto_plane(p), away * face.height(p)});
  }
  return seen;
}

FaceEdge edge_of(const Face& face, const Eigen::Vector3d& out_C,
                 const std::vector<SeenThrough>& around, const DirectionIndex& sight) {
  const Eigen::Vector3d across_C = face.n_C.cross(out_C);
  const double pitch = face.pitch_along(out_C, sight);
  Rows rows(face, out_C, kGapPitches * face.pitch_along(across_C, sight));
  if (sight.single()) look_beside(face, out_C, around, rows);
  std::vector<double> all, seen;
  for (const Row& row : rows.all()) {
    if (row.empty()) continue;
    all.push_back(row.end);
    // A cloud fused from several views hides nothing, so each row's end is seen.
    if (!sight.single() || row.seen) seen.push_back(row.end);
  }
  FaceEdge edge;
  if (all.empty()) {
    edge.at = face.reach(out_C).second;
    edge.std = pitch;
    return edge;
  }
  edge.seen = static_cast<double>(seen.size()) >= kMinSeenShare * static_cast<double>(all.size());
  std::vector<double>& rows_that_tell = edge.seen ? seen : all;
  const double end = median(rows_that_tell);
  edge.at = end + 0.5 * pitch;
  const double spread = deviation(rows_that_tell, end);
  edge.std = std::hypot(0.5 * pitch, spread / std::sqrt(double(rows_that_tell.size())));
  if (!sight.single()) return edge;
  auto meeting = meeting_of(face, out_C, end, around, rows);
  if (meeting && lean_of(face, out_C, end, around, rows) > kMaxLean) meeting.reset();
  edge.meets = meeting.has_value();
  if (edge.seen && !edge.meets) edge.mixed = mixed_pixels(rows, face.tolerance(), pitch);
  if (meeting && *meeting < edge.at) {
    edge.std = std::hypot(edge.std, edge.at - *meeting);
    edge.at = *meeting;
  }
  return edge;
}

double Filling::share() const {
  return on + through == 0 ? 1.0 : static_cast<double>(on) / (on + through);
}

Filling& Filling::operator+=(const Filling& other) {
  on += other.on;
  through += other.through;
  return *this;
}

Filling filling_of(const Face& face, const Eigen::Matrix<double, 3, 2>& uv_C,
                   const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                   const std::vector<SeenThrough>& around) {
  Filling filling;
  for (const SeenThrough& seen : around) {
    const Eigen::Vector2d place = uv_C.transpose() * seen.on_C;
    if ((place.array() < low.array()).any() || (place.array() > high.array()).any()) continue;
    filling.on += std::abs(seen.height) <= face.tolerance();
    filling.through += seen.height < -face.tolerance();
  }
  return filling;
}

}  // namespace quadrille
