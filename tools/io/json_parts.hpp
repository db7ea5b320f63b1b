#pragma once

#include <Eigen/Core>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/file_bytes.hpp"
#include "io/json.hpp"

namespace quadrille::io {

/// The elements of a vector.
template <class Vector>
Json array_of(const Vector& v) {
  Json array = Json::array();
  for (Eigen::Index i = 0; i < v.size(); ++i) array.push_back(v[i]);
  return array;
}

/// The keys that begin each object: the input, with what it was worked on, and its frame.
Json begin_json(const InputInfo& input, const RunInfo& run);

/// What to throw where reading a file's JSON threw.
/// @param what  what the file is not
/// @param cure  how to mend it, behind the reason
FileError json_error(const std::string& path, const std::string& what, const std::exception& error,
                     const std::string& cure = "");

/// Adds "STAGE_ms" for each stage.
void add_stages(const std::vector<StageTime>& stages, Json* timings);

}  // namespace quadrille::io
