#include "experiments/experiments.hpp"
#include "experiments/sphere_errors.hpp"
#include "quadrille/detector/canonical.hpp"
#include "quadrille/detector/detector.hpp"
#include "scene/scene.hpp"

namespace quadrille::experiments {
namespace {

// Fewer pixels are a sphere that is all but hidden.
constexpr int kLeastPixels = 300;

std::vector<KnownSphere> spheres_of(const scene::Scene& made) {
  std::vector<KnownSphere> spheres;
  std::size_t id = 0;
  for (const scene::Body& body : made.layout.bodies) {
    for (std::size_t part = 0; part < body.surfaces.size(); ++part, ++id) {
      const scene::Surface& surface = body.surfaces[part];
      if (surface.type != "sphere" || made.ideal.visible[id] < kLeastPixels) continue;
      const Eigen::Isometry3d X_CS = made.layout.X_CW * body.X_WB * body.X_BS[part];
      const CanonicalForm form = canonical_form(surface.Q_S.transformed(X_CS));
      spheres.push_back({form.X.translation(), form.dimensions.front().second});
    }
  }
  return spheres;
}

PointCloud cloud_of(const scene::Scene& made) {
  PointCloud cloud;
  cloud.points = made.view.points;
  cloud.read = cloud.points.size();
  return cloud;
}

}  // namespace

Report run_spheres(const Settings& settings) {
  const int scenes = settings.quick ? 3 : 100;
  const std::vector<std::pair<std::string, scene::Family>> families = {
      {"easy", scene::Family::kEasy},
      {"medium", scene::Family::kMedium},
      {"hard", scene::Family::kHard}};
  std::map<std::string, std::vector<SphereError>> groups;
  double done = 0.0;
  for (const auto& [name, family] : families) {
    for (int k = 0; k < scenes; ++k) {
      const scene::Scene made =
          scene::make_scene({family, settings.seed * 1000 + static_cast<std::uint64_t>(k)});
      const std::vector<KnownSphere> spheres = spheres_of(made);
      if (!spheres.empty()) {
        const DetectionResult result = detect(cloud_of(made));
        for (const KnownSphere& truth : spheres) groups[name].push_back(match(result, truth));
      }
      settings.progress(++done / (scenes * static_cast<double>(families.size())));
    }
  }
  return report_errors(groups);
}

}  // namespace quadrille::experiments
