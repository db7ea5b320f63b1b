#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "lab/scene/scene.hpp"

namespace quadrille::scene {

/// Returns the path of the ground truth beside a cloud or log: OUT.truth.json for OUT.ply or
/// OUT.lcm.
std::string truth_path(const std::string& path);

/// Returns the existing ground truth beside a cloud: OUT.truth.json, or else OUT.json, as other
/// tools name it; nullopt if neither exists.
std::optional<std::string> find_truth(const std::string& ply_path);

/// Returns camera, noise, and one object for each surface with its q in the camera frame, pose
/// (x_C = R x_S + t), dims, box (in S) and what the camera saw of it.
nlohmann::ordered_json truth_json(const Scene& scene);
/// Returns it as the text of its file.
std::string truth_text(const Scene& scene);

/// These functions read parts of a ground truth as truth_json() writes them.
/// @throws nlohmann::json::exception if they are something else
Eigen::Vector3d vector_of(const nlohmann::ordered_json& json);
Eigen::Isometry3d pose_of(const nlohmann::ordered_json& json);
Eigen::AlignedBox3d box_of(const nlohmann::ordered_json& json);
Quadric quadric_of(const nlohmann::ordered_json& json);

/// Writes OUT.ply and OUT.truth.json; with labels also OUT.labels (int32 per point) and OUT.normals
/// (3 float32 per point).
/// @throws io::FileError if a file cannot be written
void write_scene(const std::string& ply_path, const Scene& scene, bool labels);

}  // namespace quadrille::scene
