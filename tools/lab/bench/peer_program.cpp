#include "lab/bench/peer_program.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/file_bytes.hpp"
#include "io/ply/ply.hpp"
#include "lab/bench/run_process.hpp"
#include "lab/bench/scratch_folder.hpp"

namespace quadrille::bench {
namespace {

using nlohmann::json;

Outcome outcome_of(const json& result) {
  Outcome outcome;
  outcome.wall_ms = result.at("wall_ms");
  outcome.cpu_ms = result.at("cpu_ms");
  for (const json& finding : result.at("findings")) {
    Vector10d q;
    for (int i = 0; i < 10; ++i) q[i] = finding.at("q").at(i);
    outcome.findings.push_back({Quadric(q), finding.at("score")});
  }
  return outcome;
}

}  // namespace

Outcome run_program_on(const std::string& program, const Frame& frame) {
  const ScratchFolder folder;
  const std::string cloud = folder.file("cloud.ply"), out = folder.file("found.json");
  io::write_ply(cloud, frame.cloud);
  if (!run_process({program, cloud, frame.family, out})) {
    throw std::runtime_error(program + ": failed; leave it out with --contender");
  }
  const std::vector<std::byte> bytes = io::read_file(out);
  const char* text = reinterpret_cast<const char*>(bytes.data());
  return outcome_of(json::parse(text, text + bytes.size()));
}

}  // namespace quadrille::bench
