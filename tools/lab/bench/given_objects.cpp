#include "lab/bench/given_objects.hpp"

#include <map>
#include <utility>

namespace quadrille::bench {

std::vector<PointCloud> given_objects(const scoring::Frame& frame) {
  std::map<int, int> body_of;
  std::map<int, PointCloud> objects;
  for (const scoring::TrueSurface& surface : frame.surfaces) {
    body_of[surface.id] = surface.body;
    if (surface.curved) objects[surface.body];
  }
  for (std::size_t i = 0; i < frame.labels.size(); ++i) {
    const auto body = body_of.find(frame.labels[i]);
    if (body == body_of.end()) continue;
    const auto object = objects.find(body->second);
    if (object != objects.end()) object->second.points.push_back(frame.cloud.points[i]);
  }
  std::vector<PointCloud> clouds;
  for (auto& [body, cloud] : objects) {
    cloud.read = cloud.points.size();
    if (!cloud.points.empty()) clouds.push_back(std::move(cloud));
  }
  return clouds;
}

}  // namespace quadrille::bench
