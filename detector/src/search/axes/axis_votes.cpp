#include "search/axes/axis_votes.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/quantile.hpp"
#include "fit/posed_quadric.hpp"
#include "search/axes/normal_line.hpp"

namespace quadrille {
namespace {

// Radii of the bodies, in cells. A smaller body has too few samples; a larger one is found without
// the help of its axis.
constexpr float kMinRadius = 2.5f, kMaxRadius = 40.0f;
// Radius at which the weight of a vote has fallen to a third of that at the axis, in cells.
constexpr float kHalfRadius = 5.0f;
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

/// Votes in the cells of a grid over the plane.
class Votes {
 public:
  Votes(const std::vector<NormalLine>& lines, float cell) : cell_(cell) {
    const Eigen::AlignedBox2f box = window(lines, kMaxSide * cell);
    low_ = box.min().array() - kMaxRadius * cell;
    const Eigen::Vector2f sizes = box.sizes().array() + 2.0f * kMaxRadius * cell;
    width_ = static_cast<int>(sizes.x() / cell) + 3;
    height_ = static_cast<int>(sizes.y() / cell) + 3;
    votes_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0.0f);
    for (const NormalLine& line : lines) {
      if (!box.contains(line.at)) continue;
      for (float r = kMinRadius; r < kMaxRadius; r += 1.0f) {
        const float weight = 1.0f / (r / kHalfRadius + 0.5f);
        at(line.at + r * cell * line.along) += weight;
        at(line.at - r * cell * line.along) += weight;
      }
    }
    smooth(1);
    smooth(width_);
  }

  /// The maxima among cells up to two away, those with the most votes first.
  std::vector<Eigen::Vector2f> maxima(int max_count) const {
    const float least = kMinShare * *std::max_element(votes_.begin(), votes_.end());
    std::vector<std::pair<float, int>> found;
    for (int y = 2; y < height_ - 2; ++y) {
      for (int x = 2; x < width_ - 2; ++x) {
        const int i = y * width_ + x;
        if (votes_[i] > least && is_maximum(i)) found.emplace_back(-votes_[i], i);
      }
    }
    std::sort(found.begin(), found.end());
    found.resize(std::min(found.size(), static_cast<std::size_t>(max_count)));
    std::vector<Eigen::Vector2f> centres;
    for (const auto& [votes, i] : found) {
      const Eigen::Vector2i cell(i % width_, i / width_);
      centres.emplace_back(low_ + cell_ * (cell.cast<float>().array() + 0.5f).matrix());
    }
    return centres;
  }

 private:
  float& at(const Eigen::Vector2f& x) {
    const Eigen::Vector2i cell = ((x - low_) / cell_).cast<int>();
    return votes_[cell.y() * width_ + cell.x()];
  }

  /// Replaces each value by (a + 2 b + c) / 4 of itself and its two neighbours a step away.
  void smooth(int step) {
    const std::vector<float> before = votes_;
    for (std::size_t i = step; i + step < votes_.size(); ++i) {
      votes_[i] = 0.25f * (before[i - step] + 2.0f * before[i] + before[i + step]);
    }
  }

  bool is_maximum(int i) const {
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dx = -2; dx <= 2; ++dx) {
        const int j = i + dy * width_ + dx;
        if (votes_[j] > votes_[i] || (votes_[j] == votes_[i] && j < i)) return false;
      }
    }
    return true;
  }

  float cell_;
  Eigen::Vector2f low_ = Eigen::Vector2f::Zero();
  int width_ = 0, height_ = 0;
  std::vector<float> votes_;
};

/// The point that comes closest to the lines that pass near a centre; nullopt if these are few.
std::optional<Eigen::Vector2f> refined(Eigen::Vector2f centre, const std::vector<NormalLine>& lines,
                                       float cell) {
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix2f A = Eigen::Matrix2f::Zero();
    Eigen::Vector2f b = Eigen::Vector2f::Zero();
    int count = 0;
    for (const NormalLine& line : lines) {
      const Eigen::Vector2f x = line.at - centre;
      const float r = x.norm();
      if (r > kMaxRadius * cell || r < kMinRadius * cell) continue;
      if (!line.meets_axis(cell, centre)) continue;
      const Eigen::Vector2f across(line.along.y(), -line.along.x());
      A += across * across.transpose();
      b += across * across.dot(line.at - centre);
      ++count;
    }
    if (count < kMinLines) return std::nullopt;
    centre += (A + 1e-6f * Eigen::Matrix2f::Identity()).inverse() * b;
  }
  return centre;
}

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
  std::vector<Axis> axes;
  for (const Eigen::Vector2f& maximum : Votes(lines, cell).maxima(max_axes)) {
    const std::optional<Eigen::Vector2f> centre = refined(maximum, lines, cell);
    if (!centre) continue;
    axes.push_back({X_CA.linear().leftCols<2>() * centre->cast<double>(), direction});
  }
  return axes;
}

}  // namespace quadrille
