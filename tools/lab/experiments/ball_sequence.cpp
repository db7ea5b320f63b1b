#include "lab/experiments/ball_sequence.hpp"

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/file_bytes.hpp"
#include "io/json/json_parts.hpp"

namespace quadrille::experiments {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const char* const kCure = "; set QUADRILLE_DATA to a folder with data/real";

BallFrame frame_of(const json& frame, double radius, const fs::path& folder) {
  const json& c = frame.at("objects").at(0).at("params").at("center");
  return {(folder / frame.at("file").get<std::string>()).string(),
          {{c.at(0).get<double>(), c.at(1).get<double>(), c.at(2).get<double>()}, radius}};
}

std::vector<BallSequence> sequences_of(const json& manifest, const fs::path& folder) {
  std::vector<BallSequence> sequences;
  for (const json& scan : manifest.at("scenes")) {
    if (scan.value("kind", "") != "sequence") continue;
    BallSequence sequence{scan.at("name"), {}};
    const double radius = scan.at("radius_over_sequence").at("median");
    if (!(radius > 0.0)) throw std::domain_error("a radius is not positive");
    for (const json& frame : scan.at("frames")) {
      sequence.frames.push_back(frame_of(frame, radius, folder));
    }
    if (!sequence.frames.empty()) sequences.push_back(std::move(sequence));
  }
  return sequences;
}

}  // namespace

fs::path real_scans() {
  const char* named = std::getenv("QUADRILLE_DATA");
  return fs::path(named ? named : "../shared") / "data" / "real";
}

std::vector<BallSequence> read_sequences(const fs::path& folder) {
  const std::string path = (folder / "manifest.json").string();
  std::error_code ignored;
  if (!fs::exists(path, ignored))
    throw io::FileError(path, "", std::string("no real scans") + kCure);
  const std::vector<std::byte> bytes = io::read_file(path);
  const char* text = reinterpret_cast<const char*>(bytes.data());
  std::vector<BallSequence> sequences;
  try {
    sequences = sequences_of(json::parse(text, text + bytes.size()), folder);
  } catch (const std::exception& error) {
    throw io::json_error(path, "no list of scans", error, kCure);
  }
  if (sequences.empty()) throw io::FileError(path, "", std::string("lists no sequence") + kCure);
  return sequences;
}

}  // namespace quadrille::experiments
