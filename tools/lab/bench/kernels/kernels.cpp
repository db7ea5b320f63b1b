// Benchmarks of the detector's kernels, each on its own, on the surfaces of a generated scene as a
// depth camera of 640 x 480 pixels sees it.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fit/closed_form/initial_general.hpp"
#include "fit/closed_form/initial_sphere.hpp"
#include "fit/distance_sums.hpp"
#include "fit/geometric_fit.hpp"
#include "lab/scoring/frame.hpp"
#include "samples/depth/coarser_cells.hpp"
#include "samples/depth/depth_cells.hpp"
#include "samples/depth/depth_samples.hpp"
#include "samples/region.hpp"
#include "search/basis.hpp"
#include "search/grow.hpp"
#include "search/vote.hpp"
#include "variants/draw_variant.hpp"

namespace quadrille {
namespace {

constexpr int kPixels = 2, kReach = 2;

const scoring::Frame& scene_frame() {
  static const scoring::Frame frame =
      scoring::frame_of(scene::make_scene({scene::Family::kMedium, 1000}));
  return frame;
}

const PinholeView& view() {
  static const PinholeView made = find_view(scene_frame().cloud).value();
  return made;
}

const DepthCells& cells() {
  static const DepthCells made = make_depth_cells(
      scene_frame().cloud, view(), find_image(scene_frame().cloud, view()).value(), kPixels);
  return made;
}

SurfaceSamples make_samples() {
  return make_depth_samples(cells(), {}, NoiseModel(), view().X_VC.inverse(), kReach);
}

const SurfaceSamples& samples() {
  static const SurfaceSamples made = make_samples();
  return made;
}

/// The curved surface with the most samples, and its samples.
struct Patch {
  Quadric Q_C;
  std::vector<int> region;
};

Patch find_patch() {
  Patch best;
  for (const scoring::TrueSurface& surface : scene_frame().surfaces) {
    if (!surface.curved) continue;
    const Eigen::Isometry3d X_SC = surface.X_CS.inverse();
    Patch patch{surface.Q_C, {}};
    for (int i = 0; i < samples().size(); ++i) {
      const Eigen::Vector3d x = samples().raw[i].cast<double>();
      const bool near = surface.box_S.exteriorDistance(X_SC * x) < 0.002;
      if (near && std::abs(surface.Q_C.distance(x)) < 0.003) patch.region.push_back(i);
    }
    if (patch.region.size() > best.region.size()) best = patch;
  }
  return best;
}

const Patch& patch() {
  static const Patch found = find_patch();
  return found;
}

/// Returns at most this many points of the patch, normalised for fits.
OrientedPointsf patch_points(int most) {
  return fit_points(samples(), patch().region, normalisation_of(samples(), patch().region), most);
}

/// Returns bases of three points each, drawn evenly from the patch.
std::vector<std::array<OrientedPoint, 3>> patch_bases() {
  const OrientedPointsf points = patch_points(300);
  std::vector<std::array<OrientedPoint, 3>> bases;
  const Eigen::Index third = points.size() / 3;
  for (Eigen::Index i = 0; i < third; ++i) {
    std::array<OrientedPoint, 3> basis;
    for (Eigen::Index k = 0; k < 3; ++k) {
      basis[static_cast<std::size_t>(k)] = points.at(i + k * third);
    }
    bases.push_back(basis);
  }
  return bases;
}

Eigen::Matrix4d truth_local() {
  return normalisation_of(samples(), patch().region).to_local(patch().Q_C);
}

void inconsistency_of_basis(benchmark::State& state) {
  const auto bases = patch_bases();
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(inconsistency(bases[next]));
    next = next + 1 < bases.size() ? next + 1 : 0;
  }
}
BENCHMARK(inconsistency_of_basis);

void pencil_of_basis(benchmark::State& state) {
  const auto bases = patch_bases();
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(make_pencil(bases[next]));
    next = next + 1 < bases.size() ? next + 1 : 0;
  }
}
BENCHMARK(pencil_of_basis);

void vote_of_points(benchmark::State& state) {
  const OrientedPointsf voters = patch_points(static_cast<int>(state.range(0)));
  std::vector<Pencil> pencils;
  for (const auto& basis : patch_bases()) {
    if (const auto pencil = make_pencil(basis)) pencils.push_back(*pencil);
  }
  if (pencils.empty()) return state.SkipWithError("no basis of the patch has a pencil");
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(vote(pencils[next], voters, VoteOptions()));
    next = next + 1 < pencils.size() ? next + 1 : 0;
  }
  state.SetItemsProcessed(state.iterations() * voters.size());
}
BENCHMARK(vote_of_points)->Arg(100)->Arg(1000);

void support_of_hypothesis(benchmark::State& state) {
  const OrientedPointsf voters = patch_points(static_cast<int>(state.range(0)));
  const Eigen::Matrix4d Q = truth_local();
  for (auto _ : state) benchmark::DoNotOptimize(count_support(voters, Q, 0.05f, 0.9f));
  state.SetItemsProcessed(state.iterations() * voters.size());
}
BENCHMARK(support_of_hypothesis)->Arg(100)->Arg(1000);

void hypotheses_of_neighbourhood(benchmark::State& state) {
  Voters voters{patch_points(100), std::vector<int>(100), 0.05f, {}};
  const Variant variant{.basis = static_cast<VariantBasis>(state.range(0))};
  RandomStream random(1, 0);
  for (auto _ : state) benchmark::DoNotOptimize(draw_variant(variant, voters, random));
}
BENCHMARK(hypotheses_of_neighbourhood)
    ->ArgName("basis")
    ->Arg(static_cast<int>(VariantBasis::kThreePoints))
    ->Arg(static_cast<int>(VariantBasis::kFourPoints))
    ->Arg(static_cast<int>(VariantBasis::kNinePoints))
    ->Arg(static_cast<int>(VariantBasis::kTwoPoints));

void grow_from_truth(benchmark::State& state) {
  const std::vector<char> free(samples().p.size(), 1);
  const std::vector<int> start = spread_evenly(patch().region, 30);
  Marks seen(free.size());
  std::size_t grown_samples = 0;
  for (auto _ : state) {
    const auto grown =
        grow(samples(), patch().Q_C, start, free, InlierTest(), GrowOptions(), &seen);
    if (!grown) return state.SkipWithError("the patch does not grow");
    grown_samples = grown->region.size();
  }
  state.counters["samples"] = static_cast<double>(grown_samples);
}
BENCHMARK(grow_from_truth)->Unit(benchmark::kMicrosecond);

void normal_equations_of_points(benchmark::State& state) {
  const OrientedPointsf points = patch_points(static_cast<int>(state.range(0)));
  const Eigen::Matrix4d Q = truth_local();
  for (auto _ : state)
    benchmark::DoNotOptimize(DistanceSums(points).evaluate(Q).normal_equations());
  state.SetItemsProcessed(state.iterations() * points.size());
}
BENCHMARK(normal_equations_of_points)->Arg(128)->Arg(1000);

void sum_of_squares_of_points(benchmark::State& state) {
  const OrientedPointsf points = patch_points(static_cast<int>(state.range(0)));
  const Eigen::Matrix4d Q = truth_local();
  for (auto _ : state) benchmark::DoNotOptimize(DistanceSums(points).evaluate(Q).squares());
  state.SetItemsProcessed(state.iterations() * points.size());
}
BENCHMARK(sum_of_squares_of_points)->Arg(128)->Arg(1000);

void geometric_refit(benchmark::State& state) {
  const OrientedPointsf points = patch_points(128);
  const bool sphere = state.range(0) == 0;
  const PointMoments moments(points);
  const auto start = sphere ? initial_sphere(moments) : initial_general(moments);
  if (!start) return state.SkipWithError("the patch gives no start");
  const Family family = sphere ? Family::kSphere : Family::kGeneral;
  constexpr int kIterations = 10;
  for (auto _ : state) benchmark::DoNotOptimize(refine(points, family, *start, kIterations));
}
BENCHMARK(geometric_refit)->ArgName("general")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

void normals_of_cells(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(make_samples());
  state.SetItemsProcessed(state.iterations() * cells().size());
}
BENCHMARK(normals_of_cells)->Unit(benchmark::kMillisecond);

void cells_of_points(benchmark::State& state) {
  const PinholeImage image = find_image(scene_frame().cloud, view()).value();
  for (auto _ : state)
    benchmark::DoNotOptimize(make_depth_cells(scene_frame().cloud, view(), image, kPixels));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(view().seen));
}
BENCHMARK(cells_of_points)->Unit(benchmark::kMillisecond);

void coarser_cells(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(coarser(cells(), {}));
  state.SetItemsProcessed(state.iterations() * cells().size());
}
BENCHMARK(coarser_cells)->Unit(benchmark::kMillisecond);

void view_of_points(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(find_view(scene_frame().cloud));
  state.SetItemsProcessed(state.iterations() *
                          static_cast<std::int64_t>(scene_frame().cloud.points.size()));
}
BENCHMARK(view_of_points)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace quadrille

BENCHMARK_MAIN();
