#include "lab/experiments/fit_times.hpp"

#include <algorithm>

#include "fits/contenders.hpp"
#include "lab/experiments/measure.hpp"
#include "lab/experiments/random_quadric.hpp"

namespace quadrille::experiments {

std::vector<Series> fit_times(const Settings& settings) {
  const std::vector<int> sizes =
      settings.quick ? std::vector<int>{10, 100} : std::vector<int>{10, 30, 100, 300, 1000, 3000};
  const int repetitions = settings.quick ? 3 : 25;
  std::vector<Series> lines;
  for (const Contender& contender : contenders(QuadricType::kEllipsoid)) {
    lines.push_back({std::string(contender.name), {}, contender.minimal});
    for (const int size : sizes) {
      std::vector<double> times;
      for (int trial = 0; trial < repetitions; ++trial) {
        RandomStream random(settings.seed, 1000 + static_cast<std::uint64_t>(trial));
        OrientedPointsd data =
            sample(random_quadric(QuadricType::kEllipsoid, random), size, random);
        add_point_noise(&data, 0.02 * size_of(data.points), random);
        // Quick fits are repeated, so that the time of reading the clock does not matter.
        const int calls = std::max(1, 300 / size);
        std::optional<Quadric> fit;
        const double time = microseconds([&] {
          for (int k = 0; k < calls; ++k) fit = contender.fit(data);
        });
        times.push_back(time / calls);
      }
      lines.back().points.emplace_back(size, quantile(times, 0.5));
    }
  }
  return lines;
}

}  // namespace quadrille::experiments
