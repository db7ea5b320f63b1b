#include "surfaces/evidence/intruders.hpp"

#include "detector/pipe.hpp"
#include "support/catch.hpp"
#include "support/surface_grid.hpp"

using namespace quadrille;
using namespace quadrille::test;

TEST_CASE("samples off the quadric within the region's box are told by their side",
          "[evidence][intruders]") {
  // A pipe that faces x, with a row of samples on its axis and another before its face.
  SurfaceSamples samples = cylinder_grid(25, 40, kPipeRadius, 0.004, 0.0, 1);
  const std::vector<int> pipe = all_of(samples);
  const auto add = [&](double x, double z) {
    const Eigen::Vector3f p(static_cast<float>(x), 0.0f, static_cast<float>(z));
    samples.p.push_back(p), samples.raw.push_back(p);
    samples.n.push_back(Eigen::Vector3f::UnitX());
    samples.sigma.push_back(samples.sigma[0]), samples.cell.push_back(samples.cell[0]);
    samples.count.push_back(1), samples.source.push_back(samples.size() - 1);
    samples.first.push_back(samples.first.back());
  };
  // cos 1.2 of the radius is where the arc of the pipe ends: behind the face, within the box.
  for (int k = 0; k < 10; ++k) add(0.7 * kPipeRadius, 0.004 * k);
  // On the quadric, and far away.
  add(kPipeRadius, 0.0);
  add(-1.0, 0.0);
  const Quadric Q(diagonal(1, 1, 0, -kPipeRadius * kPipeRadius));
  const SampleBlocks blocks(samples);
  Evidence e;
  add_intruders(samples, blocks, pipe, Q, &e);
  CHECK(e.behind == Approx(10.0 / static_cast<double>(pipe.size())));
  CHECK(e.in_front == 0.0);
  // Seen from inside, the same samples stand in front.
  for (auto& n : samples.n) n = -n;
  add_intruders(samples, blocks, pipe, Q, &e);
  CHECK(e.in_front == Approx(10.0 / static_cast<double>(pipe.size())));
  CHECK(e.behind == 0.0);
}
