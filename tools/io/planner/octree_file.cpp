#include "io/planner/octree_file.hpp"

#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "io/file_bytes.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille::io {
namespace {

// Levels of an OctoMap below its root.
constexpr int kDepth = 16;
// Sizes of a node [byte]: two bits for each of eight children, or a value and a bit for each.
constexpr std::size_t kBinaryNode = 2, kFullNode = 5;
// A message of a few megabytes could hold a tree that takes gigabytes. This many nodes take half of
// one, and are more than maps of whole buildings have.
constexpr std::size_t kMaxNodes = std::size_t{8} << 20;
// Voxels have edges within these bounds [m].
constexpr double kMinResolution = 1e-6, kMaxResolution = 1e3;

/// The header of a file, and where its nodes begin.
struct Header {
  bool binary = false;
  std::string type;
  double resolution = 0.0;
  std::size_t nodes = 0;
  std::size_t begin = 0;
};

template <class Number>
Number number_of(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? number : Number{};
}

std::optional<Header> read_header(std::string_view text) {
  Header header;
  constexpr std::string_view kBinary = "# Octomap OcTree binary file",
                             kFull = "# Octomap OcTree file";
  header.binary = text.starts_with(kBinary);
  if (!header.binary && !text.starts_with(kFull)) return std::nullopt;
  while (header.begin < text.size()) {
    const std::size_t end = text.find('\n', header.begin);
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view line = text.substr(header.begin, end - header.begin);
    header.begin = end + 1;
    if (line.starts_with("data")) return header;
    if (line.starts_with("id ")) header.type = line.substr(3);
    if (line.starts_with("size ")) header.nodes = number_of<std::size_t>(line.substr(5));
    if (line.starts_with("res ")) header.resolution = number_of<double>(line.substr(4));
  }
  return std::nullopt;
}

/// Walks over the nodes of a tree, which are stored depth first.
class NodeWalk {
 public:
  NodeWalk(std::string_view nodes, bool binary) : nodes_(nodes), binary_(binary) {}

  /// Returns false if a node lies deeper than a tree has levels, the bytes end before it, or there
  /// are too many.
  bool walk(int depth = 0) {
    const std::size_t size = binary_ ? kBinaryNode : kFullNode;
    const int deepest = binary_ ? kDepth - 1 : kDepth;
    if (depth > deepest || at_ + size > nodes_.size() || count_ > kMaxNodes) return false;
    const std::size_t here = at_;
    at_ += size;
    if (!binary_ && !std::isfinite(value_of(here))) return false;
    ++count_;
    for (unsigned child = 0; child < 8; ++child) {
      count_ += is_leaf(here, child);
      if (has_inner(here, child) && !walk(depth + 1)) return false;
    }
    return true;
  }

  bool at_end() const { return at_ == nodes_.size(); }
  /// Number of nodes so far.
  std::size_t count() const { return count_; }

 private:
  /// True if a child of the node has an entry of its own. In a binary file, 3 stands for such.
  bool has_inner(std::size_t node, unsigned child) const {
    if (!binary_) return byte(node + kFullNode - 1) >> child & 1u;
    return state(node, child) == 3u;
  }

  /// True if a child of the node is there without an entry of its own.
  bool is_leaf(std::size_t node, unsigned child) const {
    return binary_ && (state(node, child) == 1u || state(node, child) == 2u);
  }

  /// The two bits of a child in a binary file; 0 stands for none.
  unsigned state(std::size_t node, unsigned child) const {
    return byte(node + child / 4) >> 2 * (child % 4) & 3u;
  }

  /// The log-odds of a node of a full file, as OctoMap writes and reads them.
  float value_of(std::size_t node) const {
    float value = 0.0f;
    std::memcpy(&value, nodes_.data() + node, sizeof value);
    return value;
  }

  unsigned byte(std::size_t at) const { return static_cast<unsigned char>(nodes_[at]); }

  std::string_view nodes_;
  bool binary_;
  std::size_t at_ = 0;
  std::size_t count_ = 0;
};

}  // namespace

std::string octree_bytes(const octomap::OcTree& tree) {
  std::ostringstream stream;
  stream << "# Octomap OcTree binary file\nid " << tree.getTreeType() << "\nsize " << tree.size()
         << "\nres " << tree.getResolution() << "\ndata\n";
  // This does the same as OctoMap's writeBinaryData(), without its line on the standard error.
  if (tree.getRoot() != nullptr) tree.writeBinaryNode(stream, tree.getRoot());
  if (!stream) throw std::runtime_error("the octree cannot be written");
  return stream.str();
}

std::shared_ptr<octomap::OcTree> parse_octree(std::span<const std::byte> bytes,
                                              const std::string& name) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::optional<Header> header = read_header(text);
  if (!header) throw FileError(name, "", "is no OctoMap; give a .bt or .ot file");
  if (header->type != "OcTree") {
    throw FileError(name, "field id",
                    "is a tree of type '" + printable(header->type) +
                        "'; convert it to OcTree, as OctoMap's convert_octree does");
  }
  if (!(header->resolution >= kMinResolution && header->resolution <= kMaxResolution)) {
    throw FileError(name, "field res", "must be the edge of a voxel, from 1e-6 to 1000 m");
  }
  auto tree = std::make_shared<octomap::OcTree>(header->resolution);
  const std::string_view nodes = text.substr(header->begin);
  if (nodes.empty() && header->nodes == 0) return tree;
  NodeWalk walk(nodes, header->binary);
  const bool whole = walk.walk() && walk.at_end();
  if (walk.count() > kMaxNodes) {
    throw FileError(name, "",
                    "the tree has more than " + std::to_string(kMaxNodes) +
                        " nodes; give a part of it, or larger voxels");
  }
  if (!whole) {
    throw FileError(name, "byte " + std::to_string(header->begin),
                    "the nodes of the tree are cut short or damaged; write the file again");
  }
  std::istringstream stream{std::string(nodes)};
  if (header->binary) {
    tree->readBinaryData(stream);
  } else {
    tree->readData(stream);
  }
  return tree;
}

std::shared_ptr<octomap::OcTree> read_octree(const std::string& path) {
  return parse_octree(read_file(path), path);
}

}  // namespace quadrille::io
