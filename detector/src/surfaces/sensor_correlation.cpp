#include "surfaces/sensor_correlation.hpp"

#include <algorithm>

namespace quadrille {
namespace {

// Least mean correlation that tells of a sensor. That of surfaces with white noise reaches 0.05,
// since no fit is perfect; that of simulated stereo, structured light and time of flight is 0.3 to
// 0.7.
constexpr double kLeastOfSensors = 0.1;

}  // namespace

void share_correlation(std::vector<Surface>* surfaces) {
  double sum = 0.0, samples = 0.0;
  for (const Surface& surface : *surfaces) {
    const auto size = static_cast<double>(surface.region.size());
    sum += size * surface.evidence.correlation;
    samples += size;
  }
  if (!(sum > kLeastOfSensors * samples)) return;
  for (Surface& surface : *surfaces) {
    double& correlation = surface.evidence.correlation;
    correlation = std::max(correlation, sum / samples);
  }
}

}  // namespace quadrille
