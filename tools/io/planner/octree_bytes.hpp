#pragma once

#include <octomap/OcTree.h>

#include <string>

namespace quadrille::io {

/// A tree in OctoMap's binary format, as a .bt file holds it. OctoMap's own writer talks to stderr.
/// @throws std::runtime_error if OctoMap cannot write the tree
std::string octree_bytes(const octomap::OcTree& tree);

}  // namespace quadrille::io
