#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// Places sorted into cubes, to find those about another place. SampleBuckets serves balls that
/// follow each other closely; here each search stands alone and takes a tenth of the steps.
class PlaceCubes {
 public:
  /// @param places  finite positions, which must outlive this [m]
  /// @param edge    of the cubes, best as long as most searches reach [m]
  PlaceCubes(std::span<const Eigen::Vector3f> places, float edge);

  /// The numbers of the places nearer than a reach [m] to p.
  std::vector<int> near(const Eigen::Vector3f& p, float reach) const;

 private:
  std::int64_t coordinate(double x) const;

  std::span<const Eigen::Vector3f> places_;
  double edge_;
  /// The cubes that hold places, in ascending order. Those that follow each other along x do so
  /// here.
  std::vector<std::uint64_t> cubes_;
  /// Cube k has the places order_[first_[k]] … order_[first_[k + 1] - 1].
  std::vector<int> first_, order_;
};

}  // namespace quadrille
