#pragma once

#include <Eigen/Geometry>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/file_bytes.hpp"
#include "io/json/json.hpp"

namespace quadrille::io {

/// Returns the elements of a vector.
template <class Vector>
Json array_of(const Vector& v) {
  Json array = Json::array();
  for (Eigen::Index i = 0; i < v.size(); ++i) array.push_back(v[i]);
  return array;
}

/// Reads a pose as to_json() writes it.
/// @throws std::exception if it is none
Eigen::Isometry3d pose_of(const Json& json);

/// Returns the keys that begin each object: the input, the run's settings, and the frame.
Json begin_json(const InputInfo& input, const RunInfo& run);

/// Returns the error to throw if reading a file's JSON threw.
/// @param what  what the file should have been but is not
/// @param cure  the remedy, which follows the reason
FileError json_error(const std::string& path, const std::string& what, const std::exception& error,
                     const std::string& cure = "");

/// Adds "STAGE_ms" for each stage.
void add_stages(const std::vector<StageTime>& stages, Json* timings);

}  // namespace quadrille::io
