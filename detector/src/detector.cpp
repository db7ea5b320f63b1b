#include "quadrille/detector/detector.hpp"

namespace quadrille {

DetectionResult detect(const PointCloud& cloud, const DetectorOptions& options) {
  options.check();
  DetectionResult result;
  result.points_finite = cloud.points.size();
  return result;
}

}  // namespace quadrille
