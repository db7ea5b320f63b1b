#include "surfaces/two_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "fit/coaxial_fit.hpp"
#include "fit/family_spec.hpp"
#include "fit/straight_profile.hpp"
#include "samples/inliers.hpp"
#include "samples/region.hpp"
#include "surfaces/evidence/evidence.hpp"
#include "surfaces/samples_about.hpp"
#include "surfaces/surface_fit.hpp"
#include "surfaces/two_lines.hpp"

namespace quadrille {
namespace {

// Number of steps of a fit about one axis, after which nearly all have converged.
constexpr int kIterations = 6;
// How often lines are sought and fitted. The axis of an ellipsoid that was fitted to a body and its
// shoulder may lean by 8°, and needs three fits to stand.
constexpr int kRounds = 4;
// Pieces with so many times the loss of the one quadric do not become better by further rounds.
constexpr double kHopeless = 2.0;
// Number of bottles, jars and flasks for each other thing in which a cylinder goes on as a curved
// surface about the same axis, such as a lamp or a vase with a foot.
constexpr double kBottleOdds = 20.0;
// Least number of samples of a piece that is fitted: a cone has six unknowns.
constexpr std::size_t kLeastSamples = 9;
// Unknowns of an axis, which the pieces share, and of the crease between them.
constexpr int kAxis = 4, kCrease = 1;

/// The samples of a piece, and the points and result of its fit.
struct Piece {
  std::vector<int> region;
  Normalisation local;
  OrientedPointsf points;
  FamilyFit fit;

  Eigen::Matrix4f matrix() const {
    return local.to_frame(fit.posed.matrix()).normalized().matrix().cast<float>();
  }
};

/// Divides one surface.
class Division {
 public:
  Division(const Surface& surface, const Surface* sibling, const SurfaceSamples& samples,
           const Mask& free, const AggregateOptions& options)
      : surface_(surface),
        samples_(samples),
        options_(options),
        flaw_(static_cast<float>(kFlawShare * surface.local.scale)),
        X_CA_(form_of(sibling ? *sibling : surface).X),
        around_(samples_about(X_CA_, surface.region, samples, free)),
        loss_of_one_(loss_of_one()) {
    if (!sibling) return;
    sibling_ = piece_of(sibling->region, sibling->local);
    sibling_->fit.family = sibling->fit.family;
    sibling_->fit.posed = sibling->fit.posed;
  }

  std::optional<TwoPieces> pieces() {
    if (!around_.outside) return std::nullopt;
    // No pieces are better than those that explain all samples exactly.
    if (!(criterion_of_one(loss_of_one_) > criterion_of_two(0.0))) return std::nullopt;
    for (int round = 0; round < kRounds; ++round) {
      if (!take_lines() || !fit()) return std::nullopt;
      seek_crease();
      if (loss_of_two_ > kHopeless * loss_of_one_) return std::nullopt;
    }
    const double gain = criterion_of_one(loss_beside_cylinder()) - criterion_of_two(loss_of_two_);
    if (!(gain > 0.0)) return std::nullopt;
    take_inliers();
    std::array<Surface, 2> found;
    for (std::size_t k = 0; k < 2; ++k) {
      auto& [region, local, points, fit] = pieces_[k];
      if (region.empty()) return std::nullopt;
      const double share = static_cast<double>(region.size()) / size();
      found[k] = surface_of(std::move(region), local, std::move(fit), points);
      found[k].effective_size = std::max(2.0, share * effective_size());
      if (is_thin(found[k], samples_)) return std::nullopt;
    }
    return TwoPieces{std::move(found[0]), std::move(found[1]), gain};
  }

 private:
  double size() const { return static_cast<double>(around_.samples.size()); }

  /// A piece whose fit has no quadric yet.
  Piece piece_of(std::vector<int> region, const Normalisation& local) const {
    Piece piece{{}, local, fit_points(samples_, region, local, options_.fit_points), {}};
    piece.fit.points = static_cast<int>(piece.points.size());
    piece.region = std::move(region);
    return piece;
  }

  float variance(int i) const { return samples_.sigma[i] * samples_.sigma[i] + flaw_ * flaw_; }

  /// The profile of the samples around, sorted by height.
  std::vector<std::pair<MeridianPoint, int>> profile() const {
    const Eigen::Isometry3f X_AC = X_CA_.inverse().cast<float>();
    std::vector<std::pair<MeridianPoint, int>> result;
    for (const int i : around_.samples) {
      const Eigen::Vector3f x = X_AC * samples_.raw[i];
      result.push_back({{x.z(), x.head<2>().norm(), variance(i)}, i});
    }
    std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
      return std::pair(a.first.z, a.second) < std::pair(b.first.z, b.second);
    });
    return result;
  }

  /// Gives each piece the samples on its line. False if one has too few.
  bool take_lines() {
    if (around_.samples.size() < kLeastProfile) return false;
    const auto sorted = profile();
    std::vector<MeridianPoint> points;
    points.reserve(sorted.size());
    for (const auto& [point, i] : sorted) points.push_back(point);
    const TwoLines lines = two_lines(points);
    std::array<std::vector<int>, 2> regions;
    for (const auto& [point, i] : sorted) {
      assign(i, lines.loss_on_cylinder(point), lines.loss_on_cone(point), &regions);
    }
    for (std::size_t k = 0; k < 2; ++k) {
      if (regions[k].size() < kLeastSamples) return false;
      const Normalisation local = normalisation_of(samples_, regions[k]);
      pieces_[k] = piece_of(std::move(regions[k]), local);
    }
    return true;
  }

  /// Adds a sample to the region of the piece on which it lies, if it lies on one.
  static void assign(int i, float on_cylinder, float on_cone,
                     std::array<std::vector<int>, 2>* regions) {
    if (std::min(on_cylinder, on_cone) >= kMaxDeviations * kMaxDeviations) return;
    (*regions)[on_cylinder <= on_cone ? 0 : 1].push_back(i);
  }

  /// Fits the pieces and the sibling about one axis.
  bool fit() {
    constexpr std::array kFamilies = {Family::kCylinder, Family::kCone};
    std::vector<Piece*> fitted = {&pieces_[0], &pieces_[1]};
    for (std::size_t k = 0; k < 2; ++k) {
      const ProfileLine line = profile_line(pieces_[k].points, pieces_[k].local, X_CA_);
      pieces_[k].fit.family = kFamilies[k];
      pieces_[k].fit.posed = straight_quadric(kFamilies[k], line, line.slope);
    }
    if (sibling_) fitted.push_back(&*sibling_);
    std::vector<std::unique_ptr<DistanceSums<float>>> sums;
    std::vector<CoaxialPart> parts;
    for (const Piece* piece : fitted) {
      sums.push_back(std::make_unique<DistanceSums<float>>(piece->points));
      // A point counts for all samples for which it stands.
      const double weight = static_cast<double>(piece->region.size()) / piece->fit.points;
      parts.push_back({piece->fit, piece->local, sums.back().get(), weight});
    }
    const std::optional<CoaxialFit> joint = fit_coaxial(parts, kIterations);
    if (!joint) return false;
    for (std::size_t k = 0; k < fitted.size(); ++k) fitted[k]->fit = joint->parts[k];
    X_CA_ = joint->X_CA;
    return true;
  }

  float loss(int i, const Eigen::Matrix4f& Q) const {
    return truncated_loss(distance_to(Q, samples_.raw[i]), variance(i));
  }

  /// Number of independent measurements among the samples around.
  double effective_size() const {
    const double share = surface_.effective_size / static_cast<double>(surface_.region.size());
    return std::max(2.0, std::min(options_.effective_size, share * size()));
  }

  double criterion(double loss, int dof) const {
    return effective_size() * loss / size() + dof * std::log(effective_size());
  }

  double loss_of_one() const {
    const Eigen::Matrix4f Q = surface_.Q.matrix().cast<float>();
    double sum = 0.0;
    for (const int i : around_.samples) sum += loss(i, Q);
    return sum;
  }

  /// The loss of the one quadric if samples beyond its region may lie on the cylinder: what the
  /// quadric leaves over there speaks against it no more than against the cone.
  double loss_beside_cylinder() const {
    const Eigen::Matrix4f one = surface_.Q.matrix().cast<float>(), cylinder = pieces_[0].matrix();
    std::vector<int> region = surface_.region;
    std::sort(region.begin(), region.end());
    double sum = 0.0;
    for (const int i : around_.samples) {
      const float on_one = loss(i, one);
      const bool is_own = std::binary_search(region.begin(), region.end(), i);
      sum += is_own ? on_one : std::min(on_one, loss(i, cylinder));
    }
    return sum;
  }

  double criterion_of_one(double loss) const {
    const double prior =
        log_prior(form_of(surface_).type) - (sibling_ ? std::log(kBottleOdds) : 0.0);
    return criterion(loss, family_spec(surface_.fit.family).dof) - 2.0 * prior;
  }

  /// Beside the pieces, the place of the crease between them is unknown.
  double criterion_of_two(double loss) const {
    return criterion(loss, family_spec(Family::kCylinder).dof + family_spec(Family::kCone).dof -
                               kAxis + kCrease);
  }

  /// Finds the height at which one piece ends and the other begins, with the least loss.
  void seek_crease() {
    const std::array Q = {pieces_[0].matrix(), pieces_[1].matrix()};
    const auto sorted = profile();
    std::array<double, 2> all = {0.0, 0.0};
    for (const auto& [point, i] : sorted) {
      for (std::size_t k = 0; k < 2; ++k) all[k] += loss(i, Q[k]);
    }
    loss_of_two_ = std::numeric_limits<double>::infinity();
    std::array<double, 2> below = {0.0, 0.0};
    for (const auto& [point, i] : sorted) {
      for (std::size_t k = 0; k < 2; ++k) {
        const double sum = below[k] + all[1 - k] - below[1 - k];
        if (sum < loss_of_two_) loss_of_two_ = sum, crease_ = point.z, lower_ = k;
      }
      for (std::size_t k = 0; k < 2; ++k) below[k] += loss(i, Q[k]);
    }
  }

  /// Gives each piece the samples on its side of the crease that lie on its quadric.
  void take_inliers() {
    const std::array Q = {pieces_[0].matrix(), pieces_[1].matrix()};
    std::array<std::vector<int>, 2> regions;
    for (const auto& [point, i] : profile()) {
      const std::size_t k = point.z < crease_ ? lower_ : 1 - lower_;
      if (loss(i, Q[k]) < kMaxDeviations * kMaxDeviations) regions[k].push_back(i);
    }
    for (std::size_t k = 0; k < 2; ++k) {
      std::sort(regions[k].begin(), regions[k].end());
      pieces_[k].region = std::move(regions[k]);
    }
  }

  const Surface& surface_;
  const SurfaceSamples& samples_;
  const AggregateOptions& options_;
  /// How far a real object may deviate from a quadric [m].
  float flaw_;
  /// Pose whose z axis is the axis.
  Eigen::Isometry3d X_CA_;
  SamplesAbout around_;
  double loss_of_one_;
  std::optional<Piece> sibling_;
  /// The cylinder and the cone.
  std::array<Piece, 2> pieces_;
  /// Height of the crease along the axis, and number of the piece below it.
  float crease_ = 0.0f;
  std::size_t lower_ = 0;
  double loss_of_two_ = 0.0;
};

bool is_curved_along_axis(const Surface& surface) {
  return has_one_axis(surface.fit.family) && !is_straight(surface.fit.family);
}

}  // namespace

std::optional<TwoPieces> two_pieces(const Surface& surface, const Surface* sibling,
                                    const SurfaceSamples& samples, const Mask& free,
                                    const AggregateOptions& options) {
  if (!is_curved_along_axis(surface)) return std::nullopt;
  return Division(surface, sibling, samples, free, options).pieces();
}

}  // namespace quadrille
