#include "samples/sample_tree.hpp"

#include <set>

#include "support/catch.hpp"
#include "support/depth_camera.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

std::unique_ptr<CellPyramid> view() {
  Camera camera;
  camera.noise = 0.001;
  return make_depth_pyramid(
      render({rectangle(translation(0, 0, 1.0), 1e3, 1e3), sphere(translation(0, 0, 0.8), 0.1)},
             camera),
      {});
}

SampleTree tree_of(const CellPyramid& pyramid) {
  return SampleTree(
      pyramid, pyramid.samples(std::vector<char>(static_cast<std::size_t>(pyramid.size(0)), 1), 1));
}

}  // namespace

TEST_CASE("a finest sample lies under one sample of each level, that of its cell's parents",
          "[tree]") {
  const auto pyramid = view();
  const SampleTree tree = tree_of(*pyramid);
  for (int l = 0; l < kLevels; ++l) {
    std::set<int> seen;
    for (int i = 0; i < tree.level(l).size(); ++i) {
      for (const int k : tree.under(l, i)) {
        CHECK(seen.insert(k).second);
        int cell = tree.level(0).source[k];
        for (int m = 0; m < l; ++m) cell = pyramid->parents(m)[cell];
        REQUIRE(cell == tree.level(l).source[i]);
      }
    }
    CHECK(seen.size() > static_cast<std::size_t>(tree.finest().size()) * 98 / 100);
  }
  for (int i = 0; i < tree.level(0).size(); ++i) {
    REQUIRE(tree.under(0, i).size() == 1);
    REQUIRE(tree.under(0, i)[0] == i);
  }
}

TEST_CASE("the finest samples' normals are steadier than their own level's", "[tree]") {
  const auto pyramid = view();
  const SampleTree tree = tree_of(*pyramid);
  double own = 0, steady = 0;
  int n = 0;
  for (int i = 0; i < tree.finest().size(); ++i) {
    if (tree.finest().raw[i].z() < 0.97f) continue;  // on the wall, whose normal is known
    REQUIRE(tree.finest().n[i].norm() == Approx(1.0f).epsilon(1e-4));
    own += 1 + tree.level(0).n[i].z();
    steady += 1 + tree.finest().n[i].z();
    ++n;
  }
  REQUIRE(n > 50000);
  CHECK(steady < 0.8 * own);
  CHECK(tree.finest().raw == tree.level(0).raw);
}
