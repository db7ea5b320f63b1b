// Tests boxes against the voxels of an obstacle map.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "base/rounding.hpp"
#include "space/obstacle_map.hpp"

namespace quadrille {
namespace {

// Overlaps shallower than this count as touching.
constexpr double kTouchDepth = 1e-9;

// The view must have seen this much farther than a part of an occupied voxel, since points are
// known no more accurately [m].
constexpr double kPointNoise = 0.001;

}  // namespace

/// A box, prepared for the separating-axis test against cubes: the 15 axes, each with the box's own
/// extent along it. Few tests get as far as the axes across two edges, so that these are prepared
/// for the first of them.
struct ObstacleMap::Query {
  struct Edges {
    Eigen::Matrix<double, 3, 9> axes;  // cross products of edges
    Eigen::Matrix<double, 9, 1> reach, spread;

    Edges(const Eigen::Matrix3d& R, const Eigen::Vector3d& half) {
      for (int n = 0; n < 9; ++n) {
        const Eigen::Vector3d axis = Eigen::Vector3d::Unit(n / 3).cross(R.col(n % 3));
        axes.col(n) = axis;
        reach[n] = (R.transpose() * axis).cwiseAbs().dot(half);
        spread[n] = axis.cwiseAbs().sum();
      }
    }
  };

  Eigen::Vector3d p;            // centre of the box
  Eigen::Vector3d reach;        // half extent of the box along the cube's axes
  Eigen::Matrix3d R, absolute;  // axes of the box, as columns
  Eigen::Vector3d half;
  Eigen::Vector3d face_spread;
  mutable std::optional<Edges> edges;
  // Data for a quick test on the axes of the faces: the offsets from a cube's centre to the centres
  // of its eighths, per half an eighth's edge; the box's own extent on each axis, and the extent of
  // a cube of half size 1.
  std::array<Offset, 8> to_eighth;
  Offset quick_reach, quick_spread;

  explicit Query(const OrientedBox& box)
      : p(box.p_CB),
        reach(box.reach()),
        R(box.R_CB),
        absolute(box.R_CB.cwiseAbs()),
        half(box.half) {
    face_spread = absolute.colwise().sum();
    for (unsigned n = 0; n < 8; ++n) {
      to_eighth[n] = on_faces(cube_corner(n));
    }
    quick_reach << reach.cast<float>().array() + kFloatRounding,
        half.cast<float>().array() + kFloatRounding, 1.0f, 1.0f;
    quick_spread << 1.0f, 1.0f, 1.0f, face_spread.cast<float>().array(), 0.0f, 0.0f;
  }

  Offset on_faces(const Eigen::Vector3d& t) const {
    Offset offset;
    offset << t.cast<float>().array(), (R.transpose() * t).cast<float>().array(), 0.0f, 0.0f;
    return offset;
  }

  bool overlaps(const Eigen::Vector3d& centre, double h) const {
    const Eigen::Vector3d t = centre - p;
    const double g = h - kTouchDepth;
    if ((t.cwiseAbs().array() >= reach.array() + g).any()) return false;
    if (((R.transpose() * t).cwiseAbs().array() >= half.array() + g * face_spread.array()).any()) {
      return false;
    }
    if (!edges) edges.emplace(R, half);
    return ((edges->axes.transpose() * t).cwiseAbs().array() <
            edges->reach.array() + g * edges->spread.array() + 1e-12)
        .all();
  }
};

/// A cube of a level of a block: its place among the cubes of its level there, and among those of
/// the whole map.
struct ObstacleMap::Cube {
  const Block& block;
  int level;
  Eigen::Vector3i here, at;

  std::uint8_t flags() const { return block.row(level, here.y(), here.z())[here.x()]; }
};

Hit ObstacleMap::collides(const OrientedBox& box) const {
  const Eigen::Vector3d reach = box.reach();
  const Eigen::Vector3d top = corner_ + resolution_ * size_.cast<double>();
  const bool outside = ((box.p_CB - reach).array() < corner_.array()).any() ||
                       ((box.p_CB + reach).array() > top.array()).any();
  if (outside && unknown_blocks_) return Hit::kUnknown;
  if (blocks_.empty()) return Hit::kNone;
  std::optional<Query> query;
  const Range range = voxels({box.p_CB - reach, box.p_CB + reach});
  const auto& [low, high] = range;
  constexpr int kTop = kLevels - 1;
  if ((high.array() < 0).any()) return Hit::kNone;
  if (may_meet_last(range)) {
    query.emplace(box);
    if (meet(*query, last()) != 0) return Hit::kOccupied;
  }
  const double edge = resolution_ * kEdge;
  for (int k = low.z() >> kTop; k <= high.z() >> kTop; ++k) {
    for (int j = low.y() >> kTop; j <= high.y() >> kTop; ++j) {
      for (int i = low.x() >> kTop; i <= high.x() >> kTop; ++i) {
        const Eigen::Vector3i at(i, j, k);
        const Block* block = block_of(kEdge * at);
        if (block == nullptr || block->is_empty()) continue;
        // Many boxes come near no block that holds anything.
        if (!query) query.emplace(box);
        const Eigen::Vector3d centre = corner_ + edge * (at.array().cast<double>() + 0.5).matrix();
        const std::uint8_t hit = descend(*query, {*block, kTop, Eigen::Vector3i::Zero(), at},
                                         query->on_faces(centre - query->p));
        if (hit) return hit & kAnyOccupied ? Hit::kOccupied : Hit::kUnknown;
      }
    }
  }
  return Hit::kNone;
}

/// Returns true if a box that lies within a range may meet the occupied cube that another one met
/// last. Boxes that follow each other are mostly those of hands side by side. With unknown space as
/// an obstacle, the first cube on the way may be of the other kind, so that this tells nothing.
bool ObstacleMap::may_meet_last(const Range& range) const {
  if (last_.block < 0 || unknown_blocks_ || last().flags() == 0) return false;
  const Eigen::Array3i low = last_.at.array() * (1 << last_.level);
  const Eigen::Array3i high = low + (1 << last_.level) - 1;
  return (low <= range.second.array()).all() && (high >= range.first.array()).all();
}

ObstacleMap::Cube ObstacleMap::last() const {
  return {blocks_.data()[last_.block], last_.level, last_.here, last_.at};
}

/// Returns the flags of the voxels that the box meets in a cube that holds something.
std::uint8_t ObstacleMap::descend(const Query& query, const Cube& cube,
                                  const Offset& offset) const {
  const double h = 0.5 * resolution_ * (1 << cube.level);
  const Offset gap = offset.abs() - query.quick_reach - static_cast<float>(h) * query.quick_spread;
  if (gap.maxCoeff() > 0.0f) return 0;
  if (cube.level == 0 || (cube.flags() & kAll && !refines(cube.flags()))) {
    const std::uint8_t met = meet(query, cube);
    if (met != 0) {
      last_ = {static_cast<int>(&cube.block - blocks_.data()), cube.level, cube.here, cube.at};
    }
    return met;
  }
  const int edge = kEdge >> (cube.level - 1);
  const std::uint8_t* parts = cube.block.row(cube.level - 1, 2 * cube.here.y(), 2 * cube.here.z()) +
                              std::ptrdiff_t{2} * cube.here.x();
  for (int n = 0; n < 8; ++n) {
    const Eigen::Vector3i eighth = eighth_of_cube(n);
    // Most eighths hold nothing.
    if (parts[eighth.x() + edge * (eighth.y() + edge * eighth.z())] == 0) continue;
    const Offset there = offset + static_cast<float>(0.5 * h) * query.to_eighth[n];
    const Cube part{cube.block, cube.level - 1, 2 * cube.here + eighth, 2 * cube.at + eighth};
    if (const std::uint8_t hit = descend(query, part, there)) return hit;
  }
  return 0;
}

/// True if the parts of a voxel with these flags are told apart.
bool ObstacleMap::refines(std::uint8_t flags) const {
  const int divided = kAnyUnknown | (divide_occupied_ ? kAnyOccupied : 0);
  return !views_.empty() && flags & divided;
}

/// Returns the flags of a voxel, or of a cube of which all voxels have the same, if the box meets
/// it.
std::uint8_t ObstacleMap::meet(const Query& query, const Cube& cube) const {
  const double h = 0.5 * resolution_ * (1 << cube.level);
  const Eigen::Vector3d centre =
      corner_ + 2.0 * h * (cube.at.cast<double>().array() + 0.5).matrix();
  const std::uint8_t flags = cube.flags();
  if (!query.overlaps(centre, h)) return 0;
  if (!refines(flags)) return flags;
  const bool hit = flags & kAnyOccupied ? enters_hidden(query, centre, h, 1, kPointNoise)
                                        : enters_hidden(query, centre, h, 2, 0.0);
  return hit ? flags : 0;
}

/// Returns true if the box overlaps an eighth of the cube that no view, to within a margin, saw
/// through. Such eighths are divided in turn, up to a depth. A view tells nothing about cubes
/// smaller than the spacing of its rays.
bool ObstacleMap::enters_hidden(const Query& query, const Eigen::Vector3d& centre, double half,
                                int depth, double margin) const {
  const double h = 0.5 * half;
  if (depth == 0) return true;
  const auto tells = [&](const DepthView& view) {
    return view.valid() && !(view.spacing(view.to_view(centre).z()) > 2.0 * h);
  };
  if (std::none_of(views_.begin(), views_.end(), tells)) return true;
  const auto seen_through = [&](const Eigen::Vector3d& eighth) {
    return std::any_of(views_.begin(), views_.end(), [&](const DepthView& view) {
      return tells(view) && view.sees_past(eighth, h + margin);
    });
  };
  for (unsigned n = 0; n < 8; ++n) {
    const Eigen::Vector3d eighth = centre + h * cube_corner(n);
    if (query.overlaps(eighth, h) && !seen_through(eighth) &&
        enters_hidden(query, eighth, h, depth - 1, margin)) {
      return true;
    }
  }
  return false;
}

}  // namespace quadrille
