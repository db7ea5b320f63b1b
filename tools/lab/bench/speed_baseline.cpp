#include "lab/bench/speed_baseline.hpp"

#include <nlohmann/json.hpp>

#include "io/file_bytes.hpp"
#include "lab/bench/speed_baseline_text.hpp"

namespace quadrille::bench {
namespace {

using nlohmann::ordered_json;

SpeedBaseline::Cloud cloud_of(const ordered_json& json) {
  SpeedBaseline::Cloud cloud{json.at("points"), {}};
  for (const auto& [stage, count] : json.at("instructions").items()) {
    cloud.stages.emplace_back(stage, count.get<std::uint64_t>());
  }
  return cloud;
}

/// True if the machine has AVX2; valgrind shows the program no more than that.
bool has_avx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

}  // namespace

std::string built_by() { return std::string(compiler()) + (has_avx2() ? ", AVX2" : ", no AVX2"); }

SpeedBaseline own_baseline() { return parse_baseline(speed_json(), "speed.json"); }

SpeedBaseline parse_baseline(std::string_view text, const std::string& path) {
  try {
    const ordered_json json = ordered_json::parse(text);
    SpeedBaseline baseline{json.at("built_by"), {}};
    for (const auto& [name, cloud] : json.at("clouds").items()) {
      baseline.clouds.emplace(name, cloud_of(cloud));
    }
    return baseline;
  } catch (const ordered_json::exception&) {
    throw io::FileError(path, "",
                        "no counts of instructions; `quadrille bench --speed --store` writes them");
  }
}

SpeedBaseline read_baseline(const std::string& path) {
  const std::vector<std::byte> bytes = io::read_file(path);
  return parse_baseline({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path);
}

std::string to_json(const SpeedBaseline& baseline) {
  ordered_json clouds = ordered_json::object();
  for (const auto& [name, cloud] : baseline.clouds) {
    ordered_json stages = ordered_json::object();
    for (const auto& [stage, count] : cloud.stages) stages[stage] = count;
    clouds[name] = {{"points", cloud.points}, {"instructions", std::move(stages)}};
  }
  return ordered_json{{"built_by", baseline.built_by}, {"clouds", std::move(clouds)}}.dump(1) +
         "\n";
}

}  // namespace quadrille::bench
