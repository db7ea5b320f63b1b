#include "lab/physics/true_scene.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <random>

#include "body/body.hpp"
#include "grasping/scenes.hpp"
#include "lab/scene/scene_files.hpp"
#include "lcmtypes/contains.hpp"
#include "support/catch.hpp"
#include "support/temp_folder.hpp"

using namespace quadrille;
using Eigen::Vector3d;
using nlohmann::ordered_json;
using physics::TrueBody;
using physics::TrueScene;

namespace {

ordered_json truth_of(std::uint64_t seed) {
  return scene::truth_json(scene::make_scene({scene::Family::kTabletop, seed, 160, 120}));
}

const ordered_json& object_of(const ordered_json& truth, int id) {
  for (const ordered_json& object : truth.at("objects")) {
    if (object.at("id") == id) return object;
  }
  throw std::runtime_error("no such object");
}

}  // namespace

TEST_CASE("true bodies lie on the quadrics of the truth", "[physics]") {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    const ordered_json truth = truth_of(seed);
    const TrueScene scene = physics::true_scene(truth);
    REQUIRE_FALSE(scene.bodies.empty());
    for (const TrueBody& body : scene.bodies) {
      if (body.is_box) continue;
      CAPTURE(seed, body.id, body.type);
      const Quadric Q_C = scene::quadric_of(object_of(truth, body.id).at("q"));
      for (const double share : {0.2, 0.5, 0.9}) {
        const double z = body.z_min() + share * (body.z_max() - body.z_min());
        const Vector3d p_C = body.X_CS * body.point_S(1.0, z);
        const Vector3d gradient = Q_C.gradient(p_C);
        CHECK(std::abs(Q_C.value(p_C)) / gradient.norm() < 1e-9);
        const Vector3d n_C = body.X_CS.linear() * body.normal_S(1.0, z);
        CHECK(std::abs(gradient.normalized().dot(n_C)) == Approx(1.0).margin(1e-9));
      }
    }
  }
}

TEST_CASE("an exact detection bounds the same solid as its true body", "[physics]") {
  std::mt19937 random(11);
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    const TrueScene scene = physics::true_scene(truth_of(seed));
    for (const Detection& detection : scene.detections) {
      if (detection.type == QuadricType::kPlane) continue;
      CAPTURE(seed, detection.id, to_string(detection.type));
      const std::optional<Body> planned = make_body(detection);
      REQUIRE(planned);
      const auto truth = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                      [&](const TrueBody& b) { return b.id == detection.id; });
      REQUIRE(truth != scene.bodies.end());
      int inside = 0;
      for (int i = 0; i < 500; ++i) {
        const Vector3d p_C = truth->X_CS * test::random_point(random, truth->box_S);
        const bool is_in = truth->contains(p_C);
        inside += is_in;
        CHECK(planned->contains(p_C, is_in ? 1e-6 : -1e-6) == is_in);
      }
      CHECK(inside > 100);
      // Outward, as a sensor sees it.
      const double z = 0.5 * (truth->z_min() + truth->z_max());
      const Vector3d gradient = detection.Q_C.gradient(truth->X_CS * truth->point_S(0.5, z));
      CHECK(gradient.dot(truth->X_CS.linear() * truth->normal_S(0.5, z)) > 0.0);
    }
  }
}

TEST_CASE("the table's detection faces the sensor and says which way is up", "[physics]") {
  const TrueScene scene = physics::true_scene(truth_of(1));
  const auto table = std::find_if(scene.detections.begin(), scene.detections.end(),
                                  [](const Detection& d) { return d.type == QuadricType::kPlane; });
  REQUIRE(table != scene.detections.end());
  const Vector3d n_C = table->X_CQ.linear().col(2);
  CHECK(n_C.dot(table->X_CQ.translation()) < 0.0);
  CHECK(n_C.dot(scene.X_CT.linear().col(2)) == Approx(1.0));
  CHECK(table->Q_C.gradient(table->X_CQ.translation()).dot(n_C) > 0.0);
  CHECK(std::abs(table->Q_C.value(table->X_CQ * Vector3d(0.1, 0.2, 0.0))) < 1e-9);
  for (const TrueBody& body : scene.bodies) {
    CHECK((scene.X_CT.inverse() * body.X_CS * Vector3d(body.box_S.center())).z() > 0.0);
  }
}

TEST_CASE("cups, bowls and vases are hollow, what has both caps is not", "[physics]") {
  int hollow = 0, solid = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const ordered_json truth = truth_of(seed);
    for (const TrueBody& body : physics::true_scene(truth).bodies) {
      if (body.is_box) continue;
      int caps = 0;
      for (const ordered_json& object : truth.at("objects")) {
        caps +=
            object.at("type") == "cap" && object.at("body") == object_of(truth, body.id).at("body");
      }
      CAPTURE(seed, body.id, body.type, caps);
      if (body.type == "sphere" || body.type == "ellipsoid" || caps == 2) {
        CHECK(body.wall == 0.0);
        ++solid;
      }
      if (body.type == "hyperboloid_one_sheet") {
        CHECK(body.wall > 0.0);
        CHECK_FALSE(body.open_low);
        ++hollow;
      }
    }
  }
  CHECK(hollow > 0);
  CHECK(solid > 0);
}

TEST_CASE("boxes are put together from their faces", "[physics]") {
  int boxes = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    for (const TrueBody& body : physics::true_scene(truth_of(seed)).bodies) {
      if (!body.is_box) continue;
      ++boxes;
      CHECK(body.box_S.sizes().minCoeff() > 0.01);
      CHECK(body.contains(body.X_CS * Vector3d(body.box_S.center())));
      CHECK_FALSE(body.contains(body.X_CS * Vector3d(body.box_S.max() * 1.01)));
    }
  }
  CHECK(boxes > 0);
}

TEST_CASE("the body between the pads is the one with the most of them", "[physics]") {
  TrueScene scene;
  for (const double x : {0.0, 0.1}) {
    TrueBody ball;
    ball.id = x > 0.0 ? 2 : 1;
    ball.a = ball.b = 1.0;
    ball.p = {0.0004, 0.0, -1.0};
    ball.box_S = {Vector3d::Constant(-0.02), Vector3d::Constant(0.02)};
    ball.X_CS.translation().x() = x;
    scene.bodies.push_back(ball);
  }
  const auto found = [&](double x) {
    Eigen::Isometry3d X_CG = Eigen::Isometry3d::Identity();
    X_CG.translation().x() = x;
    const TrueBody* body = physics::body_in(scene, X_CG, {0.01, 0.03, 0.01});
    return body == nullptr ? 0 : body->id;
  };
  CHECK(found(0.0) == 1);
  CHECK(found(0.09) == 2);
  CHECK(found(0.05) == 0);
}

TEST_CASE("a file that is no truth is refused in one line that names it", "[physics][hostile]") {
  const test::TempFolder folder;
  const auto read = [&](const std::string& text) {
    folder.write("s.truth.json", text);
    physics::read_true_scene(folder.path("s.ply"));
  };
  CHECK_THROWS_WITH(read("no json"), test::contains("s.truth.json: byte 2: no truth"));
  CHECK_THROWS_WITH(read("{}"), test::contains("s.truth.json: no truth of a scene"));
  CHECK_THROWS_WITH(read(R"({"objects": []})"),
                    test::contains("s.truth.json") && test::contains("no table"));
  CHECK_NOTHROW(read(truth_of(1).dump()));
  CHECK_THROWS_AS(physics::read_true_scene(folder.path("none.ply")), std::runtime_error);
}
