#include "quadrille/grasping/shape.hpp"

#include <fcl/geometry/collision_geometry.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "body/body.hpp"
#include "body/pieces.hpp"
#include "grasping/clipped_surface.hpp"
#include "grasping/random_box.hpp"
#include "space/collision.hpp"
#include "support/catch.hpp"
#include "support/rounds.hpp"

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// Points all over a shape's inside, and its corners, in frame C.
std::vector<Eigen::Vector3d> points_of(const CollisionShape& shape, std::mt19937& random) {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& v : shape.vertices_S) points.push_back(shape.X_CS * v);
  const Eigen::Vector3d low = shape.geometry->aabb_local.min_;
  const Eigen::AlignedBox3d box(low, Eigen::Vector3d(shape.geometry->aabb_local.max_));
  const ExactSolid solid(shape);
  for (int n = 0; n < 40; ++n) {
    const Eigen::Vector3d p = shape.X_CS * random_point(random, box);
    if (solid.contains(p)) points.push_back(p);
  }
  return points;
}

}  // namespace

TEST_CASE("each type's shapes hold all of the surface within its extent, and no more than they say",
          "[shape]") {
  std::mt19937 random(1);
  for (const QuadricType type : all_quadric_types()) {
    if (is_imaginary(type)) continue;
    int points = 0;
    for (int n = 0; n < 12 * rounds(); ++n) {
      ClippedSurface surface(type, random);
      const std::vector<CollisionShape> shapes = make_shapes(surface.detection());
      CAPTURE(to_string(type), n, shapes.size());
      REQUIRE_FALSE(shapes.empty());
      const std::vector<ExactSolid> solids(shapes.begin(), shapes.end());
      for (const Eigen::Vector3d& p : surface.sample(150)) {
        ++points;
        REQUIRE(std::any_of(solids.begin(), solids.end(),
                            [&](const ExactSolid& solid) { return solid.contains(p); }));
      }
      for (const CollisionShape& shape : shapes) {
        for (const Eigen::Vector3d& p : points_of(shape, random)) {
          REQUIRE(surface.distance(p) <= shape.excess + 2e-9);
        }
      }
    }
    CAPTURE(to_string(type));
    CHECK(points > 300 * rounds());
  }
}

TEST_CASE("polyhedra stand off by less than a millimetre from bodies of a hand's size", "[shape]") {
  for (const Detection& d : solid_detections()) {
    for (const CollisionShape& shape : make_shapes(d)) CHECK(shape.excess < 0.0006);
  }
}

TEST_CASE("no box that holds a point of the body is told to miss its pieces",
          "[shape][collision]") {
  std::mt19937 random(2);
  for (Detection d : solid_detections()) {
    d.X_CQ = random_pose(random);
    const Body body = make_body(d).value();
    Eigen::AlignedBox3d around = body.bounds_C();
    around.min().array() -= 0.02;
    around.max().array() += 0.02;
    const std::vector<CollisionShape> pieces = make_pieces(body);
    std::vector<Eigen::Vector3d> points;
    while (points.size() < 3000) {
      const Eigen::Vector3d p = random_point(random, body.bounds_C());
      if (body.contains(p)) points.push_back(p);
    }
    CAPTURE(to_string(d.type));
    int hits = 0, misses = 0;
    for (int n = 0; n < 500; ++n) {
      const OrientedBox box = random_box(random, around);
      const auto hit = [&](const OrientedBox& b) {
        return std::any_of(pieces.begin(), pieces.end(),
                           [&](const CollisionShape& piece) { return overlaps(b, piece); });
      };
      const bool holds = std::any_of(points.begin(), points.end(),
                                     [&](const Eigen::Vector3d& p) { return box.contains(p); });
      if (holds) REQUIRE(hit(box));
      // And a box that stays clear of the body grown by the polyhedra's excess is free.
      bool clear = true;
      for (int k = 0; k < 400 && clear; ++k) {
        const Eigen::Vector3d p_B = random_point(random, {-box.half, box.half});
        clear = !body.contains(box.p_CB + box.R_CB * p_B, 0.008);
      }
      if (clear) CHECK_FALSE(hit({box.R_CB, box.p_CB, 0.8 * box.half}));
      hits += holds;
      misses += clear;
    }
    CHECK(hits > 50);
    CHECK(misses > 20);
  }
}

TEST_CASE("the pieces of a waisted body leave its waist open", "[shape]") {
  for (const Detection& d : solid_detections()) {
    if (d.type != QuadricType::kHyperboloidOneSheet) continue;
    const Body body = make_body(d).value();
    const OrientedBox beside{
        Eigen::Matrix3d::Identity(), {0.0295, 0, 0}, Eigen::Vector3d::Constant(0.002)};
    for (const CollisionShape& piece : make_pieces(body)) CHECK_FALSE(overlaps(beside, piece));
    for (const CollisionShape& shape : make_shapes(d)) CHECK_FALSE(overlaps(beside, shape));
  }
}

TEST_CASE("round solids have native shapes in FCL's order", "[shape]") {
  const CollisionShape sphere = make_shapes(sphere_detection({{0, 0, 1}, 0.03})).at(0);
  CHECK(sphere.kind == "sphere");
  CHECK(sphere.dimensions == std::vector<double>{0.03});
  const CollisionShape cylinder =
      make_shapes(cylinder_detection(Eigen::Isometry3d::Identity(), 0.02, 0.1, 7)).at(0);
  CHECK(cylinder.kind == "cylinder");
  CHECK(cylinder.dimensions == std::vector<double>{0.02, 0.1});
  CHECK(cylinder.target == 7);
}

TEST_CASE("a plane is a slab behind the side that was seen", "[shape]") {
  const Detection table = table_detection();
  const CollisionShape slab = make_shapes(table).at(0);
  CHECK(slab.kind == "box");
  const auto at = [&](double z) {
    return OrientedBox{Eigen::Matrix3d::Identity(), table.X_CQ * Eigen::Vector3d(0.1, 0.1, z),
                       Eigen::Vector3d::Constant(0.001)};
  };
  CHECK(overlaps(at(-0.01), slab));
  CHECK_FALSE(overlaps(at(0.01), slab));
}

TEST_CASE("a detection without an extent, and an imaginary one, get no shape", "[shape]") {
  for (const QuadricType type : all_quadric_types()) {
    Detection d;
    d.type = type;
    d.dimensions = {{"a", 0.03, 0}, {"b", 0.03, 0}, {"c", 0.03, 0}};
    const bool shaped = !make_shapes(d).empty();  // its extent is empty
    const bool closed = type == QuadricType::kSphere || type == QuadricType::kEllipsoid;
    CAPTURE(to_string(type));
    CHECK(shaped == closed);
  }
}

TEST_CASE("detections with impossible sizes have no body", "[shape][hostile]") {
  for (const double size :
       {0.0, -1.0, std::nan(""), 1e9, std::numeric_limits<double>::infinity()}) {
    for (Detection d : solid_detections()) {
      for (Dimension& x : d.dimensions) x.value = size;
      d.extent_Q = {Eigen::Vector3d::Constant(-size), Eigen::Vector3d::Constant(size)};
      const auto body = make_body(d);
      CAPTURE(size, to_string(d.type));
      if (body) CHECK(body->bounds_Q().sizes().allFinite());
      CHECK_NOTHROW(make_shapes(d));
    }
  }
}
