#include "lab/physics/true_scene.hpp"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "io/file_bytes.hpp"
#include "io/json/json_parts.hpp"
#include "lab/physics/exact_detection.hpp"
#include "lab/scene/scene_files.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille::physics {
namespace {

using Eigen::Vector3d;
using nlohmann::ordered_json;
using scene::box_of;
using scene::pose_of;
using scene::quadric_of;

// Thickness of the walls of cups, bowls and vases [m].
constexpr double kWall = 0.003;
// Cosine to the upward direction; a mouth that faces farther down than this is out of reach.
constexpr double kFacesDown = -0.5;
// Largest distance between a cap and the end that it closes [m]; a narrower end is a point and
// needs no cap.
constexpr double kAtEnd = 1e-6;

// Returns true if one of the caps of the same body lies at height z of frame S.
bool has_cap(const std::vector<const ordered_json*>& caps, const Eigen::Isometry3d& X_CS,
             double z) {
  for (const ordered_json* cap : caps) {
    const Eigen::Isometry3d X_SP = X_CS.inverse() * pose_of(cap->at("pose"));
    const Vector3d middle_S = X_SP * Vector3d(box_of(cap->at("box")).center());
    if (std::abs(middle_S.z() - z) < kAtEnd) return true;
  }
  return false;
}

bool closed_by_type(const ordered_json& object) {
  const std::string type = object.at("type");
  if (type == "cylinder" || type == "elliptic_cylinder") return true;
  const ordered_json& dims = object.at("dims");
  return type == "cone" && dims.contains("cup") && !dims.at("cup").get<bool>();
}

TrueBody body_of(const ordered_json& object, const std::vector<const ordered_json*>& caps,
                 const Vector3d& up_C) {
  TrueBody body;
  body.id = object.at("id");
  body.type = object.at("type");
  body.is_seen = object.value("evaluate", true);
  body.X_CS = pose_of(object.at("pose"));
  body.box_S = box_of(object.at("box"));
  Vector10d q = quadric_of(object.at("q")).transformed(body.X_CS.inverse()).coefficients();
  if (q[0] < 0.0) q = -q;
  body.a = 1.0 / std::sqrt(q[0]);
  body.b = 1.0 / std::sqrt(q[1]);
  body.p = {-q[9], -2.0 * q[8], -q[2]};
  const auto open = [&](double z) {
    return body.a * body.scale(z) > 1e-3 && !closed_by_type(object) && !has_cap(caps, body.X_CS, z);
  };
  body.open_low = open(body.z_min());
  body.open_high = open(body.z_max());
  const double upward = body.X_CS.linear().col(2).dot(up_C);
  if ((body.open_high && upward > kFacesDown) || (body.open_low && -upward > kFacesDown)) {
    body.wall = kWall;
  }
  return body;
}

// Adds the box that all visible faces span, unless they are too few.
void add_box(const std::vector<const ordered_json*>& faces, std::vector<TrueBody>* bodies) {
  TrueBody body;
  body.type = "box";
  body.is_box = true;
  body.id = faces.front()->at("id");
  Eigen::Isometry3d X_CF = pose_of(faces.front()->at("pose"));
  for (const ordered_json* face : faces) {
    const Eigen::Isometry3d X_FP = X_CF.inverse() * pose_of(face->at("pose"));
    const Eigen::AlignedBox3d box = box_of(face->at("box"));
    body.is_seen |= face->value("evaluate", true);
    for (int i = 0; i < 8; ++i) {
      body.box_S.extend(X_FP * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
    }
  }
  if (body.box_S.sizes().minCoeff() < 1e-3) return;
  body.X_CS = X_CF;
  bodies->push_back(body);
}

Eigen::Isometry3d table_of(const ordered_json& truth) {
  for (const ordered_json& object : truth.at("objects")) {
    if (object.at("type") == "table") return pose_of(object.at("pose"));
  }
  throw std::runtime_error("no table among the objects: nothing says which way is up");
}

/// The surfaces of one body.
struct Parts {
  const ordered_json* curved = nullptr;
  std::vector<const ordered_json*> caps, faces;
};

}  // namespace

TrueScene true_scene(const ordered_json& truth) {
  TrueScene scene;
  scene.X_CT = table_of(truth);
  std::map<int, Parts> bodies;
  for (const ordered_json& object : truth.at("objects")) {
    Parts& parts = bodies[object.at("body").get<int>()];
    const std::string type = object.at("type");
    if (object.at("kind") == "quadric") parts.curved = &object;
    if (type == "cap") parts.caps.push_back(&object);
    if (type == "face") parts.faces.push_back(&object);
    if (type == "table") {
      scene.detections.push_back(
          exact_plane(object.at("id"), pose_of(object.at("pose")), box_of(object.at("box"))));
    }
    if (object.at("kind") == "clutter") {
      scene.clutter.emplace_back(pose_of(object.at("pose")).translation(),
                                 0.5 * box_of(object.at("box")).sizes().maxCoeff());
    }
  }
  const Vector3d up_C = scene.X_CT.linear().col(2);
  for (const auto& [number, parts] : bodies) {
    if (parts.curved != nullptr) {
      scene.bodies.push_back(body_of(*parts.curved, parts.caps, up_C));
      const TrueBody& body = scene.bodies.back();
      scene.detections.push_back(
          exact_quadric(body.id, quadric_of(parts.curved->at("q")), body.X_CS, body.box_S));
    } else if (!parts.faces.empty()) {
      add_box(parts.faces, &scene.bodies);
    }
  }
  return scene;
}

TrueScene read_true_scene(const std::string& cloud_path) {
  const std::optional<std::string> path = scene::find_truth(cloud_path);
  if (!path) {
    throw io::FileError(scene::truth_path(cloud_path), "",
                        "no such file; `quadrille scene` makes clouds with their truth");
  }
  const std::vector<std::byte> bytes = io::read_file(*path);
  const char* text = reinterpret_cast<const char*>(bytes.data());
  try {
    return true_scene(ordered_json::parse(text, text + bytes.size()));
  } catch (const io::FileError&) {
    throw;
  } catch (const std::exception& error) {
    throw io::json_error(*path, "no truth of a scene", error);
  }
}

const TrueBody* body_in(const TrueScene& scene, const Eigen::Isometry3d& X_CG,
                        const Vector3d& half) {
  constexpr int kAcross = 5, kAlong = 21, kDeep = 9;
  const TrueBody* found = nullptr;
  int most = 0;
  for (const TrueBody& body : scene.bodies) {
    int count = 0;
    for (int n = 0; n < kAcross * kAlong * kDeep; ++n) {
      const Vector3d share(n % kAcross / (kAcross - 1.0), n / kAcross % kAlong / (kAlong - 1.0),
                           n / (kAcross * kAlong) / (kDeep - 1.0));
      const Vector3d p_G = (2.0 * share - Vector3d::Ones()).cwiseProduct(half);
      count += body.contains(X_CG * p_G);
    }
    if (count > most) {
      most = count;
      found = &body;
    }
  }
  return found;
}

bool near_clutter(const TrueScene& scene, const Vector3d& p_C, double reach) {
  for (const auto& [centre, radius] : scene.clutter) {
    if ((p_C - centre).norm() < radius + reach) return true;
  }
  return false;
}

}  // namespace quadrille::physics
