#pragma once

#include <octomap/OcTree.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace quadrille::io {

/// Returns a tree in OctoMap's binary format, the content of a .bt file. OctoMap's own writer
/// prints to stderr.
/// @throws std::runtime_error if OctoMap cannot write the tree
std::string octree_bytes(const octomap::OcTree& tree);

/// Reads the content of a .bt file, or of an .ot file with a tree of type OcTree. The structure is
/// checked first, because OctoMap's own reader follows damaged files without an end.
/// @param name  of the file or message, for errors
/// @throws FileError if the bytes are no such tree
std::shared_ptr<octomap::OcTree> parse_octree(std::span<const std::byte> bytes,
                                              const std::string& name);

/// Reads a .bt or .ot file.
/// @throws FileError if it cannot be read, or parse_octree() refuses it
std::shared_ptr<octomap::OcTree> read_octree(const std::string& path);

}  // namespace quadrille::io
