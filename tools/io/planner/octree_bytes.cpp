#include "io/planner/octree_bytes.hpp"

#include <sstream>
#include <stdexcept>

namespace quadrille::io {

std::string octree_bytes(const octomap::OcTree& tree) {
  std::ostringstream stream;
  stream << "# Octomap OcTree binary file\nid " << tree.getTreeType() << "\nsize " << tree.size()
         << "\nres " << tree.getResolution() << "\ndata\n";
  // This does the same as OctoMap's writeBinaryData(), without its line on the standard error.
  if (tree.getRoot() != nullptr) tree.writeBinaryNode(stream, tree.getRoot());
  if (!stream) throw std::runtime_error("the octree cannot be written");
  return stream.str();
}

}  // namespace quadrille::io
