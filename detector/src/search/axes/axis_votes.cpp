#include "search/axes/axis_votes.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/quantile.hpp"
#include "base/vector_clones.hpp"
#include "fit/posed_quadric.hpp"
#include "search/axes/normal_line.hpp"
#include "search/axes/set_flags.hpp"

namespace quadrille {
namespace {

// Radii of the bodies, in cells. A smaller body has too few samples; a larger one is found without
// the help of its axis.
constexpr float kMinRadius = 2.5f, kMaxRadius = 40.0f;
// Radius at which the weight of a vote has fallen to a third of that at the axis, in cells.
constexpr float kHalfRadius = 5.0f;
// Number of votes on each side of a sample, one a cell, and the same rounded up to whole vectors.
constexpr int kRadii = 38, kPaddedRadii = 40;
static_assert(kMinRadius + kRadii - 1 < kMaxRadius && kMinRadius + kRadii >= kMaxRadius);
// Least votes of a maximum, as a share of the largest.
constexpr float kMinShare = 0.04f;
// Side, in cells, of the square about the median sample outside of which nothing is counted, so
// that far things cost no memory.
constexpr float kMaxSide = 1500.0f;
// Number of lines that an axis has at least.
constexpr int kMinLines = 12;
constexpr int kRounds = 4;

/// The bounding box of the samples, without what lies outside of a square about their median.
Eigen::AlignedBox2f window(const std::vector<NormalLine>& lines, float side) {
  Eigen::AlignedBox2f box;
  std::vector<float> x, y;
  for (const NormalLine& line : lines) {
    box.extend(line.at);
    x.push_back(line.at.x()), y.push_back(line.at.y());
  }
  const Eigen::Vector2f middle(median(x), median(y)), half(0.5f * side, 0.5f * side);
  return box.intersection(Eigen::AlignedBox2f(middle - half, middle + half));
}

/// A grid of votes over the plane, by its lowest corner, the edge of its cells, and the number of
/// cells in a row.
struct VoteGrid {
  Eigen::Vector2f low;
  float cell;
  int width;
};

/// Finds the cells of a grid that a line votes for.
/// @param radii  distances of the votes from where the line begins
/// @param up, down  results on the side of the normal and on the other one
QUADRILLE_VECTOR_CLONES
void find_cells(const VoteGrid& grid, const NormalLine& line, const float* radii,
                int* __restrict up, int* __restrict down) {
  const float x = line.at.x(), y = line.at.y(), dx = line.along.x(), dy = line.along.y();
  const float low_x = grid.low.x(), low_y = grid.low.y(), cell = grid.cell;
  const int width = grid.width;
  for (int k = 0; k < kPaddedRadii; ++k) {
    const float step_x = radii[k] * dx, step_y = radii[k] * dy;
    up[k] = static_cast<int>((y + step_y - low_y) / cell) * width +
            static_cast<int>((x + step_x - low_x) / cell);
    down[k] = static_cast<int>((y - step_y - low_y) / cell) * width +
              static_cast<int>((x - step_x - low_x) / cell);
  }
}

/// Replaces each value by (a + 2 b + c) / 4 of itself and its two neighbours a step away, but for
/// the first and last ones.
QUADRILLE_VECTOR_CLONES
void smooth_into(const float* from, std::size_t step, std::size_t size, float* __restrict to) {
  for (std::size_t i = step; i + step < size; ++i) {
    to[i] = 0.25f * (from[i - step] + 2.0f * from[i] + from[i + step]);
  }
}

/// Votes in the cells of a grid over the plane.
class Votes {
 public:
  Votes(const std::vector<NormalLine>& lines, float cell) {
    const Eigen::AlignedBox2f box = window(lines, kMaxSide * cell);
    const Eigen::Vector2f sizes = box.sizes().array() + 2.0f * kMaxRadius * cell;
    grid_ = {box.min().array() - kMaxRadius * cell, cell, static_cast<int>(sizes.x() / cell) + 3};
    height_ = static_cast<int>(sizes.y() / cell) + 3;
    votes_.assign(static_cast<std::size_t>(grid_.width) * static_cast<std::size_t>(height_), 0.0f);
    Radii radii = {}, weights = {};
    for (int k = 0; k < kRadii; ++k) {
      const float r = kMinRadius + static_cast<float>(k);
      radii[k] = r * cell;
      weights[k] = 1.0f / (r / kHalfRadius + 0.5f);
    }
    for (const NormalLine& line : lines) {
      if (box.contains(line.at)) add(line, radii, weights);
    }
    smooth(1);
    smooth(static_cast<std::size_t>(grid_.width));
  }

  /// The maxima among cells up to two away, those with the most votes first.
  std::vector<Eigen::Vector2f> maxima(int max_count) const {
    const float least = kMinShare * *std::max_element(votes_.begin(), votes_.end());
    std::vector<std::pair<float, int>> found;
    for (int y = 2; y < height_ - 2; ++y) {
      for (int x = 2; x < grid_.width - 2; ++x) {
        const int i = y * grid_.width + x;
        if (votes_[i] > least && is_maximum(i)) found.emplace_back(-votes_[i], i);
      }
    }
    std::sort(found.begin(), found.end());
    found.resize(std::min(found.size(), static_cast<std::size_t>(max_count)));
    std::vector<Eigen::Vector2f> centres;
    for (const auto& [votes, i] : found) {
      const Eigen::Vector2i cell(i % grid_.width, i / grid_.width);
      centres.emplace_back(grid_.low + grid_.cell * (cell.cast<float>().array() + 0.5f).matrix());
    }
    return centres;
  }

 private:
  using Radii = std::array<float, kPaddedRadii>;

  void add(const NormalLine& line, const Radii& radii, const Radii& weights) {
    std::array<int, kPaddedRadii> up, down;
    find_cells(grid_, line, radii.data(), up.data(), down.data());
    float* const votes = votes_.data();
    for (int k = 0; k < kRadii; ++k) {
      votes[up[k]] += weights[k];
      votes[down[k]] += weights[k];
    }
  }

  void smooth(std::size_t step) {
    const std::vector<float> before = votes_;
    smooth_into(before.data(), step, before.size(), votes_.data());
  }

  bool is_maximum(int i) const {
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dx = -2; dx <= 2; ++dx) {
        const int j = i + dy * grid_.width + dx;
        if (votes_[j] > votes_[i] || (votes_[j] == votes_[i] && j < i)) return false;
      }
    }
    return true;
  }

  VoteGrid grid_;
  int height_ = 0;
  std::vector<float> votes_;
};

/// Finds which lines pass near a centre; see NormalLine::meets_axis().
/// @param rows  of the points at which the lines begin and of their directions, x and y
QUADRILLE_VECTOR_CLONES
void find_passing(const float* rows, std::size_t size, const float* centre, float cell,
                  int* __restrict passes) {
  const float *x = rows, *y = x + size, *along_x = y + size, *along_y = along_x + size;
  const float cx = centre[0], cy = centre[1];
  for (std::size_t i = 0; i < size; ++i) {
    const float dx = x[i] - cx, dy = y[i] - cy, r = std::sqrt(dx * dx + dy * dy);
    const float miss = std::abs(dx * along_y[i] - dy * along_x[i]);
    passes[i] = (r <= kMaxRadius * cell) & (r >= kMinRadius * cell) &
                (miss <= std::max(NormalLine::kMaxMissCells * cell, NormalLine::kMaxMissShare * r));
  }
}

/// Moves centres to where the lines that pass nearby come closest.
class Refinement {
 public:
  Refinement(const std::vector<NormalLine>& lines, float cell)
      : lines_(lines),
        size_(lines.size()),
        cell_(cell),
        rows_(4 * size_),
        passes_(size_),
        passing_(size_) {
    for (std::size_t i = 0; i < size_; ++i) {
      rows_[i] = lines[i].at.x(), rows_[size_ + i] = lines[i].at.y();
      rows_[2 * size_ + i] = lines[i].along.x(), rows_[3 * size_ + i] = lines[i].along.y();
    }
  }

  /// The point that comes closest to the lines that pass near a centre; nullopt if these are few.
  std::optional<Eigen::Vector2f> refined(Eigen::Vector2f centre) {
    for (int round = 0; round < kRounds; ++round) {
      find_passing(rows_.data(), size_, centre.data(), cell_, passes_.data());
      Eigen::Matrix2f A = Eigen::Matrix2f::Zero();
      Eigen::Vector2f b = Eigen::Vector2f::Zero();
      const int count = list_set_flags(passes_.data(), static_cast<int>(size_), passing_.data());
      if (count < kMinLines) return std::nullopt;
      for (int k = 0; k < count; ++k) {
        const NormalLine& line = lines_[static_cast<std::size_t>(passing_[k])];
        const Eigen::Vector2f across(line.along.y(), -line.along.x());
        A += across * across.transpose();
        b += across * across.dot(line.at - centre);
      }
      centre += (A + 1e-6f * Eigen::Matrix2f::Identity()).inverse() * b;
    }
    return centre;
  }

 private:
  const std::vector<NormalLine>& lines_;
  std::size_t size_;
  float cell_;
  /// Rows of the points at which the lines begin and of their directions, x and y.
  std::vector<float> rows_;
  /// One for lines that pass near the centre, otherwise zero; then the indices of those that do.
  std::vector<int> passes_, passing_;
};

}  // namespace

std::vector<Axis> vote_for_axes(const SurfaceSamples& samples, const Mask& open,
                                const Eigen::Vector3d& direction, int max_axes) {
  if (samples.size() == 0 || max_axes <= 0) return {};
  const Eigen::Isometry3d X_CA = pose_along(Eigen::Vector3d::Zero(), direction);
  const Eigen::Matrix3f R_AC = X_CA.linear().transpose().cast<float>();
  std::vector<NormalLine> lines;
  std::vector<float> cells;
  for (int i = 0; i < samples.size(); ++i) {
    if (!open.empty() && !open[i]) continue;
    const NormalLine line(R_AC * samples.raw[i], R_AC * samples.n[i]);
    if (!line.has_direction()) continue;
    lines.push_back(line);
    cells.push_back(samples.cell[i]);
  }
  if (static_cast<int>(lines.size()) < kMinLines) return {};
  const float cell = quantile(cells, 0.5);
  Refinement refinement(lines, cell);
  std::vector<Axis> axes;
  for (const Eigen::Vector2f& maximum : Votes(lines, cell).maxima(max_axes)) {
    const std::optional<Eigen::Vector2f> centre = refinement.refined(maximum);
    if (!centre) continue;
    axes.push_back({X_CA.linear().leftCols<2>() * centre->cast<double>(), direction});
  }
  return axes;
}

}  // namespace quadrille
