#include "surfaces/aggregate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "detector/pipe.hpp"
#include "quadrille/detector/quadric.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// A candidate on the samples of some rows.
Candidate candidate_of(const Quadric& Q, int from_row, int to_row) {
  Candidate candidate;
  candidate.Q = Q;
  candidate.family = Family::kCylinder;
  for (int i = from_row * kPipeColumns; i < to_row * kPipeColumns; ++i)
    candidate.region.push_back(i);
  candidate.rms = 0.0005;
  return candidate;
}

Quadric cylinder_quadric(double radius) { return Quadric(diagonal(1, 1, 0, -radius * radius)); }

double radius_of(const Surface& surface) {
  const CanonicalForm form = canonical_form(Quadric(surface.fit.posed.matrix()), 1e-7);
  REQUIRE(form.type == QuadricType::kCylinder);
  return surface.local.scale * form.dimensions[0].second;
}

/// The samples without those of some rows, as if something stood in front of them.
SurfaceSamples occluded(const SurfaceSamples& all, int from_row, int to_row) {
  SurfaceSamples rest;
  std::vector<int> index(static_cast<std::size_t>(all.size()), -1);
  for (int i = 0; i < all.size(); ++i) {
    if (i / kPipeColumns >= from_row && i / kPipeColumns < to_row) continue;
    index[static_cast<std::size_t>(i)] = rest.size();
    rest.p.push_back(all.p[i]), rest.n.push_back(all.n[i]), rest.raw.push_back(all.raw[i]);
    rest.sigma.push_back(all.sigma[i]), rest.cell.push_back(all.cell[i]);
    rest.count.push_back(all.count[i]), rest.source.push_back(i);
  }
  rest.first.push_back(0);
  for (const int i : rest.source) {
    for (const int j : all.neighbours_of(i)) {
      if (index[static_cast<std::size_t>(j)] >= 0) {
        rest.neighbours.push_back(index[static_cast<std::size_t>(j)]);
      }
    }
    rest.first.push_back(static_cast<int>(rest.neighbours.size()));
  }
  return rest;
}

}  // namespace

TEST_CASE("a good candidate becomes a surface, fitted and with its samples claimed",
          "[aggregate]") {
  const SurfaceSamples samples = pipe();
  Aggregation aggregation(samples, {}, {});
  aggregation.offer({candidate_of(cylinder_quadric(1.02 * kPipeRadius), 0, kPipeRows)},
                    SearchLevel::kFinest);
  REQUIRE(aggregation.surfaces().size() == 1);
  const Surface& surface = aggregation.surfaces()[0];
  CHECK(surface.fit.family == Family::kCylinder);
  CHECK(radius_of(surface) == Approx(kPipeRadius).epsilon(0.01));
  CHECK(surface.rms == Approx(0.0005).epsilon(0.2));
  CHECK(surface.confidence > 0.9);
  const auto claimed = std::count(aggregation.free().begin(), aggregation.free().end(), 0);
  CHECK(claimed == static_cast<long>(surface.region.size()));
}

TEST_CASE("the two ends of a cylinder behind an occluder become one surface", "[aggregate]") {
  const SurfaceSamples samples = occluded(pipe(), 24, 36);
  Candidate lower = candidate_of(cylinder_quadric(kPipeRadius), 0, 24);
  Candidate upper = candidate_of(cylinder_quadric(0.98 * kPipeRadius), 24, 48);
  Aggregation aggregation(samples, {}, {});
  aggregation.offer({lower, upper}, SearchLevel::kFinest);
  REQUIRE(aggregation.surfaces().size() == 1);
  CHECK(aggregation.surfaces()[0].region.size() > 0.97 * samples.size());
  CHECK(radius_of(aggregation.surfaces()[0]) == Approx(kPipeRadius).epsilon(0.01));
}

TEST_CASE("two cylinders of different radius stay two", "[aggregate]") {
  const SurfaceSamples samples = surface_grid(
      kPipeColumns, kPipeRows,
      [](int i, int j) {
        const double r = j < kPipeRows / 2 ? kPipeRadius : 0.7 * kPipeRadius;
        const double a = (i - 12) * 0.1;
        const Eigen::Vector3d n(std::cos(a), std::sin(a), 0);
        return OrientedPoint{r * n + j * 0.004 * Eigen::Vector3d::UnitZ(), n};
      },
      0.004, 0.0005, 2);
  Aggregation aggregation(samples, {}, {});
  aggregation.offer({candidate_of(cylinder_quadric(kPipeRadius), 0, kPipeRows / 2),
                     candidate_of(cylinder_quadric(0.7 * kPipeRadius), kPipeRows / 2, kPipeRows)},
                    SearchLevel::kFinest);
  REQUIRE(aggregation.surfaces().size() == 2);
  std::vector<double> radii = {radius_of(aggregation.surfaces()[0]),
                               radius_of(aggregation.surfaces()[1])};
  std::sort(radii.begin(), radii.end());
  CHECK(radii[0] == Approx(0.7 * kPipeRadius).epsilon(0.02));
  CHECK(radii[1] == Approx(kPipeRadius).epsilon(0.02));
}

TEST_CASE("a dome that goes over smoothly into its post is a surface of its own", "[aggregate]") {
  constexpr double kStep = 0.004;
  static constexpr int kPost = 50, kDome = 9;  // rows
  const SurfaceSamples samples = surface_grid(
      kPipeColumns, kPost + kDome,
      [](int i, int j) {
        const double a = (i - 12) * 0.1, t = std::max(0.0, (j - kPost) * kStep / kPipeRadius);
        const Eigen::Vector3d n(std::cos(t) * std::cos(a), std::cos(t) * std::sin(a), std::sin(t));
        const double z = (j < kPost ? j : kPost) * kStep;
        return OrientedPoint{kPipeRadius * n + z * Eigen::Vector3d::UnitZ(), n};
      },
      kStep, 0.0005, 4);
  const Candidate post = candidate_of(cylinder_quadric(kPipeRadius), 0, kPost + 2);
  const double z = kPost * kStep;
  Eigen::Matrix4d sphere = Eigen::Matrix4d::Identity();
  sphere(2, 3) = sphere(3, 2) = -z;
  sphere(3, 3) = z * z - kPipeRadius * kPipeRadius;
  Candidate dome = candidate_of(Quadric(sphere), kPost + 2, kPost + kDome);
  dome.family = Family::kSphere;
  Aggregation aggregation(samples, {}, {});
  aggregation.offer({post, dome}, SearchLevel::kFinest);
  REQUIRE(aggregation.surfaces().size() == 2);
  CHECK(radius_of(aggregation.surfaces()[0]) == Approx(kPipeRadius).epsilon(0.02));
  const Surface& top = aggregation.surfaces()[1];
  const CanonicalForm form = canonical_form(top.fit.posed);
  REQUIRE(form.type == QuadricType::kSphere);
  CHECK(top.local.scale * form.dimensions[0].second == Approx(kPipeRadius).epsilon(0.05));
}

TEST_CASE("a candidate whose samples are claimed is dropped", "[aggregate]") {
  const SurfaceSamples samples = pipe();
  Aggregation aggregation(samples, {}, {});
  const Candidate whole = candidate_of(cylinder_quadric(kPipeRadius), 0, kPipeRows);
  aggregation.offer({whole, whole, candidate_of(cylinder_quadric(kPipeRadius), 10, 30)},
                    SearchLevel::kFinest);
  CHECK(aggregation.surfaces().size() == 1);
  aggregation.offer({whole}, SearchLevel::kFinest);
  CHECK(aggregation.surfaces().size() == 1);
}

TEST_CASE("a doubted surface comes after all others, if their claims leave it its samples",
          "[aggregate]") {
  const SurfaceSamples samples = pipe();
  const Candidate whole = candidate_of(cylinder_quadric(kPipeRadius), 0, kPipeRows);
  const Candidate other = candidate_of(cylinder_quadric(kPipeRadius), 0, 50);
  std::vector<std::size_t> tried;
  const auto observe = [&](const Candidate& c, SearchLevel, const Trial& trial) {
    if (trial.end == TrialEnd::kAccepted) tried.push_back(c.region.size());
  };
  Aggregation alone(samples, {}, {}, {}, observe);
  int asked = 0;
  alone.offer({whole}, SearchLevel::kFinest, [&](const Surface&) { return ++asked > 0; });
  // It is asked about once, and nothing else claims its samples.
  CHECK(asked == 1);
  CHECK(alone.surfaces().size() == 1);
  tried.clear();
  Aggregation both(samples, {}, {}, {}, observe);
  both.offer({whole, other}, SearchLevel::kFinest,
             [&](const Surface&) { return tried.size() == 1; });
  // The whole pipe explains more and is tried first, but the other is accepted first. It claims
  // most of the samples, so too few are left for the doubted one.
  CHECK(tried == std::vector{whole.region.size(), other.region.size()});
  CHECK(both.surfaces().size() == 1);
}

namespace {

/// A box edge that candidates of cylinders follow.
SurfaceSamples edge() {
  return surface_grid(
      kPipeColumns, kPipeRows,
      [](int i, int j) {
        const double s = (i - 12) * 0.004, z = j * 0.004;
        // The normals of windows across the edge turn smoothly from face to face.
        const double turn = std::clamp(0.5 + 0.2 * (i - 12), 0.0, 1.0) * std::numbers::pi / 2;
        const Eigen::Vector3d n(std::cos(turn), std::sin(turn), 0);
        return OrientedPoint{s < 0 ? Eigen::Vector3d(0, s, z) : Eigen::Vector3d(-s, 0, z), n};
      },
      0.004, 0.0, 3);
}

long curved_surfaces_on_edge(double radius, SearchLevel level, const AggregateOptions& options) {
  const SurfaceSamples samples = edge();
  Aggregation aggregation(samples, options, {});
  const Quadric Q = cylinder_quadric(radius).transformed(translation(-radius, -radius, 0));
  aggregation.offer({candidate_of(Q, 0, kPipeRows)}, level);
  const std::vector<Surface>& found = aggregation.surfaces();
  return std::count_if(found.begin(), found.end(),
                       [](const Surface& s) { return s.fit.family != Family::kPlane; });
}

}  // namespace

TEST_CASE("a box edge is no curved surface", "[aggregate]") {
  AggregateOptions credulous;
  credulous.min_confidence_early = 0.0;
  credulous.max_residual_early = 100.0;
  long found_without_confidence = 0;
  for (const double radius : {0.01, 0.03, 0.06}) {
    CAPTURE(radius);
    CHECK(curved_surfaces_on_edge(radius, SearchLevel::kCoarse, {}) == 0);
    CHECK(curved_surfaces_on_edge(radius, SearchLevel::kFinest, {}) == 0);
    found_without_confidence += curved_surfaces_on_edge(radius, SearchLevel::kCoarse, credulous);
  }
  // The candidates are such that whoever asks for no confidence accepts them.
  CHECK(found_without_confidence >= 2);
}

TEST_CASE("early on only clear cases are accepted, the others wait", "[aggregate]") {
  const SurfaceSamples samples = pipe();
  AggregateOptions options;
  options.min_confidence_early = 1.0;
  Aggregation aggregation(samples, options, {});
  aggregation.offer({candidate_of(cylinder_quadric(kPipeRadius), 0, kPipeRows)},
                    SearchLevel::kCoarse);
  CHECK(aggregation.surfaces().empty());
  aggregation.offer({}, SearchLevel::kFinest);
  CHECK(aggregation.surfaces().size() == 1);
}

TEST_CASE("too few samples or no candidates make no surface", "[aggregate][degenerate]") {
  const SurfaceSamples samples = pipe();
  Aggregation aggregation(samples, {}, {});
  aggregation.offer({}, SearchLevel::kFinest);
  aggregation.offer({candidate_of(cylinder_quadric(kPipeRadius), 0, 1)}, SearchLevel::kFinest);
  CHECK(aggregation.surfaces().empty());
}

TEST_CASE("an observer is told what becomes of each candidate", "[aggregate]") {
  const SurfaceSamples samples = pipe();
  std::vector<TrialEnd> ends;
  const auto note = [&](const Candidate&, SearchLevel level, const Trial& trial) {
    CHECK(level == SearchLevel::kFinest);
    CHECK(trial.first_look.has_value() == (trial.end != TrialEnd::kClaimed));
    if (trial.end == TrialEnd::kAccepted) {
      REQUIRE(trial.surface);
      CHECK(radius_of(*trial.surface) == Approx(kPipeRadius).epsilon(0.01));
    }
    ends.push_back(trial.end);
  };
  Aggregation aggregation(samples, {}, {}, {}, note);
  // A third of the second lies beyond the first.
  aggregation.offer({candidate_of(cylinder_quadric(kPipeRadius), 0, 50),
                     candidate_of(cylinder_quadric(kPipeRadius), 30, kPipeRows)},
                    SearchLevel::kFinest);
  REQUIRE_FALSE(ends.empty());
  CHECK(ends.front() == TrialEnd::kAccepted);
  CHECK(std::count(ends.begin(), ends.end(), TrialEnd::kAccepted) == 1);
}

TEST_CASE("planes among what is left become surfaces, if their evidence is good", "[aggregate]") {
  const SurfaceSamples samples = plane_grid(40, 40, 0.01, 0.001, 1);
  const PlaneRegion plane{{1, 0, 0, 0}, all_of(samples)};
  AggregateOptions options;
  Aggregation aggregation(samples, options, {});
  aggregation.offer_planes({plane});
  REQUIRE(aggregation.surfaces().size() == 1);
  CHECK(aggregation.surfaces()[0].fit.family == Family::kPlane);
  CHECK(std::count(aggregation.free().begin(), aggregation.free().end(), 0) == samples.size());
  options.min_plane_confidence = 1.0;
  Aggregation doubtful(samples, options, {});
  doubtful.offer_planes({plane});
  CHECK(doubtful.surfaces().empty());
}
