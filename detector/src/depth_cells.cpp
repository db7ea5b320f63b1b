#include "quadrille/detector/depth_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace quadrille {
namespace {

constexpr int kLeastPoints = 200;
// Widest field of view that one pinhole image can hold, as a tangent.
constexpr float kWidestTangent = 2.0f;
// A step in depth between neighbours of one surface: tan(75°) per cell, plus noise that grows
// as the square of the depth.
constexpr float kSteepest = 3.7f;
constexpr float kNoisePerSquareMetre = 0.008f;

/// Rotation that turns the mean viewing direction to z; the identity where z serves already, so
/// that the pixels of a depth camera stay aligned.
std::optional<Eigen::Isometry3f> view_frame(const PointCloud& cloud) {
  const Eigen::Vector3f eye = cloud.viewpoint.cast<float>();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::size_t finite = 0, ahead = 0;
  for (const Eigen::Vector3f& p : cloud.points) {
    if (!p.allFinite()) continue;
    const Eigen::Vector3f ray = p - eye;
    const float length = ray.norm();
    if (!(length > 1e-6f)) continue;
    ++finite;
    ahead += ray.z() > 0.0f;
    sum += (ray / length).cast<double>();
  }
  if (finite < kLeastPoints || sum.norm() < 0.3 * static_cast<double>(finite)) return std::nullopt;
  const Eigen::Vector3f axis = sum.normalized().cast<float>();
  Eigen::Isometry3f X_VC = Eigen::Isometry3f::Identity();
  if (ahead != finite || axis.z() < 0.8f) {
    X_VC.linear() =
        Eigen::Quaternionf::FromTwoVectors(axis, Eigen::Vector3f::UnitZ()).toRotationMatrix();
  }
  X_VC.translation() = X_VC.linear() * -eye;
  return X_VC;
}

/// Tangents (u, v) of all points in front of the view.
std::vector<Eigen::Vector2f> tangents(const PointCloud& cloud, const Eigen::Isometry3f& X_VC,
                                      std::size_t* behind) {
  std::vector<Eigen::Vector2f> uv;
  uv.reserve(cloud.points.size());
  *behind = 0;
  for (const Eigen::Vector3f& p : cloud.points) {
    if (!p.allFinite()) continue;
    const Eigen::Vector3f q = X_VC * p;
    const Eigen::Vector2f t = q.head<2>() / q.z();
    if (q.z() > 1e-4f && t.cwiseAbs().maxCoeff() < kWidestTangent) {
      uv.push_back(t);
    } else {
      ++*behind;
    }
  }
  return uv;
}

float median(std::vector<float>& values) {
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Pixel pitch of a cloud in row order: the usual step between consecutive points of one row.
std::optional<float> pitch_from_order(const std::vector<Eigen::Vector2f>& uv) {
  std::vector<float> steps;
  const std::size_t stride = std::max<std::size_t>(1, uv.size() / 20000);
  std::size_t looked = 0;
  for (std::size_t i = 1; i < uv.size(); i += stride, ++looked) {
    const Eigen::Vector2f d = (uv[i] - uv[i - 1]).cwiseAbs();
    if (d.x() > 1e-5f && d.x() < 0.02f && d.y() < 0.05f * d.x()) steps.push_back(d.x());
  }
  if (steps.size() < looked / 2) return std::nullopt;
  const float usual = median(steps);
  // The steps of one pixel, averaged, undo the rounding of single ones.
  double sum = 0;
  int n = 0;
  for (const float s : steps) {
    if (std::abs(s - usual) < 0.2f * usual) sum += s, ++n;
  }
  return static_cast<float>(sum / n);
}

/// Pixel pitch from the density of points over the part of the image that they cover.
float pitch_from_density(const std::vector<Eigen::Vector2f>& uv) {
  constexpr int kBlocks = 64;
  const float step = 2 * kWidestTangent / (8 * kBlocks);
  std::vector<int> hist(64 * kBlocks * kBlocks, 0);
  for (const Eigen::Vector2f& t : uv) {
    const int i = static_cast<int>((t.x() + kWidestTangent) / step);
    const int j = static_cast<int>((t.y() + kWidestTangent) / step);
    ++hist[static_cast<std::size_t>(std::clamp(j, 0, 8 * kBlocks - 1)) * 8 * kBlocks +
           std::clamp(i, 0, 8 * kBlocks - 1)];
  }
  std::vector<float> counts;
  for (const int n : hist) {
    if (n > 0) counts.push_back(static_cast<float>(n));
  }
  return step / std::sqrt(std::max(1.0f, median(counts)));
}

/// Offset of the pixel centres within [0, 1) of a pixel, as a circular mean.
float phase(const std::vector<Eigen::Vector2f>& uv, int axis, float pitch) {
  double c = 0, s = 0;
  const std::size_t stride = std::max<std::size_t>(1, uv.size() / 5000);
  for (std::size_t i = 0; i < uv.size(); i += stride) {
    const double a = 2 * M_PI * static_cast<double>(uv[i][axis]) / pitch;
    c += std::cos(a);
    s += std::sin(a);
  }
  const double turn = std::atan2(s, c) / (2 * M_PI);
  return static_cast<float>(turn - std::floor(turn));
}

/// Share of 4x4-pixel cells in which points stand in clearly different depths, away from the
/// simple two sides of an edge: many for a fused cloud, few for a single view.
double layered_share(const PointCloud& cloud, const PinholeView& view) {
  const int width = view.width / 4 + 1, height = view.height / 4 + 1;
  std::vector<float> nearest(static_cast<std::size_t>(width) * height, 0.0f);
  std::vector<int> total(nearest.size(), 0), deeper(nearest.size(), 0);
  const auto cell_of = [&](const Eigen::Vector3f& q) -> std::ptrdiff_t {
    const int i = static_cast<int>((q.x() / q.z() - view.u0) / (4 * view.pitch));
    const int j = static_cast<int>((q.y() / q.z() - view.v0) / (4 * view.pitch));
    if (i < 0 || j < 0 || i >= width || j >= height) return -1;
    return static_cast<std::ptrdiff_t>(j) * width + i;
  };
  for (int pass = 0; pass < 2; ++pass) {
    for (const Eigen::Vector3f& p : cloud.points) {
      if (!p.allFinite()) continue;
      const Eigen::Vector3f q = view.X_VC * p;
      if (!(q.z() > 1e-4f)) continue;
      const std::ptrdiff_t c = cell_of(q);
      if (c < 0) continue;
      if (pass == 0) {
        nearest[c] = std::max(nearest[c], 1.0f / q.z());
      } else {
        ++total[c];
        deeper[c] += q.z() * nearest[c] > 1.05f;
      }
    }
  }
  int cells = 0, layered = 0;
  for (std::size_t c = 0; c < total.size(); ++c) {
    if (total[c] < 4) continue;
    ++cells;
    layered += deeper[c] >= 2 && deeper[c] <= total[c] - 2;
  }
  return cells ? static_cast<double>(layered) / cells : 1.0;
}

PinholeView organised_view(const PointCloud& cloud, const Eigen::Isometry3f& X_VC,
                           const std::vector<Eigen::Vector2f>& uv, float pitch) {
  static_cast<void>(cloud);
  PinholeView view;
  view.X_VC = X_VC;
  view.pitch = pitch;
  Eigen::Vector2f low = uv[0], high = uv[0];
  for (const Eigen::Vector2f& t : uv) {
    low = low.cwiseMin(t);
    high = high.cwiseMax(t);
  }
  // Pixel centres stand at half steps from the corner.
  view.u0 = (std::floor(low.x() / pitch - phase(uv, 0, pitch) - 0.5f) + phase(uv, 0, pitch)) * pitch +
            0.5f * pitch;
  view.v0 = (std::floor(low.y() / pitch - phase(uv, 1, pitch) - 0.5f) + phase(uv, 1, pitch)) * pitch +
            0.5f * pitch;
  view.width = static_cast<int>((high.x() - view.u0) / pitch) + 1;
  view.height = static_cast<int>((high.y() - view.v0) / pitch) + 1;
  return view;
}

}  // namespace

std::optional<PinholeView> find_view(const PointCloud& cloud) {
  const std::optional<Eigen::Isometry3f> X_VC = view_frame(cloud);
  if (!X_VC) return std::nullopt;
  std::size_t behind = 0;
  const std::vector<Eigen::Vector2f> uv = tangents(cloud, *X_VC, &behind);
  if (uv.size() < kLeastPoints || behind > uv.size() / 50) return std::nullopt;
  const std::optional<float> ordered = pitch_from_order(uv);
  const float pitch = ordered ? *ordered : pitch_from_density(uv);
  const PinholeView view = organised_view(cloud, *X_VC, uv, pitch);
  const double pixels = static_cast<double>(view.width) * view.height;
  // An image that is nearly empty, or larger than any camera's, is no image.
  if (pixels > 64e6 || static_cast<double>(uv.size()) < 0.01 * pixels) return std::nullopt;
  if (layered_share(cloud, view) > 0.2) return std::nullopt;
  return view;
}

bool continuous(const DepthCells& cells, float w_a, float w_b) {
  const float w = std::min(w_a, w_b);
  const float limit = kSteepest * cells.metric(w) + kNoisePerSquareMetre / (w * w);
  return std::abs(1.0f / w_a - 1.0f / w_b) < limit;
}

DepthCells make_depth_cells(const PointCloud& cloud, const PinholeView& view, int pixels) {
  DepthCells cells;
  cells.view = view;
  cells.pixels = pixels;
  cells.width = (view.width + pixels - 1) / pixels;
  cells.height = (view.height + pixels - 1) / pixels;
  const std::size_t size = static_cast<std::size_t>(cells.size());
  const float step = 1.0f / (view.pitch * static_cast<float>(pixels));

  struct Sums {
    float n = 0, u = 0, v = 0, w = 0, least = 1e30f, most = 0;
    void add(const Eigen::Vector3f& t) {
      n += 1, u += t.x(), v += t.y(), w += t.z();
      least = std::min(least, t.z());
      most = std::max(most, t.z());
    }
  };
  std::vector<Sums> sums(size);
  std::vector<Eigen::Vector3f> tangent;
  std::vector<int> cell_of;
  tangent.reserve(cloud.points.size());
  cell_of.reserve(cloud.points.size());
  for (const Eigen::Vector3f& p : cloud.points) {
    const Eigen::Vector3f q = view.X_VC * p;
    if (!(q.z() > 1e-4f)) continue;  // also drops NaN
    const float w = 1.0f / q.z();
    const Eigen::Vector3f t(q.x() * w, q.y() * w, w);
    const float i = (t.x() - view.u0) * step, j = (t.y() - view.v0) * step;
    if (!(i >= 0 && j >= 0 && i < static_cast<float>(cells.width) &&
          j < static_cast<float>(cells.height))) {
      continue;
    }
    const int c = static_cast<int>(j) * cells.width + static_cast<int>(i);
    tangent.push_back(t);
    cell_of.push_back(c);
    sums[c].add(t);
  }

  // Cells across a depth edge: keep the side, near or far of the middle, that has more points.
  std::vector<int> split(size, -1);
  std::vector<std::array<Sums, 2>> sides;
  std::vector<float> middle;
  for (std::size_t c = 0; c < size; ++c) {
    if (sums[c].n < 2 || continuous(cells, sums[c].least, sums[c].most)) continue;
    split[c] = static_cast<int>(sides.size());
    sides.emplace_back();
    middle.push_back(0.5f * (sums[c].least + sums[c].most));
  }
  if (!sides.empty()) {
    for (std::size_t k = 0; k < tangent.size(); ++k) {
      const int s = split[cell_of[k]];
      if (s >= 0) sides[s][tangent[k].z() > middle[s]].add(tangent[k]);
    }
    for (std::size_t c = 0; c < size; ++c) {
      if (split[c] < 0) continue;
      const auto& [far, near] = sides[split[c]];
      sums[c] = near.n >= far.n ? near : far;
    }
  }

  cells.count.resize(size);
  cells.u.resize(size), cells.v.resize(size), cells.w.resize(size);
  for (std::size_t c = 0; c < size; ++c) {
    const float n = sums[c].n;
    cells.count[c] = static_cast<int>(n);
    if (n == 0) continue;
    cells.u[c] = sums[c].u / n;
    cells.v[c] = sums[c].v / n;
    cells.w[c] = sums[c].w / n;
  }
  return cells;
}

DepthCells coarser(const DepthCells& fine, const std::vector<char>& keep) {
  DepthCells cells;
  cells.view = fine.view;
  cells.pixels = 2 * fine.pixels;
  cells.width = (fine.width + 1) / 2;
  cells.height = (fine.height + 1) / 2;
  const std::size_t size = static_cast<std::size_t>(cells.size());
  cells.count.assign(size, 0);
  cells.u.assign(size, 0), cells.v.assign(size, 0), cells.w.assign(size, 0);
  for (int j = 0; j < cells.height; ++j) {
    for (int i = 0; i < cells.width; ++i) {
      std::array<int, 4> child;
      int n = 0;
      for (int b = 0; b < 2; ++b) {
        for (int a = 0; a < 2; ++a) {
          const int x = 2 * i + a, y = 2 * j + b;
          if (x >= fine.width || y >= fine.height) continue;
          const int c = y * fine.width + x;
          if (fine.count[c] > 0 && (keep.empty() || keep[c])) child[n++] = c;
        }
      }
      if (n == 0) continue;
      std::sort(child.begin(), child.begin() + n,
                [&](int a, int b) { return fine.w[a] != fine.w[b] ? fine.w[a] < fine.w[b] : a < b; });
      const float reference = fine.w[child[n / 2]];
      float u = 0, v = 0, w = 0, total = 0;
      for (int k = 0; k < n; ++k) {
        if (!continuous(cells, fine.w[child[k]], reference)) continue;
        const float m = static_cast<float>(fine.count[child[k]]);
        u += m * fine.u[child[k]], v += m * fine.v[child[k]], w += m * fine.w[child[k]];
        total += m;
      }
      const int c = j * cells.width + i;
      cells.count[c] = static_cast<int>(total);
      cells.u[c] = u / total, cells.v[c] = v / total, cells.w[c] = w / total;
    }
  }
  return cells;
}

}  // namespace quadrille
