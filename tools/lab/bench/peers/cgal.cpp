// CGAL's Efficient RANSAC (Schnabel, Wahl, Klein 2007): planes, spheres, cylinders and cones.
// CGAL's shape detection is under the GPL, so this is a separate program that is never installed.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/property_map.h>

#include <map>
#include <utility>

#include "lab/bench/peers/peer.hpp"

namespace quadrille::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Points = std::vector<Point>;
using Traits =
    CGAL::Shape_detection::Efficient_RANSAC_traits<Kernel, Points,
                                                   CGAL::First_of_pair_property_map<Point>,
                                                   CGAL::Second_of_pair_property_map<Point>>;
using Ransac = CGAL::Shape_detection::Efficient_RANSAC<Traits>;
using Plane = CGAL::Shape_detection::Plane<Traits>;
using Sphere = CGAL::Shape_detection::Sphere<Traits>;
using Cylinder = CGAL::Shape_detection::Cylinder<Traits>;
using Cone = CGAL::Shape_detection::Cone<Traits>;

/// The settings are tuned for each family, which is generous, since a user could not do that.
struct Settings {
  OrientationOptions orientation;
  double epsilon, cluster_epsilon, normal_threshold, probability, max_radius;
  std::size_t min_points;
};

const Settings& settings_of(const std::string& family) {
  static const std::map<std::string, Settings> all = {
      {"easy", {{0.005, 0.012}, 0.002, 0.03, 0.75, 0.001, 0.2, 250}},
      {"medium", {{0.008, 0.020}, 0.0015, 0.03, 0.8, 0.001, 0.2, 200}},
      {"hard", {{0.004, 0.020}, 0.002, 0.03, 0.85, 0.05, 0.3, 100}},
      {"bin", {{0.002, 0.006}, 0.001, 0.006, 0.8, 0.01, 0.1, 80}},
  };
  const auto known = all.find(family);
  return known != all.end() ? known->second : all.at("medium");
}

template <class Triple>
Eigen::Vector3d vector_of(const Triple& v) {
  return {v.x(), v.y(), v.z()};
}

void add(const Ransac::Shape& shape, double max_radius, std::vector<Found>* found) {
  const double score = static_cast<double>(shape.indices_of_assigned_points().size());
  if (const auto* plane = dynamic_cast<const Plane*>(&shape)) {
    found->push_back(found_plane(vector_of(plane->plane_normal()), plane->d(), score));
  } else if (const auto* sphere = dynamic_cast<const Sphere*>(&shape)) {
    if (sphere->radius() > max_radius) return;
    found->push_back(found_sphere(vector_of(sphere->center()), sphere->radius(), score));
  } else if (const auto* cylinder = dynamic_cast<const Cylinder*>(&shape)) {
    if (cylinder->radius() > max_radius) return;
    found->push_back(found_cylinder(vector_of(cylinder->axis().point(0)),
                                    vector_of(cylinder->axis().to_vector()), cylinder->radius(),
                                    score));
  } else if (const auto* cone = dynamic_cast<const Cone*>(&shape)) {
    found->push_back(
        found_cone(vector_of(cone->apex()), vector_of(cone->axis()), cone->angle(), score));
  }
}

std::vector<Found> detect(const OrientedCloud& cloud, const std::string& family) {
  const Settings& settings = settings_of(family);
  Points points;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Eigen::Vector3f &p = cloud.points[i], &n = cloud.normals[i];
    points.emplace_back(Kernel::Point_3(p.x(), p.y(), p.z()),
                        Kernel::Vector_3(n.x(), n.y(), n.z()));
  }
  CGAL::get_default_random() = CGAL::Random(0);
  Ransac ransac;
  ransac.set_input(points);
  ransac.add_shape_factory<Plane>();
  ransac.add_shape_factory<Sphere>();
  ransac.add_shape_factory<Cylinder>();
  ransac.add_shape_factory<Cone>();
  Ransac::Parameters parameters;
  parameters.probability = settings.probability;
  parameters.min_points = settings.min_points;
  parameters.epsilon = settings.epsilon;
  parameters.cluster_epsilon = settings.cluster_epsilon;
  parameters.normal_threshold = settings.normal_threshold;
  ransac.detect(parameters);
  std::vector<Found> found;
  for (const auto& shape : ransac.shapes()) add(*shape, settings.max_radius, &found);
  return found;
}

}  // namespace
}  // namespace quadrille::bench

int main(int argc, char** argv) {
  using namespace quadrille::bench;
  return run_peer(
      argc, argv, [](const std::string& family) { return settings_of(family).orientation; },
      detect);
}
