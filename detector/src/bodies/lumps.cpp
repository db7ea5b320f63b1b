#include "bodies/lumps.hpp"

#include <algorithm>
#include <limits>

#include "boxes/box_axes.hpp"
#include "boxes/face.hpp"

namespace quadrille {
namespace {

// A lump has at least so many samples: fewer may be noise, or points mixed from two surfaces.
constexpr std::size_t kMinSamples = 40;
// A lump must rise this many standard deviations of the noise above its support, beside the
// rounding. Far from the sensor, noise alone makes bumps of several standard deviations.
constexpr double kMinSigmas = 6.0;
// The middle of a lump lies at least so far inside the outline of its support, as a view that shows
// the lump sees it [m]. It is more than the ten pixels by which stereo cameras misplace edges, a
// metre away.
constexpr double kMinInside = 0.03;
// A view shows a lump if it has at least this share of the samples that each view would have if all
// that see the lump had equally many.
constexpr double kViewShare = 0.5;

double largest_sigma(const SurfaceSamples& samples, const std::vector<int>& piece) {
  double largest = 0.0;
  for (const int i : piece) largest = std::max<double>(largest, samples.sigma[i]);
  return largest;
}

/// True if a view that shows a piece sees the support around the piece's middle. The noise of a
/// view is largest at its border, where another view may know the support well.
bool is_surrounded(const SurfaceSamples& samples, const std::vector<int>& piece,
                   const Eigen::Vector3d& middle_C, const Support& support) {
  if (support.outlines_Q.empty()) return true;
  std::vector<std::size_t> count(support.outlines_Q.size(), 0);
  for (const int i : piece) ++count[samples.view_of(i)];
  const auto seeing = count.size() - std::count(count.begin(), count.end(), 0u);
  const double equal = static_cast<double>(piece.size()) / static_cast<double>(seeing);
  for (std::size_t v = 0; v < count.size(); ++v) {
    const bool shows = static_cast<double>(count[v]) >= kViewShare * equal;
    if (shows && support.inside(middle_C, v) >= kMinInside) return true;
  }
  return false;
}

}  // namespace

Mask open_samples(const SurfaceSamples& samples, const std::vector<int>& owner,
                  const std::vector<Box>& boxes) {
  Mask open(owner.size());
  for (std::size_t i = 0; i < owner.size(); ++i) open[i] = owner[i] == 0;
  for (const Box& box : boxes) {
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kRounding);
    const Eigen::AlignedBox3d around_B(box.outer_B.min() - margin, box.outer_B.max() + margin);
    const Eigen::Isometry3d X_BC = box.X_CB.inverse();
    for (std::size_t i = 0; i < owner.size(); ++i) {
      if (open[i] && around_B.contains(X_BC * samples.raw[i].cast<double>())) open[i] = 0;
    }
  }
  return open;
}

const Support* lump_support(const SurfaceSamples& samples, const std::vector<int>& piece,
                            const std::vector<Support>& supports, bool alone) {
  if (piece.size() < kMinSamples) return nullptr;
  Eigen::Vector3d middle_C = Eigen::Vector3d::Zero();
  for (const int i : piece) {
    middle_C += samples.raw[i].cast<double>() / static_cast<double>(piece.size());
  }
  const Support* support = support_below(supports, middle_C);
  if (support == nullptr) return nullptr;
  // Things do not float, though what stands before them may hide their feet.
  const bool floats = std::all_of(piece.begin(), piece.end(), [&](int i) {
    return support->height(samples.raw[i].cast<double>()) >= kMaxFootGap;
  });
  return alone && floats ? nullptr : support;
}

Mask above_support(const SurfaceSamples& samples, const std::vector<int>& piece,
                   const Support& support) {
  Mask above(samples.raw.size(), 0);
  for (const int i : piece) {
    above[i] = support.height(samples.raw[i].cast<double>()) > kRounding;
  }
  return above;
}

std::optional<SceneBody> lump_of(const SurfaceSamples& samples, const std::vector<int>& piece,
                                 const Support& support) {
  if (piece.size() < kMinSamples) return std::nullopt;
  Face outline;
  for (const int i : piece) outline.points_C.push_back(samples.raw[i].cast<double>());
  for (const Eigen::Vector3d& p : outline.points_C) {
    outline.middle_C += p / static_cast<double>(piece.size());
  }
  outline.n_C = support.n_C;
  const Eigen::Matrix3d R_CA = box_axes({&outline});
  Eigen::AlignedBox3d box_A;
  for (const Eigen::Vector3d& p : outline.points_C) {
    box_A.extend(Eigen::Vector3d(R_CA.transpose() * p));
  }
  // Depth edges leave sheets of points that are mixed from two surfaces.
  const double height = box_A.max().x() - support.offset;
  const bool flat = height < kRounding + kMinSigmas * largest_sigma(samples, piece);
  const bool thin = box_A.sizes().tail<2>().minCoeff() < kRounding;
  if (flat || thin) return std::nullopt;
  // Sensors see edges of the support wider than they are, and matter in the air beside them.
  if (!is_surrounded(samples, piece, outline.middle_C, support)) return std::nullopt;

  SceneBody body;
  body.kind = BodyKind::kLump;
  if (box_A.min().x() - support.offset < kMaxFootGap) {
    body.standing_on = support.id;
    box_A.min().x() = support.offset;
    body.seen[2] = true;
  }
  // From the axes (up, u, v) to (u, v, up), which keeps their handedness.
  body.X_CB.linear() << R_CA.col(1), R_CA.col(2), R_CA.col(0);
  body.X_CB.translation() = R_CA * box_A.center();
  const Eigen::Vector3d size_A = box_A.sizes();
  body.size = {size_A.y(), size_A.z(), size_A.x()};
  // Its hidden side is not seen, so only the height above its support is known, up to a cell.
  body.std.setConstant(std::numeric_limits<double>::infinity());
  if (body.seen[2]) body.std.z() = samples.cell[piece.front()];
  return body;
}

}  // namespace quadrille
