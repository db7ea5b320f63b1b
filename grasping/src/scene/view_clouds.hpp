#pragma once

#include <cstddef>
#include <list>
#include <string>
#include <vector>

#include "quadrille/detector/cloud_checks.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/surroundings.hpp"

namespace quadrille {

/// The clouds of a scene, without points that no sensor can have measured. The clouds that are
/// given must outlive this.
class ViewClouds {
 public:
  /// A view as it was seen, and without the robot's points.
  struct View {
    const PointCloud* seen;
    const PointCloud* things;
  };

  /// A further view that cannot have been seen from its viewpoint is left out, because its free
  /// space would be wrong.
  /// @param warnings  receives what is wrong with the views
  ViewClouds(const PointCloud& cloud, const Surroundings& known,
             const std::vector<Detection>& detections, std::vector<std::string>* warnings);
  ViewClouds(const ViewClouds&) = delete;
  ViewClouds& operator=(const ViewClouds&) = delete;

  std::size_t size() const { return views_.size(); }
  const View& operator[](std::size_t view) const { return views_[view]; }
  std::vector<View>::const_iterator begin() const { return views_.begin(); }
  std::vector<View>::const_iterator end() const { return views_.end(); }

  /// The first view without the robot.
  const PointCloud& first() const { return *views_.front().things; }
  /// The points of all views without the robot, with the viewpoint of the first.
  const PointCloud& all() const { return size() == 1 ? first() : all_; }

 private:
  View checked(const PointCloud& cloud, const RobotShapes& robot,
               std::vector<std::string>* warnings);

  // In lists, so that the clouds in them keep their addresses.
  std::list<RangeCheck> ranges_;
  std::list<PointCloud> things_;
  std::vector<View> views_;
  PointCloud all_;
};

}  // namespace quadrille
