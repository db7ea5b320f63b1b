#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace quadrille {

/// Points of the measured surfaces with normals and neighbours; all stages after the front ends
/// work on this form. Element i of each array belongs to sample i.
struct SurfaceSamples {
  /// Position smoothed by local regression, in frame C [m].
  std::vector<Eigen::Vector3f> p;
  /// Unit normal towards the viewpoint.
  std::vector<Eigen::Vector3f> n;
  /// Mean of the measured points in the sample's cell, not smoothed, in frame C [m].
  std::vector<Eigen::Vector3f> raw;
  /// Standard deviation of raw around the surface, including correlated noise [m].
  std::vector<float> sigma;
  /// Size of the cell, which is the distance to the next sample [m].
  std::vector<float> cell;
  /// Number of measured points in the cell.
  std::vector<int> count;
  /// Index of the cell from which the sample was made, in the order of its front end.
  std::vector<int> source;
  /// The neighbours of sample i are neighbours[first[i]] … neighbours[first[i + 1] - 1].
  std::vector<int> first, neighbours;
  /// The view from which the sample was made; empty if there is only one.
  std::vector<int> view;
  /// Standard deviation of what the views may still be off against each other [m].
  double view_shift = 0.0;
  /// Share of the finest samples' sigma that neighbours have in common; see common_share().
  double common_noise = 0.0;

  int size() const { return static_cast<int>(p.size()); }
  std::size_t view_of(int i) const { return view.empty() ? 0 : static_cast<std::size_t>(view[i]); }
  std::span<const int> neighbours_of(int i) const {
    return {neighbours.data() + first[i], static_cast<std::size_t>(first[i + 1] - first[i])};
  }
};

}  // namespace quadrille
