#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "base/mask.hpp"
#include "planes/planes.hpp"
#include "quadrille/detector/detection.hpp"
#include "samples/sight.hpp"
#include "samples/surface_samples.hpp"
#include "search/candidate.hpp"
#include "views/contradiction.hpp"
#include "views/scene.hpp"

namespace quadrille {

/// What one view adds to a scene of several views, in frame C.
struct ViewParts {
  /// The samples on which the planes were found, and the planes.
  SurfaceSamples coarse;
  std::vector<PlaneRegion> planes;
  /// The samples beside the planes, and the surfaces that were found among them.
  SurfaceSamples finest;
  std::vector<PlaneRegion> flats;
  std::vector<Candidate> candidates;
  /// For each finest cell its plane, −1 for none.
  std::vector<int> plane_of_cell;
};

/// @param view  a scene of one view
ViewParts parts_of(const Scene& view);

/// A box that a view shows, in frame C, and the number of the view's samples on it.
struct KeptBox {
  Box box;
  int samples = 0;
};

/// The parts of a view without its points, for later scenes. The cells are those of the finest
/// samples alone, in their order.
struct KeptParts {
  ViewParts parts;
  /// See scatter_in_cells() [m²].
  std::vector<Eigen::Matrix3f> scatter;
  std::vector<KeptBox> boxes;
  /// The viewpoint [m], and the depths that the view saw.
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();
  Sight sight;

  void drop(const Contradiction& contradiction);
  void drop(const ForgottenBox& box);
  /// The boxes of which most samples have not been dropped.
  std::vector<Box> lasting_boxes() const;

 private:
  void drop(const Mask& coarse, const Mask& finest);
};

/// @param view  a scene of one view, with its points
KeptParts kept_parts(const Scene& view);

/// Marks all samples of a surface if a newer view sees through most of them. If a thing was taken
/// away, no view sees through its foot, which lies too close above what it stood on.
/// @param seen_through  nonzero for the samples that the newer view sees through; what is marked
///   for one surface says nothing about another one that shares samples with it
void mark_rest(const std::vector<int>& region, const Mask& seen_through, Mask* marked);

/// Adds the boxes that a view shows.
void keep_boxes(const std::vector<Box>& boxes, KeptParts* kept);

/// Brings the parts of a view from frame C into frame F.
ViewParts moved(ViewParts parts, const Eigen::Isometry3d& X_FC);
std::vector<Eigen::Matrix3f> moved(std::vector<Eigen::Matrix3f> scatter,
                                   const Eigen::Isometry3d& X_FC);

}  // namespace quadrille
