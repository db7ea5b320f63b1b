#pragma once

#include <vector>

#include "base/mask.hpp"
#include "boxes/box_seeds.hpp"
#include "boxes/face.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/stage_options.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille {

/// Places where a box may be although its faces were not detected as planes.
struct BoxHints {
  /// Patches about flat surface that is too small or too bent for a plane.
  std::vector<FlatPatch> patches;
  /// Things whose sides are at right angles.
  std::vector<BoxSeed> seeds;
};

/// Finds such places in the samples of one view.
/// @param free        samples to use, which lie on no detection
/// @param detections  planes among them that are small enough for a face may be sides of seeds
/// @param owner       for each sample the id of the detection on which it lies
/// @param view        the view whose samples are used
BoxHints find_box_hints(const SurfaceSamples& samples, const PlaneOptions& options,
                        const Mask& free, const std::vector<Detection>& detections,
                        const std::vector<int>& owner, std::size_t view);

}  // namespace quadrille
