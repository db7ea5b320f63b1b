#include "lab/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lab/scene/scene_files.hpp"
#include "quadrille/detector/quadric.hpp"
#include "support/catch.hpp"
#include "tools/support_files.hpp"

using namespace quadrille;
using namespace quadrille::scene;

namespace {

const std::vector<scene::Family> kFamilies = {scene::Family::kEasy, scene::Family::kMedium,
                                              scene::Family::kHard, scene::Family::kTabletop};

SceneOptions small(scene::Family family, std::uint64_t seed) { return {family, seed, 320, 240}; }

Quadric true_quadric(const nlohmann::ordered_json& object) {
  Vector10d q;
  for (int i = 0; i < 10; ++i) q[i] = object["q"][static_cast<std::size_t>(i)];
  return Quadric(q);
}

double dim(const nlohmann::ordered_json& object, const char* name) { return object["dims"][name]; }

/// A point of the surface in its own frame, from type and dims alone.
Eigen::Vector3d point_from_dims(const nlohmann::ordered_json& o, double u, double v) {
  const std::string type = o["type"];
  const double c = std::cos(u), s = std::sin(u);
  if (type == "sphere")
    return dim(o, "radius") * Eigen::Vector3d(c * v, s * v, std::sqrt(1 - v * v));
  if (type == "ellipsoid") {
    return {dim(o, "a") * c * v, dim(o, "b") * s * v, dim(o, "c") * std::sqrt(1 - v * v)};
  }
  if (type == "cylinder") return {dim(o, "radius") * c, dim(o, "radius") * s, v};
  if (type == "elliptic_cylinder") return {dim(o, "a") * c, dim(o, "b") * s, v};
  if (type == "cone") return {dim(o, "slope") * v * c, dim(o, "slope") * v * s, v};
  if (type == "elliptic_paraboloid") {
    return {2 * std::sqrt(dim(o, "focal_a") * v) * c, 2 * std::sqrt(dim(o, "focal_b") * v) * s, v};
  }
  REQUIRE(type == "hyperboloid_one_sheet");
  const double w = std::sqrt(1 + v * v / (dim(o, "c") * dim(o, "c")));
  return {dim(o, "a") * w * c, dim(o, "b") * w * s, v};
}

Eigen::Isometry3d true_pose(const nlohmann::ordered_json& o) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) X.linear()(i, j) = o["pose"]["R"].at(i).at(j);
    X.translation()[i] = o["pose"]["t"].at(i);
  }
  return X;
}

}  // namespace

TEST_CASE("a ray meets each quadric exactly", "[scene]") {
  for (const scene::Family family : kFamilies) {
    const Scene scene = make_scene(small(family, 7));
    const nlohmann::ordered_json truth = truth_json(scene);
    std::size_t checked = 0;
    for (std::size_t i = 0; i < scene.ideal.depth.size(); ++i) {
      const int id = scene.ideal.surface[i];
      if (id < 0) continue;
      const int column = static_cast<int>(i % 320), row = static_cast<int>(i / 320);
      const Eigen::Vector3d p = scene.ideal.depth[i] * scene.camera.ray(column, row);
      const Quadric Q = true_quadric(truth["objects"].at(static_cast<std::size_t>(id)));
      if (std::abs(Q.distance(p)) > 1e-9) FAIL("surface " << id << " at " << p.transpose());
      const double angle =
          std::abs(Q.gradient(p).normalized().dot(scene.ideal.normal[i].cast<double>()));
      if (angle < 1 - 1e-5) FAIL("normal of surface " << id);
      ++checked;
    }
    CHECK(checked > 20000);
  }
}

TEST_CASE("measured points lie on their true quadric within the noise", "[scene]") {
  for (const scene::Family family : kFamilies) {
    const Scene scene = make_scene(small(family, 3));
    const nlohmann::ordered_json truth = truth_json(scene);
    std::vector<double> ratios;
    for (std::size_t i = 0; i < scene.view.points.size(); ++i) {
      const int id = scene.view.labels[i];
      if (id < 0) continue;
      const Eigen::Vector3d p = scene.view.points[i].cast<double>();
      const auto& object = truth["objects"].at(static_cast<std::size_t>(id));
      const double sigma = depth_noise(traits_of(family).noise, p.z()) + 0.0006;
      // Noise moves a point along its ray, by no more than that off the surface.
      ratios.push_back(std::abs(true_quadric(object).distance(p)) / (sigma * p.norm() / p.z()));
    }
    std::sort(ratios.begin(), ratios.end());
    REQUIRE(ratios.size() > 20000);
    CHECK(ratios[ratios.size() / 2] < 1.0);
    CHECK(ratios[ratios.size() / 2] > 0.1);
    CHECK(ratios[ratios.size() * 99 / 100] < 3.5);
  }
}

TEST_CASE("the truth's q agrees with its type, dims and pose", "[scene]") {
  int checked = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const auto truth = truth_json(make_scene(small(scene::Family::kHard, seed)));
    for (const auto& object : truth["objects"]) {
      if (object["kind"] != "quadric") continue;
      const std::string type = object["type"];
      INFO(type);
      CHECK(quadric_type_from_string(type).has_value());
      const Quadric Q = true_quadric(object);
      CHECK(Q.coefficients().norm() == Approx(1.0));
      for (const double u : {0.3, 2.0, 4.5}) {
        for (const double v : {0.02, 0.05, 0.09}) {
          CHECK(std::abs(Q.distance(true_pose(object) * point_from_dims(object, u, v))) < 1e-9);
        }
      }
      ++checked;
    }
  }
  CHECK(checked > 25);
}

TEST_CASE("a seed fixes a scene to the last bit, and seeds differ", "[scene][determinism]") {
  const Scene a = make_scene(small(scene::Family::kMedium, 5)),
              b = make_scene(small(scene::Family::kMedium, 5));
  CHECK(a.view.points == b.view.points);
  CHECK(a.view.labels == b.view.labels);
  CHECK(truth_json(a) == truth_json(b));
  CHECK(make_scene(small(scene::Family::kMedium, 6)).view.points != a.view.points);
}

TEST_CASE("pictures of one scene have noise of their own, and are organised clouds", "[scene]") {
  const SceneOptions options = small(scene::Family::kTabletop, 5);
  const Layout layout = make_layout(options);
  Random random = sensor_random(options);
  const Scene first = take_picture(options, layout, &random),
              second = take_picture(options, layout, &random);
  CHECK(first.view.points == make_scene(options).view.points);
  CHECK(first.ideal.depth == second.ideal.depth);
  CHECK(first.view.points != second.view.points);
  const PointCloud cloud = organised_cloud(first.camera, first.view);
  CHECK(cloud.width == 320);
  CHECK(cloud.height == 240);
  REQUIRE(cloud.points.size() == 320 * 240);
  std::size_t measured = 0;
  for (int row = 0; row < 240; ++row) {
    for (int column = 0; column < 320; ++column) {
      const Eigen::Vector3f p = cloud.points[static_cast<std::size_t>(320 * row + column)];
      if (!p.allFinite()) continue;
      ++measured;
      if ((p.cast<double>() / p.z() - first.camera.ray(column, row)).norm() > 1e-6) FAIL(column);
    }
  }
  CHECK(measured == first.view.points.size());
}

TEST_CASE("random numbers follow seed and stream, and normal ones have variance one",
          "[scene][determinism]") {
  Random random(1, 2), same(1, 2), other(1, 3);
  const std::uint64_t first = random.next();
  CHECK(first == same.next());
  CHECK(first != other.next());
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
  }
  CHECK(std::abs(sum / 20000) < 0.03);
  CHECK(squares / 20000 == Approx(1.0).margin(0.04));
}

TEST_CASE("families grow in bodies and in occlusion", "[scene]") {
  std::vector<double> occlusions;
  std::vector<int> counts;
  for (const scene::Family family :
       {scene::Family::kEasy, scene::Family::kMedium, scene::Family::kHard}) {
    double occlusion = 0.0;
    int count = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const auto truth = truth_json(make_scene(small(family, seed)));
      for (const auto& object : truth["objects"]) {
        if (object["kind"] != "quadric") continue;
        occlusion += object["occlusion"].get<double>();
        ++count;
      }
    }
    occlusions.push_back(occlusion / count);
    counts.push_back(count);
  }
  CHECK(counts[0] < counts[1]);
  CHECK(counts[1] < counts[2]);
  CHECK(occlusions[0] < occlusions[1]);
  CHECK(occlusions[1] < occlusions[2]);
}

TEST_CASE("tabletop objects are small enough for a hand", "[scene]") {
  int checked = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const auto truth = truth_json(make_scene(small(scene::Family::kTabletop, seed)));
    for (const auto& object : truth["objects"]) {
      if (object["kind"] != "quadric") continue;
      ++checked;
      CHECK(object["size"].get<double>() <= 0.135);
      CHECK(object["size"].get<double>() >= 0.025);
    }
  }
  CHECK(checked >= 30);
}

TEST_CASE("bodies stand on the table without running into each other", "[scene]") {
  const Scene scene = make_scene(small(scene::Family::kHard, 2));
  const auto& bodies = scene.layout.bodies;
  for (std::size_t i = 2; i < bodies.size(); ++i) {
    for (std::size_t j = 2; j < i; ++j) {
      const double distance = (bodies[i].X_WB.translation() - bodies[j].X_WB.translation()).norm();
      CHECK(distance >= bodies[i].reach + bodies[j].reach);
    }
  }
}

TEST_CASE("labels and normals go beside the cloud, one for each point", "[scene]") {
  const test::TempFolder folder;
  const Scene scene = make_scene(small(scene::Family::kEasy, 1));
  write_scene(folder.path("s.ply"), scene, true);
  const std::size_t count = scene.view.points.size();
  CHECK(test::content_of(folder.path("s.labels")).size() == 4 * count);
  CHECK(test::content_of(folder.path("s.normals")).size() == 12 * count);
  CHECK(nlohmann::json::parse(test::content_of(folder.path("s.truth.json")))["points"] == count);
}
