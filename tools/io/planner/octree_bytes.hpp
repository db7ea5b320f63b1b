#pragma once

#include <octomap/OcTree.h>

#include <string>

namespace quadrille::io {

/// Returns a tree in OctoMap's binary format, the content of a .bt file. OctoMap's own writer
/// prints to stderr.
/// @throws std::runtime_error if OctoMap cannot write the tree
std::string octree_bytes(const octomap::OcTree& tree);

}  // namespace quadrille::io
