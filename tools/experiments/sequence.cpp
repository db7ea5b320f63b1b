#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "experiments/experiments.hpp"
#include "experiments/sphere_errors.hpp"
#include "io/cloud_file.hpp"
#include "io/file_bytes.hpp"
#include "quadrille/detector/detector.hpp"

namespace quadrille::experiments {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

fs::path real_scans() {
  const char* named = std::getenv("QUADRILLE_DATA");
  return fs::path(named ? named : "../shared") / "data" / "real";
}

KnownSphere annotated(const json& frame) {
  const json& params = frame["objects"][0]["params"];
  const json& c = params["center"];
  return {{c[0].get<double>(), c[1].get<double>(), c[2].get<double>()},
          params["radius"].get<double>()};
}

}  // namespace

Report run_sequence(const Settings& settings) {
  const fs::path folder = real_scans();
  if (!fs::exists(folder / "manifest.json")) {
    Report skipped;
    skipped.findings = {"Not run: no real scans at " + folder.string() +
                        "; set QUADRILLE_DATA to the folder that holds data/real."};
    skipped.data.columns = {"set", "found", "radius_error", "centre_error"};
    return skipped;
  }
  const std::vector<std::byte> bytes = io::read_file((folder / "manifest.json").string());
  const json manifest = json::parse(reinterpret_cast<const char*>(bytes.data()),
                                    reinterpret_cast<const char*>(bytes.data()) + bytes.size());
  std::map<std::string, std::vector<SphereError>> groups;
  for (const json& scan : manifest["scenes"]) {
    if (scan.value("kind", "") != "sequence") continue;
    const json& frames = scan["frames"];
    const std::size_t step = settings.quick ? 6 : 1;
    for (std::size_t k = 0; k < frames.size(); k += step) {
      KnownSphere truth = annotated(frames[k]);
      // The ball is the same in all frames.
      truth.radius = scan["radius_over_sequence"]["median"].get<double>();
      const std::string file = frames[k]["file"];
      const DetectionResult result = detect(io::read_cloud((folder / file).string()));
      groups[scan["name"]].push_back(match(result, truth));
      settings.progress((k + 1.0) / static_cast<double>(frames.size()));
    }
  }
  return report_errors(groups);
}

}  // namespace quadrille::experiments
