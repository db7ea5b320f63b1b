#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace quadrille::test {

/// What `quadrille detect --json` says about a cloud, which it has to read.
nlohmann::json detect(const std::filesystem::path& scan);

/// manifest.json of a folder: its scans and the objects annotated on them.
nlohmann::json manifest_of(const std::filesystem::path& folder);

/// Sees to it that a scan is read whole, and that what is found has no number that is not finite.
void check_read_whole(const std::filesystem::path& folder, const nlohmann::json& scan);

bool is_cylinder_of(const nlohmann::json& detection, double radius, double tolerance);
bool is_sphere_of(const nlohmann::json& detection, double radius, double tolerance);

/// True if a detection is of a type that an annotated object may have and holds most of its points.
bool covers(const nlohmann::json& detection, const nlohmann::json& object);

}  // namespace quadrille::test
