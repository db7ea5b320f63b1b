// Detects once, with one thread, in one cloud. count_instructions() runs it under callgrind, which
// writes and resets its counts whenever part_ended() is called. It is a program of its own, since
// callgrind counts whole processes and translates everything that they run.
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

#include "detect_with.hpp"
#include "io/cloud_file.hpp"
#include "io/new_file.hpp"
#include "io/settings/config.hpp"
#include "lab/bench/floor.hpp"
#include "lab/bench/instructions.hpp"

/// Callgrind knows this function by its name.
extern "C" [[gnu::noinline]] void quadrille_part_ended() { asm volatile(""); }

namespace quadrille::bench {
namespace {

/// Ends a part and notes its name.
class Parts {
 public:
  void end(std::string_view part) {
    names_ += std::string(part) + "\n";
    quadrille_part_ended();
  }
  const std::string& names() const { return names_; }

 private:
  std::string names_;
};

void run(const std::string& cloud_path, const std::string& config_path,
         const std::string& names_path) {
  DetectorOptions options = io::load_detector_config(config_path).detector;
  options.threads = 1;
  const PointCloud cloud = io::read_cloud(cloud_path);
  Parts parts;
  parts.end(kReading);
  detect_watched([&](std::string_view stage) { parts.end(stage); }, cloud, options);
  const SurfaceSamples samples = finest_samples(cloud, options);
  parts.end(kMakingSamples);
  volatile float sink = pass_over(cloud.points);
  parts.end(kPassOverPoints);
  sink = pass_over(samples);
  parts.end(kPassOverSamples);
  static_cast<void>(sink);
  io::write_file(names_path, parts.names());
}

}  // namespace
}  // namespace quadrille::bench

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s CLOUD.ply CONFIG.toml|'' NAMES.txt\n", argv[0]);
    return 2;
  }
  try {
    quadrille::bench::run(argv[1], argv[2], argv[3]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 1;
  }
}
