#include "views/samples_on_demand.hpp"

#include <cstddef>
#include <utility>

#include "base/mask.hpp"
#include "samples/sample_tree.hpp"
#include "views/joined_samples.hpp"

namespace quadrille {

SamplesOnDemand::SamplesOnDemand(std::shared_ptr<const CellPyramid> cells, int threads)
    : cells_(std::move(cells)), threads_(threads) {}

void SamplesOnDemand::move(const Eigen::Isometry3d& X) { motions_.push_back(X); }

const SurfaceSamples& SamplesOnDemand::get() {
  if (cells_) {
    const Mask all(static_cast<std::size_t>(cells_->size(0)), 1);
    samples_ = SampleTree(*cells_, cells_->samples(all, threads_)).take_finest();
    cells_.reset();
  }
  for (const Eigen::Isometry3d& X : motions_) samples_ = moved(std::move(samples_), X);
  motions_.clear();
  return samples_;
}

}  // namespace quadrille
