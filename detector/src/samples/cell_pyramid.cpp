#include "samples/cell_pyramid.hpp"

namespace quadrille {

std::unique_ptr<CellPyramid> make_pyramid(const CloudView& cloud, const SamplingOptions& options) {
  if (auto pyramid = make_depth_pyramid(cloud, options)) return pyramid;
  return make_voxel_pyramid(cloud, options);
}

}  // namespace quadrille
