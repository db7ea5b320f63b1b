// PCL's SACSegmentationFromNormals, one shape at a time: large planes are removed, the rest is
// split into Euclidean clusters, and in each cluster the best sphere, cylinder or cone is taken
// repeatedly.
#include <pcl/console/print.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <algorithm>
#include <map>

#include "lab/bench/peers/peer.hpp"

namespace quadrille::bench {
namespace {

using Points = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;

/// The settings are tuned for each family, which is generous, since a user could not do that.
struct Settings {
  OrientationOptions orientation;
  double epsilon, plane_epsilon, cluster, normal_weight, max_radius, min_share;
  std::size_t min_points;
  int iterations;
};

const Settings& settings_of(const std::string& family) {
  static const std::map<std::string, Settings> all = {
      {"easy", {{0.008, 0.012}, 0.004, 0.008, 0.016, 0.02, 0.2, 0.4, 40, 500}},
      {"medium", {{0.005, 0.016}, 0.010, 0.018, 0.016, 0.1, 0.12, 0.25, 150, 1000}},
      {"hard", {{0.006, 0.012}, 0.004, 0.018, 0.02, 0.02, 0.2, 0.25, 40, 500}},
      {"bin", {{0.003, 0.008}, 0.002, 0.004, 0.005, 0.1, 0.05, 0.02, 60, 2000}},
  };
  const auto known = all.find(family);
  return known != all.end() ? known->second : all.at("medium");
}

struct Fit {
  pcl::SacModel model = pcl::SACMODEL_PLANE;
  std::vector<float> values;
  pcl::Indices inliers;
};

Found to_found(const Fit& fit) {
  const auto at = [&](int i) {
    return Eigen::Vector3d(fit.values[i], fit.values[i + 1], fit.values[i + 2]);
  };
  const double score = static_cast<double>(fit.inliers.size());
  switch (fit.model) {
    case pcl::SACMODEL_NORMAL_PLANE:
      return found_plane(at(0), fit.values[3], score);
    case pcl::SACMODEL_NORMAL_SPHERE:
      return found_sphere(at(0), fit.values[3], score);
    case pcl::SACMODEL_CYLINDER:
      return found_cylinder(at(0), at(3), fit.values[6], score);
    default:
      return found_cone(at(0), at(3), fit.values[6], score);
  }
}

class Detector {
 public:
  Detector(const OrientedCloud& cloud, const Settings& settings)
      : settings_(settings), points_(new Points), normals_(new Normals) {
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
      const Eigen::Vector3f &p = cloud.points[i], &n = cloud.normals[i];
      points_->push_back({p.x(), p.y(), p.z()});
      normals_->push_back({n.x(), n.y(), n.z()});
      open_.push_back(static_cast<int>(i));
    }
  }

  std::vector<Found> run() {
    take_planes();
    for (pcl::Indices& cluster : clusters()) take_shapes(std::move(cluster));
    return found_;
  }

 private:
  Fit fit(pcl::SacModel model, const pcl::Indices& among, double epsilon, int iterations) const {
    pcl::SACSegmentationFromNormals<pcl::PointXYZ, pcl::Normal> segmentation;
    segmentation.setOptimizeCoefficients(true);
    segmentation.setModelType(model);
    segmentation.setMethodType(pcl::SAC_RANSAC);
    segmentation.setNormalDistanceWeight(settings_.normal_weight);
    segmentation.setMaxIterations(iterations);
    segmentation.setDistanceThreshold(epsilon);
    // PCL complains about radius limits for planes and cones, to which they do not apply.
    if (model == pcl::SACMODEL_CYLINDER || model == pcl::SACMODEL_NORMAL_SPHERE) {
      segmentation.setRadiusLimits(0.015, settings_.max_radius);
    }
    if (model == pcl::SACMODEL_CONE) segmentation.setMinMaxOpeningAngle(0.08, 1.0);
    segmentation.setInputCloud(points_);
    segmentation.setInputNormals(normals_);
    segmentation.setIndices(pcl::make_shared<pcl::Indices>(among));
    pcl::PointIndices inliers;
    pcl::ModelCoefficients coefficients;
    segmentation.segment(inliers, coefficients);
    return {model, coefficients.values, inliers.indices};
  }

  /// Removes the fit's points from a sorted list.
  void take(const Fit& fit, pcl::Indices* list) {
    found_.push_back(to_found(fit));
    pcl::Indices gone = fit.inliers, left;
    std::sort(gone.begin(), gone.end());
    std::set_difference(list->begin(), list->end(), gone.begin(), gone.end(),
                        std::back_inserter(left));
    *list = std::move(left);
  }

  void take_planes() {
    constexpr int kPlanes = 4, kIterations = 300;
    const double least = 0.05 * static_cast<double>(points_->size());
    for (int k = 0; k < kPlanes && open_.size() >= 50; ++k) {
      const Fit plane =
          fit(pcl::SACMODEL_NORMAL_PLANE, open_, settings_.plane_epsilon, kIterations);
      if (static_cast<double>(plane.inliers.size()) < least) break;
      take(plane, &open_);
    }
  }

  std::vector<pcl::Indices> clusters() const {
    std::vector<pcl::PointIndices> found;
    if (open_.empty()) return {};
    const auto open = pcl::make_shared<pcl::Indices>(open_);
    const pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
    tree->setInputCloud(points_, open);
    pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
    extraction.setClusterTolerance(settings_.cluster);
    extraction.setMinClusterSize(static_cast<int>(settings_.min_points));
    extraction.setSearchMethod(tree);
    extraction.setInputCloud(points_);
    extraction.setIndices(open);
    extraction.extract(found);
    std::vector<pcl::Indices> lists;
    for (pcl::PointIndices& cluster : found) {
      std::sort(cluster.indices.begin(), cluster.indices.end());
      lists.push_back(std::move(cluster.indices));
    }
    return lists;
  }

  void take_shapes(pcl::Indices list) {
    constexpr int kRounds = 12;
    for (int round = 0; round < kRounds && list.size() >= settings_.min_points; ++round) {
      Fit best;
      for (const auto model :
           {pcl::SACMODEL_NORMAL_SPHERE, pcl::SACMODEL_CYLINDER, pcl::SACMODEL_CONE}) {
        Fit one = fit(model, list, settings_.epsilon, settings_.iterations);
        if (one.inliers.size() > best.inliers.size()) best = std::move(one);
      }
      const double least = std::max(static_cast<double>(settings_.min_points),
                                    settings_.min_share * static_cast<double>(list.size()));
      if (static_cast<double>(best.inliers.size()) < least) break;
      take(best, &list);
    }
  }

  const Settings& settings_;
  Points::Ptr points_;
  Normals::Ptr normals_;
  pcl::Indices open_;
  std::vector<Found> found_;
};

}  // namespace
}  // namespace quadrille::bench

int main(int argc, char** argv) {
  using namespace quadrille::bench;
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  return run_peer(
      argc, argv, [](const std::string& family) { return settings_of(family).orientation; },
      [](const OrientedCloud& cloud, const std::string& family) {
        return Detector(cloud, settings_of(family)).run();
      });
}
