#include "surfaces/lid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/mask.hpp"
#include "base/quantile.hpp"
#include "base/symmetric_eigen.hpp"

namespace quadrille {
namespace {

// Share of the samples cut off at an end, so that stray samples do not move it.
constexpr double kTrimmedEnd = 0.02;
// Samples within this many cells of an end are next to the lid. It lies within as many cells of the
// end along the axis, since noise and rounded edges cost the wall its last cells.
constexpr double kReachCells = 2.5;
// The lid is sought this many cells inside of the wall.
constexpr std::array<double, 3> kInwardCells = {1.5, 2.5, 3.5};
// Cells lie on a lid within this many deviations of the noise, or this share of a cell's edge until
// its plane is known.
constexpr double kMaxSigmas = 4.0, kMaxFirstCells = 0.5;
// Least sine of the elevation of the eye over a lid (10°); lower, one cell spans the whole lid.
constexpr double kMinSine = 0.17;
// Least cosine between the axis and the lid's normal: 9°, as between parts of one body. The axis of
// a narrow strip of wall is that uncertain.
constexpr double kMinCosine = 0.988;
// Least number of cells of a lid, which are enough for a plane and its noise, and most, in cells of
// the wall: the wall of a flat tin has an eighth of its lid's cells, and that of a post on a table
// far less of the table's.
constexpr std::size_t kMinCells = 12;
constexpr double kMaxCellsShare = 8.0;

/// The cells of a view, with the places in frame C that they show.
class SightCells {
 public:
  explicit SightCells(const Sight& sight) : sight_(sight), X_CV_(sight.X_VC.inverse()) {}

  /// The cell in the direction of a place; −1 if it is outside of the image or saw nothing.
  int towards(const Eigen::Vector3d& p_C) const {
    const Eigen::Vector3f p_V = sight_.X_VC * p_C.cast<float>();
    if (!(p_V.z() > 0.0f)) return -1;
    const float i = std::floor((p_V.x() / p_V.z() - sight_.corner.x()) / sight_.step);
    const float j = std::floor((p_V.y() / p_V.z() - sight_.corner.y()) / sight_.step);
    if (!(i >= 0.0f && j >= 0.0f)) return -1;
    if (!(i < static_cast<float>(sight_.width) && j < static_cast<float>(sight_.height))) return -1;
    const int cell = static_cast<int>(j) * sight_.width + static_cast<int>(i);
    return sight_.w[cell] > 0.0f ? cell : -1;
  }
  Eigen::Vector3d place_of(int cell) const {
    const int i = cell % sight_.width, j = cell / sight_.width;
    const float u = sight_.corner.x() + (static_cast<float>(i) + 0.5f) * sight_.step;
    const float v = sight_.corner.y() + (static_cast<float>(j) + 0.5f) * sight_.step;
    return (X_CV_ * (Eigen::Vector3f(u, v, 1.0f) / sight_.w[cell])).cast<double>();
  }
  /// Calls a function with each of the four neighbours that saw something.
  template <class Visit>
  void for_neighbours(int cell, const Visit& visit) const {
    const int i = cell % sight_.width, j = cell / sight_.width;
    const auto at = [&](int other) {
      if (sight_.w[other] > 0.0f) visit(other);
    };
    if (i > 0) at(cell - 1);
    if (i + 1 < sight_.width) at(cell + 1);
    if (j > 0) at(cell - sight_.width);
    if (j + 1 < sight_.height) at(cell + sight_.width);
  }
  int size() const { return sight_.width * sight_.height; }
  Eigen::Vector3d eye_C() const { return X_CV_.translation().cast<double>(); }

 private:
  const Sight& sight_;
  Eigen::Isometry3f X_CV_;
};

/// One end of a surface.
struct SurfaceEnd {
  /// Unit direction of the axis out of the surface, and the place of the end along it [m].
  Eigen::Vector3d out_C;
  double at = 0.0;
  double cell = 0.0, sigma = 0.0;
};

/// Cells of a view that may lie on the lid of an end, one for each look over the edge of the wall.
std::vector<int> cells_inside(const Surface& surface, const SurfaceSamples& samples,
                              const SightCells& cells, const CanonicalForm& form,
                              const SurfaceEnd& end) {
  std::vector<int> inside;
  const double reach = kReachCells * end.cell;
  for (const int i : surface.region) {
    const Eigen::Vector3d p = samples.raw[i].cast<double>();
    const double below = end.at - end.out_C.dot(p);
    if (std::abs(below) > reach) continue;
    Eigen::Vector3d out = surface.Q.gradient(p);
    out -= end.out_C.dot(out) * end.out_C;
    out.normalize();
    if (out.dot(p - form.X.translation()) < 0.0) out = -out;
    if (!(out.dot(samples.n[i].cast<double>()) > 0.0)) continue;
    for (const double inward : kInwardCells) {
      const int c = cells.towards(p + below * end.out_C - inward * end.cell * out);
      if (c >= 0 && std::abs(end.out_C.dot(cells.place_of(c)) - end.at) < reach) {
        inside.push_back(c);
      }
    }
  }
  std::sort(inside.begin(), inside.end());
  inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
  return inside;
}

/// The cells of the wall.
std::vector<int> cells_of_wall(const Surface& surface, const SurfaceSamples& samples,
                               const SightCells& cells) {
  std::vector<int> wall;
  for (const int i : surface.region) {
    const int c = cells.towards(samples.raw[i].cast<double>());
    if (c >= 0) wall.push_back(c);
  }
  return wall;
}

/// All cells that continue the given ones within a plane n·x = d, but not those of the wall, which
/// leaves the plane slowly if the view is steep.
/// @return empty if there are more than `most`
std::vector<int> continued(const SightCells& cells, const std::vector<int>& from,
                           const std::vector<int>& wall, const Eigen::Vector3d& n, double d,
                           double tolerance, double most) {
  std::vector<int> found;
  Mask seen(static_cast<std::size_t>(cells.size()), 0);
  for (const int c : wall) seen[c] = 1;
  const auto add = [&](int c) {
    if (seen[c] || std::abs(n.dot(cells.place_of(c)) - d) > tolerance) return;
    seen[c] = 1;
    found.push_back(c);
  };
  for (const int c : from) add(c);
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (static_cast<double>(found.size()) > most) return {};
    cells.for_neighbours(found[k], add);
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// The frame of the plane through some places: their middle, and z along the normal on the side of
/// `out`.
Eigen::Isometry3d plane_frame(const std::vector<Eigen::Vector3d>& places,
                              const Eigen::Vector3d& out) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : places) middle += p / static_cast<double>(places.size());
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : places) S += (p - middle) * (p - middle).transpose();
  const Eigen::Vector3d n = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(S).eigenvectors().col(0);
  return pose_along(middle, n.dot(out) < 0.0 ? Eigen::Vector3d(-n) : n);
}

std::vector<Eigen::Vector3d> places_of(const SightCells& cells, const std::vector<int>& list) {
  std::vector<Eigen::Vector3d> places;
  places.reserve(list.size());
  for (const int c : list) places.push_back(cells.place_of(c));
  return places;
}

std::optional<Lid> lid_of(const Surface& surface, const SurfaceSamples& samples,
                          const SightCells& cells, const CanonicalForm& form,
                          const SurfaceEnd& end) {
  std::vector<int> inside = cells_inside(surface, samples, cells, form, end);
  if (inside.size() < 3) return std::nullopt;
  std::vector<double> heights;
  heights.reserve(inside.size());
  for (const int c : inside) heights.push_back(end.out_C.dot(cells.place_of(c)));
  const double most = kMaxCellsShare * static_cast<double>(surface.region.size());
  const std::vector<int> wall = cells_of_wall(surface, samples, cells);
  std::vector<int> found =
      continued(cells, inside, wall, end.out_C, median(heights),
                std::max(kMaxFirstCells * end.cell, kMaxSigmas * end.sigma), most);
  if (found.size() < kMinCells) return std::nullopt;
  Eigen::Isometry3d X_CL = plane_frame(places_of(cells, found), end.out_C);
  const Eigen::Vector3d n = X_CL.linear().col(2);
  if (n.dot(end.out_C) < kMinCosine) return std::nullopt;
  found = continued(cells, found, wall, n, n.dot(X_CL.translation()), kMaxSigmas * end.sigma, most);
  if (found.size() < kMinCells) return std::nullopt;
  std::vector<Eigen::Vector3d> places = places_of(cells, found);
  X_CL = plane_frame(places, end.out_C);
  return Lid{X_CL, std::move(places), end.cell};
}

}  // namespace

std::vector<Lid> find_lids(const Surface& surface, const SurfaceSamples& samples,
                           const Sight& sight) {
  std::vector<Lid> lids;
  if (sight.w.empty()) return lids;
  const CanonicalForm form = form_of(surface);
  const SightCells cells(sight);
  for (const double side : {-1.0, 1.0}) {
    SurfaceEnd end;
    end.out_C = side * form.X.linear().col(2);
    std::vector<double> along;
    along.reserve(surface.region.size());
    for (const int i : surface.region) {
      along.push_back(end.out_C.dot(samples.raw[i].cast<double>()));
      end.cell += samples.cell[i] / static_cast<double>(surface.region.size());
    }
    end.at = quantile(along, 1.0 - kTrimmedEnd);
    end.sigma = mean_sigma(samples, surface.region);
    const Eigen::Vector3d to_eye = cells.eye_C() - surface.local.centre;
    const double above = end.out_C.dot(cells.eye_C()) - end.at;
    if (above < kMinSine * to_eye.norm()) continue;
    if (auto lid = lid_of(surface, samples, cells, form, end)) lids.push_back(std::move(*lid));
  }
  return lids;
}

}  // namespace quadrille
