#pragma once

#include <span>
#include <vector>

#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/quadric.hpp"
#include "samples/cell_pyramid.hpp"

namespace quadrille {

/// Root mean square first-order distance of the measured points from the quadric of their cell [m].
/// It is larger than that of the samples, each of which is the mean of many points.
class PointRms {
 public:
  explicit PointRms(std::span<const Quadric> quadrics);

  /// Adds the points of a view.
  /// @param owner  per finest cell of the pyramid, the index of its quadric; −1 for none
  void add(const CloudView& cloud, const CellPyramid& pyramid, std::span<const int> owner);

  /// One value per quadric; NaN if it has too few points.
  std::vector<double> values() const;

 private:
  struct Sums {
    int n = 0;
    double squares = 0.0;
  };

  std::vector<Eigen::Matrix4f> Q_;
  std::vector<Sums> sums_;
};

}  // namespace quadrille
