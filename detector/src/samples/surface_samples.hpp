#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace quadrille {

/// Points of the measured surfaces with normals and neighbours: the one form on which all stages
/// after the front ends work. Structure of arrays; element i of each array belongs to sample i.
struct SurfaceSamples {
  /// Smoothed position (local regression), frame C [m].
  std::vector<Eigen::Vector3f> p;
  /// Unit normal, turned towards the viewpoint.
  std::vector<Eigen::Vector3f> n;
  /// Mean of the measured points of the sample's cell, not smoothed, frame C [m].
  std::vector<Eigen::Vector3f> raw;
  /// Standard deviation of raw about the surface, correlated noise included [m].
  std::vector<float> sigma;
  /// Size of the cell: distance to the next sample [m].
  std::vector<float> cell;
  /// Measured points in the cell.
  std::vector<int> count;
  /// Index of the cell that the sample was made of, in its front end's own order.
  std::vector<int> source;
  /// Neighbours of sample i: neighbours[first[i]] … neighbours[first[i + 1] - 1].
  std::vector<int> first, neighbours;
  /// Share of the finest samples' sigma that neighbours have in common; see common_share().
  double common_noise = 0.0;

  int size() const { return static_cast<int>(p.size()); }
  std::span<const int> neighbours_of(int i) const {
    return {neighbours.data() + first[i], static_cast<std::size_t>(first[i + 1] - first[i])};
  }
};

}  // namespace quadrille
