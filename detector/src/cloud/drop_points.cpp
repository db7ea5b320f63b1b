#include "cloud/drop_points.hpp"

#include <cstddef>
#include <limits>

namespace quadrille {

void drop_points(const Mask& dropped, PointCloud* cloud) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < cloud->points.size(); ++k) {
    if (cloud->organised()) {
      if (dropped[k]) {
        cloud->points[k].setConstant(std::numeric_limits<float>::quiet_NaN());
      }
    } else if (!dropped[k]) {
      if (cloud->coloured()) cloud->colours[kept] = cloud->colours[k];
      cloud->points[kept++] = cloud->points[k];
    }
  }
  if (cloud->organised()) return;
  if (cloud->coloured()) cloud->colours.resize(kept);
  cloud->points.resize(kept);
}

}  // namespace quadrille
