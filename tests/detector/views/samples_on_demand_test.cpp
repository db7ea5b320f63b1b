#include "views/samples_on_demand.hpp"

#include <memory>

#include "detector/views/taken_views.hpp"
#include "samples/sample_tree.hpp"
#include "support/catch.hpp"
#include "views/joined_samples.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("samples that are made late are those that were made and moved at once", "[views]") {
  const Taken view = taken_from_eye(world_table(), eye_at(0.0));
  const std::shared_ptr<const CellPyramid> cells = make_pyramid(view.cloud, SamplingOptions());
  REQUIRE(cells);
  const Mask all(static_cast<std::size_t>(cells->size(0)), 1);
  const Eigen::Isometry3d& first = view.X_WK;
  const Eigen::Isometry3d second(Eigen::Translation3d(0.01, -0.02, 0.003));
  SurfaceSamples expected = SampleTree(*cells, cells->samples(all, 1)).take_finest();
  expected = moved(std::move(expected), first);
  REQUIRE(expected.size() > 1000);

  SamplesOnDemand samples(cells, 2);
  samples.move(first);
  CHECK(samples.get().raw == expected.raw);
  samples.move(second);
  expected = moved(std::move(expected), second);
  CHECK(samples.get().raw == expected.raw);
  CHECK(samples.get().n == expected.n);
  CHECK(samples.get().neighbours == expected.neighbours);

  SamplesOnDemand late(cells, 1);
  late.move(first);
  late.move(second);
  CHECK(late.get().raw == expected.raw);
}
