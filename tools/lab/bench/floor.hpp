#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>

#include "quadrille/detector/options.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "samples/surface_samples.hpp"

namespace quadrille::bench {

/// What a stage works on. Its floor is the cost of one pass over that: no stage can do with less
/// unless it leaves some out.
enum class WorksOn { kPoints, kSamples };

/// Stages that nobody knows are taken to work on the samples.
WorksOn works_on(std::string_view stage);

/// Makes the samples of the finest level of the whole cloud; they are none if it is too small.
SurfaceSamples finest_samples(const PointCloud& cloud, const DetectorOptions& options);

/// One pass: adds up all coordinates.
float pass_over(std::span<const Eigen::Vector3f> positions);

/// One pass over the positions and normals of samples.
float pass_over(const SurfaceSamples& samples);

}  // namespace quadrille::bench
