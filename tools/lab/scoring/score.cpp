#include "lab/scoring/score.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "base/quantile.hpp"
#include "lab/scoring/distance.hpp"
#include "lab/scoring/matching.hpp"

namespace quadrille::scoring {
namespace {

constexpr double kCover = 0.6, kPurity = 0.5;
constexpr std::size_t kMaxFindings = 100, kMinPoints = 40, kSamples = 30000;
const double kMinCosine = std::cos(20.0 * std::numbers::pi / 180.0);

/// Returns true if a point lies on the finding with its normal along the gradient, up to sign.
bool agrees(const Found& found, const Eigen::Vector3f& p, const Eigen::Vector3f& n,
            double tolerance) {
  const Eigen::Vector3d x = p.cast<double>(), g = found.gradient(x);
  const double length = g.norm();
  return std::abs(found.value(x)) <= tolerance * length && length > 0.0 &&
         std::abs(g.dot(n.cast<double>())) >= kMinCosine * length;
}

/// A surface with its own points, and all points near it.
struct Target {
  const TrueSurface* surface = nullptr;
  std::vector<std::size_t> own, near;
  double tolerance = 0.0;
};

Target target_of(const TrueSurface& surface, const Frame& frame) {
  Target target;
  target.surface = &surface;
  target.tolerance = std::max(2.0 * surface.sigma, std::min(0.02 * surface.size, 0.01));
  const Eigen::Vector3d middle = surface.box_S.center(), half = 0.5 * surface.box_S.sizes();
  const Eigen::Vector3d reach =
      (1.2 * half).cwiseMax(half + Eigen::Vector3d::Constant(3.0 * target.tolerance));
  const Eigen::Isometry3d X_SC = surface.X_CS.inverse();
  for (std::size_t i = 0; i < frame.labels.size(); ++i) {
    const bool own = frame.labels[i] == surface.id;
    const Eigen::Vector3d x_S = X_SC * frame.cloud.points[i].cast<double>();
    if (own) target.own.push_back(i);
    if (own || ((x_S - middle).cwiseAbs().array() <= reach.array()).all()) target.near.push_back(i);
  }
  return target;
}

/// The findings and the truth of one frame.
class Judge {
 public:
  Judge(const Frame& frame, const std::string& only) : frame_(frame) {
    for (const TrueSurface& surface : frame.surfaces) {
      body_of_[surface.id] = surface.body;
      Target target = target_of(surface, frame);
      if (target.own.size() < kMinPoints) continue;
      const bool asked = surface.evaluate && (only.empty() || surface.type == only);
      (!surface.curved ? planes_ : asked ? wanted_ : passed_).push_back(std::move(target));
    }
    const std::size_t step = std::max<std::size_t>(1, frame.labels.size() / kSamples);
    for (std::size_t i = 0; i < frame.labels.size(); i += step) {
      if (frame.labels[i] >= 0) samples_.push_back(i);
    }
  }

  /// Returns the finding of each required surface that was found, by the surface's id.
  std::map<int, int> pair_up(const std::vector<Found>& findings) const {
    std::map<int, int> pairs;
    for (const auto& [k, finding] : match_most(candidates_among(numbered(findings), wanted_))) {
      pairs[wanted_[k].surface->id] = finding;
    }
    return pairs;
  }

  Judgement judge(const Found& found) const {
    if (const auto id = best_among(found, wanted_)) return {Verdict::kRight, *id};
    if (const auto id = best_among(found, passed_)) return {Verdict::kHardlyVisible, *id};
    if (!is_flat(found)) return {};
    if (const auto id = best_among(found, planes_)) return {Verdict::kPlane, *id};
    return {Verdict::kNoPlane, -1};
  }

  FrameScore score(const std::vector<Found>& findings) const {
    FrameScore result;
    result.wanted = static_cast<int>(wanted_.size());
    std::map<int, Found> rest = numbered(findings);
    const Candidates candidates = candidates_among(rest, wanted_);
    for (const auto& [surface, finding] : match_most(candidates)) {
      ++result.found;
      add_width(wanted_[surface], findings[finding], &result);
      rest.erase(finding);
    }
    // A finding that also fits a surface that was already found is a duplicate; another surface
    // does not excuse it.
    std::map<int, Found> excusable = rest;
    for (const auto& [finding, surfaces] : candidates) excusable.erase(finding);
    for (const auto& [surface, finding] : match_most(candidates_among(excusable, passed_))) {
      rest.erase(finding);
    }
    judge_rest(rest, &result);
    for (const Target& target : wanted_) {
      result.distances.push_back(least_distance(*target.surface, points_of(target), findings));
    }
    return result;
  }

 private:
  static std::map<int, Found> numbered(const std::vector<Found>& findings) {
    std::map<int, Found> all;
    for (std::size_t i = 0; i < findings.size(); ++i) all[static_cast<int>(i)] = findings[i];
    return all;
  }

  std::vector<Eigen::Vector3f> points_of(const Target& target) const {
    std::vector<Eigen::Vector3f> points;
    for (const std::size_t i : target.own) points.push_back(frame_.cloud.points[i]);
    return points;
  }

  double coverage(const Found& found, const Target& target) const {
    std::size_t count = 0;
    for (const std::size_t i : target.own) count += agrees_at(found, i, target.tolerance);
    return static_cast<double>(count) / static_cast<double>(target.own.size());
  }

  double purity(const Found& found, const Target& target) const {
    std::size_t own = 0, all = 0;
    for (const std::size_t i : target.near) {
      if (!agrees_at(found, i, target.tolerance)) continue;
      ++all;
      own += belongs(frame_.labels[i], found, target);
    }
    return all > 0 ? static_cast<double>(own) / static_cast<double>(all) : 0.0;
  }

  bool belongs(int label, const Found& found, const Target& target) const {
    if (label == target.surface->id) return true;
    const auto body = body_of_.find(label);
    return found.superquadric && body != body_of_.end() && body->second == target.surface->body;
  }

  bool agrees_at(const Found& found, std::size_t i, double tolerance) const {
    return agrees(found, frame_.cloud.points[i], frame_.normals[i], tolerance);
  }

  Candidates candidates_among(const std::map<int, Found>& findings,
                              const std::vector<Target>& targets) const {
    Candidates candidates;
    for (const auto& [finding, found] : findings) {
      for (std::size_t k = 0; k < targets.size(); ++k) {
        const double cover = coverage(found, targets[k]);
        if (cover < kCover || purity(found, targets[k]) < kPurity) continue;
        candidates[finding][static_cast<int>(k)] = cover;
      }
    }
    return candidates;
  }

  /// Returns the id of the surface that a finding covers best; nullopt if it covers none.
  std::optional<int> best_among(const Found& found, const std::vector<Target>& targets) const {
    const Candidates candidates = candidates_among({{0, found}}, targets);
    if (candidates.empty()) return std::nullopt;
    const std::map<int, double>& surfaces = candidates.at(0);
    const auto best =
        std::max_element(surfaces.begin(), surfaces.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    return targets[static_cast<std::size_t>(best->first)].surface->id;
  }

  /// Returns true if the finding is flat over all points that support it. A superquadric is a body
  /// and never flat.
  bool is_flat(const Found& found) const {
    if (found.superquadric) return false;
    const Eigen::Matrix3d curved = found.Q_C.matrix().topLeftCorner<3, 3>();
    const Eigen::Vector3d linear = found.Q_C.matrix().topRightCorner<3, 1>();
    if (curved.cwiseAbs().maxCoeff() <= 1e-9 * linear.norm()) return true;
    std::vector<Eigen::Vector3d> gradients;
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for (const std::size_t i : samples_) {
      const double z = frame_.cloud.points[i].z();
      const double tolerance = std::max(2.0 * scene::depth_noise(frame_.noise, z), 0.003);
      if (!agrees_at(found, i, tolerance)) continue;
      gradients.push_back(found.gradient(frame_.cloud.points[i].cast<double>()).normalized());
      moment += gradients.back() * gradients.back().transpose();
    }
    if (gradients.size() < 20) return false;
    const Eigen::Vector3d axis =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moment).eigenvectors().col(2);
    std::vector<double> cosines;
    for (const Eigen::Vector3d& g : gradients) cosines.push_back(std::abs(g.dot(axis)));
    return nth_smallest(cosines, cosines.size() / 10) > std::cos(12.0 * std::numbers::pi / 180.0);
  }

  void judge_rest(const std::map<int, Found>& rest, FrameScore* result) const {
    std::map<int, Found> flat;
    for (const auto& [finding, found] : rest) {
      if (is_flat(found)) {
        flat[finding] = found;
      } else {
        ++result->wrong;
      }
    }
    for (const Target& plane : planes_) result->planes_wanted += plane.surface->evaluate;
    for (const auto& [surface, finding] : match_most(candidates_among(flat, planes_))) {
      ++result->planes_right;
      result->planes_found += planes_[surface].surface->evaluate;
    }
    result->planes_wrong = static_cast<int>(flat.size()) - result->planes_right;
  }

  /// Returns the length of the chord of a surface along a line; not finite if there is none.
  template <class Surface>
  static double chord(const Surface& surface, const Eigen::Vector3d& c, const Eigen::Vector3d& u) {
    const auto [first, second] = surface.crossings(c, u);
    return std::abs(first - second);
  }

  /// Returns where a surface's width is measured: at the centre of a closed surface, otherwise on
  /// the axis (z of frame S), halfway up the visible part.
  Eigen::Vector3d middle_of(const Target& target) const {
    const Eigen::Isometry3d& X_CS = target.surface->X_CS;
    const std::string& type = target.surface->type;
    if (type == "sphere" || type == "ellipsoid") return X_CS.translation();
    std::vector<double> heights;
    for (const std::size_t i : target.own) {
      heights.push_back((X_CS.inverse() * frame_.cloud.points[i].cast<double>()).z());
    }
    return X_CS * Eigen::Vector3d(0, 0, median(heights));
  }

  /// Compares the widths across the line of sight and the axis.
  void add_width(const Target& target, const Found& found, FrameScore* result) const {
    const Eigen::Vector3d c = middle_of(target), axis = target.surface->X_CS.linear().col(2);
    Eigen::Vector3d u = c.cross(axis);
    // If it is seen along its axis, the width is the same, or nearly so, in all directions.
    u = u.norm() > 1e-3 * c.norm() ? u.normalized() : c.unitOrthogonal();
    const double truth = chord(target.surface->Q_C, c, u);
    if (!std::isfinite(truth)) return;
    const double width = chord(found, c, u);
    const double error =
        std::isfinite(width) ? std::abs(width - truth) : std::numeric_limits<double>::infinity();
    result->width_errors.push_back(error / truth);
    result->widths_right += error <= std::max(0.004, 0.1 * truth);
  }

  const Frame& frame_;
  std::map<int, int> body_of_;
  std::vector<Target> wanted_, passed_, planes_;
  std::vector<std::size_t> samples_;
};

}  // namespace

std::vector<Found> findings_of(const DetectionResult& result) {
  std::vector<Found> findings;
  for (const Detection& d : result.detections) findings.push_back({d.Q_C, d.score});
  return findings;
}

FrameScore score(const Frame& frame, std::vector<Found> findings, const std::string& only) {
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Found& a, const Found& b) { return a.score > b.score; });
  std::vector<Found> judged;
  int beyond = 0;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    if (i < kMaxFindings && findings[i].is_surface()) {
      judged.push_back(findings[i]);
    } else {
      ++beyond;
    }
  }
  FrameScore result = Judge(frame, only).score(judged);
  result.wrong += beyond;
  return result;
}

std::vector<Judgement> judge_each(const Frame& frame, const std::vector<Quadric>& quadrics) {
  const Judge judge(frame, "");
  std::vector<Judgement> judgements;
  for (const Quadric& Q : quadrics) judgements.push_back(judge.judge({Q, 1.0}));
  return judgements;
}

std::map<int, int> pair_up(const Frame& frame, const std::vector<Found>& findings) {
  return Judge(frame, "").pair_up(findings);
}

}  // namespace quadrille::scoring
