#include "scene/view_clouds.hpp"

namespace quadrille {

ViewClouds::ViewClouds(const PointCloud& cloud, const Surroundings& known,
                       const std::vector<Detection>& detections,
                       std::vector<std::string>* warnings) {
  views_.push_back(checked(cloud, known.robot, warnings));
  for (const PointCloud& further : known.views) {
    const View view = checked(further, known.robot, warnings);
    const std::string doubt = contradict_viewpoint(*view.things, detections);
    if (doubt.empty()) {
      views_.push_back(view);
    } else {
      warnings->push_back("a further view is left out: " + doubt);
    }
  }
  if (size() == 1) return;
  for (const View& view : views_) {
    all_.points.insert(all_.points.end(), view.things->points.begin(), view.things->points.end());
  }
  all_.viewpoint = cloud.viewpoint;
}

ViewClouds::View ViewClouds::checked(const PointCloud& cloud, const RobotShapes& robot,
                                     std::vector<std::string>* warnings) {
  const RangeCheck& range = ranges_.emplace_back(check_range(cloud));
  if (range.far > 0) warnings->push_back(range.warning());
  const PointCloud* seen = &range.kept(cloud);
  if (robot.shapes.empty()) return {seen, seen};
  return {seen, &things_.emplace_back(robot.taken_from(*seen))};
}

}  // namespace quadrille
