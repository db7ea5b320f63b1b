#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include "quadrille/detector/body.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille::io {

/// Returns a readable count: "1 cloud", "2 clouds".
std::string count_of(std::size_t count, const std::string& noun);

/// Lists channels with their counts, "A (2), B (1)"; if there are very many, only the first ones.
std::string list_channels(const std::map<std::string, std::int64_t>& counts);

/// Returns a readable dimension: "41.0 mm", or "7.4 deg" for angles.
std::string describe(const Dimension& dimension);

/// Returns all dimensions of a detection in one line: "radius 41.0 mm, length 90.9 mm"; if it was
/// seen from inside, "radius 38.0 mm, length 82.0 mm, its inside".
std::string describe_dimensions(const Detection& detection);

/// Returns size and faces of a box in one line: "148.2 x 113.9 x 72.0 mm, faces 3 5 8". A side that
/// was not seen is given with its bounds: "60.0 (0.0 to 80.2)".
std::string describe_box(const Box& box);

/// Returns the size of a body, what it stands on, its parts and its wall: "80.0 x 80.0 x 95.0 mm,
/// on 1, parts 2 5, wall 4.0 ± 1.0 mm". A size that was not seen is in parentheses.
std::string describe_body(const SceneBody& body);

/// Returns the size of what was seen of a lump: "seen 50 x 40 x 30 mm".
std::string describe_lump(const SceneBody& lump);

/// Returns the thickness of a body's wall with its standard deviation: "wall 3.6 ± 0.4 mm".
std::string describe_wall(const BodyWall& wall);

/// Returns a name for pictures: "1 elliptic cylinder".
std::string name_of(const Detection& detection);

/// Returns a short line for pictures, with three dimensions at most: "1 cylinder r 41.0 l 90.9 mm".
std::string short_label(const Detection& detection);

}  // namespace quadrille::io
