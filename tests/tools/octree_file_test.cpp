#include "io/planner/octree_file.hpp"

#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>
#include <octomap/OcTreeStamped.h>

#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <tuple>

#include "io/file_bytes.hpp"
#include "support/catch.hpp"
#include "support/error_of.hpp"
#include "support/temp_folder.hpp"

namespace quadrille {
namespace {

std::shared_ptr<octomap::OcTree> parse_text(const std::string& text) {
  return io::parse_octree(std::as_bytes(std::span(text)), "map.bt");
}

std::string refusal_of_text(const std::string& text) {
  CHECK_THROWS_AS(parse_text(text), io::FileError);
  return test::error_of([&] { parse_text(text); });
}

/// A tree of occupied, free and unknown space, with leaves of several sizes.
octomap::OcTree random_tree(unsigned seed, double resolution) {
  std::mt19937 random(seed);
  octomap::OcTree tree(resolution);
  const auto number = [&](unsigned size) { return static_cast<double>(random() % size); };
  for (int n = 0; n < 60; ++n) {
    const octomap::point3d corner(static_cast<float>(resolution * (number(400) - 200.0)),
                                  static_cast<float>(resolution * (number(400) - 200.0)),
                                  static_cast<float>(resolution * (number(400) - 200.0)));
    const bool occupied = random() % 2;
    const unsigned edge = 1u + random() % 6;
    for (unsigned at = 0; at < edge * edge * edge; ++at) {
      const auto offset = [&](unsigned steps) {
        return static_cast<float>(resolution * static_cast<double>(steps));
      };
      const octomap::point3d step(offset(at % edge), offset(at / edge % edge),
                                  offset(at / edge / edge));
      tree.updateNode(corner + step, occupied);
    }
  }
  tree.prune();
  return tree;
}

using Leaves = std::map<std::tuple<unsigned, unsigned, unsigned>, std::pair<unsigned, float>>;

/// All leaves: where, how deep, and their value, or only whether they are occupied.
Leaves leaves_of(const octomap::OcTree& tree, bool values) {
  Leaves leaves;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    const octomap::OcTreeKey key = leaf.getKey();
    const float value =
        values ? leaf->getLogOdds() : static_cast<float>(tree.isNodeOccupied(*leaf));
    leaves[{key[0], key[1], key[2]}] = {leaf.getDepth(), value};
  }
  return leaves;
}

std::string bt_of(const octomap::OcTree& tree) {
  std::ostringstream stream;
  tree.writeBinaryConst(stream);
  return stream.str();
}

std::string ot_of(const octomap::AbstractOcTree& tree) {
  std::ostringstream stream;
  tree.write(stream);
  return stream.str();
}

/// A header, as OctoMap writes it.
std::string header_of(const std::string& kind, const std::string& fields) {
  return "# Octomap OcTree " + kind + "\n# (feel free to add / change comments)\n#\n" + fields +
         "data\n";
}

TEST_CASE("trees that OctoMap wrote are read as they were", "[octree]") {
  const double resolution = GENERATE(0.005, 0.05, 0.25);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const octomap::OcTree tree = random_tree(seed, resolution);
    REQUIRE(tree.getNumLeafNodes() > 100);
    const auto full = parse_text(ot_of(tree));
    CHECK((*full == tree));
    CHECK(full->getResolution() == Approx(resolution));
    CHECK((leaves_of(*full, true) == leaves_of(tree, true)));
    // The binary format tells only which leaves are occupied.
    octomap::OcTree likely = tree;
    likely.toMaxLikelihood();
    likely.prune();
    const auto binary = parse_text(bt_of(likely));
    CHECK(binary->getResolution() == Approx(resolution));
    CHECK((leaves_of(*binary, false) == leaves_of(likely, false)));
  }
}

TEST_CASE("what we write is what OctoMap reads, and we too", "[octree]") {
  octomap::OcTree tree = random_tree(4, 0.01);
  tree.toMaxLikelihood();
  tree.prune();
  std::stringstream stream(io::octree_bytes(tree));
  octomap::OcTree theirs(1.0);
  REQUIRE(theirs.readBinary(stream));
  CHECK((leaves_of(theirs, false) == leaves_of(tree, false)));
  CHECK((leaves_of(*parse_text(io::octree_bytes(tree)), false) == leaves_of(tree, false)));
}

TEST_CASE("a file is read by its content, whatever its name", "[octree]") {
  const test::TempFolder folder;
  const octomap::OcTree tree = random_tree(5, 0.02);
  CHECK((*io::read_octree(folder.write("map.bt", ot_of(tree))) == tree));
  const std::string none = folder.path("none.bt");
  CHECK(test::error_of([&] { io::read_octree(none); }).find("no such file") != std::string::npos);
  const std::string text = folder.write("text.bt", "a map\n");
  CHECK(test::error_of([&] { io::read_octree(text); }).find("text.bt") != std::string::npos);
}

TEST_CASE("an empty tree is one without nodes", "[octree]") {
  const octomap::OcTree empty(0.02);
  for (const std::string& text : {bt_of(empty), ot_of(empty), io::octree_bytes(empty)}) {
    const auto tree = parse_text(text);
    CHECK(tree->getRoot() == nullptr);
    CHECK(tree->getResolution() == Approx(0.02));
  }
}

TEST_CASE("a value that is not finite is refused", "[octree][hostile]") {
  for (const float value :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    octomap::OcTree tree(0.05);
    tree.updateNode(octomap::point3d(0.1f, 0.1f, 0.1f), true);
    REQUIRE(parse_text(ot_of(tree)));
    tree.search(0.1, 0.1, 0.1)->setLogOdds(value);
    refusal_of_text(ot_of(tree));
  }
}

TEST_CASE("trees of other types are refused by their name", "[octree][hostile]") {
  octomap::ColorOcTree coloured(0.05);
  coloured.updateNode(octomap::point3d(0.1f, 0.2f, 0.3f), true);
  const std::string refusal = refusal_of_text(ot_of(coloured));
  CHECK(refusal.find("ColorOcTree") != std::string::npos);
  CHECK(refusal.find("convert") != std::string::npos);
  octomap::OcTreeStamped stamped(0.05);
  stamped.updateNode(octomap::point3d(0.1f, 0.2f, 0.3f), true);
  CHECK(refusal_of_text(ot_of(stamped)).find("OcTreeStamped") != std::string::npos);
}

TEST_CASE("a tree that is cut anywhere is refused", "[octree][hostile]") {
  const octomap::OcTree tree = random_tree(6, 0.05);
  for (const std::string& whole : {bt_of(tree), ot_of(tree)}) {
    // Each length near the header, where a cut hits a line, and many of the others.
    for (std::size_t size = 0; size < whole.size(); size += size < 200 ? 1 : 97) {
      CAPTURE(size, whole.size());
      CHECK_THROWS_AS(parse_text(whole.substr(0, size)), io::FileError);
    }
    CHECK_THROWS_AS(parse_text(whole + '\0'), io::FileError);
  }
}

TEST_CASE("bytes that are no tree are refused", "[octree][hostile]") {
  std::mt19937 random(8);
  for (int n = 0; n < 300; ++n) {
    std::string noise;
    for (unsigned size = random() % 4000; size > 0; --size) {
      noise += static_cast<char>(random() % 256);
    }
    CHECK_THROWS_AS(parse_text(noise), io::FileError);
    // Behind a good header, noise may be a tree by chance if it is short, but ends in any case.
    for (const std::string kind : {"binary file", "file"}) {
      try {
        const auto tree = parse_text(header_of(kind, "id OcTree\nsize 1000\nres 0.05\n") + noise);
        CHECK(noise.size() < 100);
        CHECK(tree->getRoot() != nullptr);
      } catch (const io::FileError&) {
        SUCCEED();
      }
    }
  }
}

TEST_CASE("a tree with any of its bytes changed is refused or read, and never more",
          "[octree][hostile]") {
  std::mt19937 random(9);
  const octomap::OcTree tree = random_tree(7, 0.05);
  for (const std::string& whole : {bt_of(tree), ot_of(tree)}) {
    int refused = 0;
    for (int n = 0; n < 2000; ++n) {
      std::string changed = whole;
      changed[random() % changed.size()] ^= static_cast<char>(1u << random() % 8);
      try {
        parse_text(changed);
      } catch (const io::FileError&) {
        ++refused;
      }
    }
    CHECK(refused > 20);
  }
}

TEST_CASE("nodes that nest without an end are refused", "[octree][hostile]") {
  for (const std::string kind : {"binary file", "file"}) {
    const std::string header = header_of(kind, "id OcTree\nsize 100\nres 0.05\n");
    for (const std::size_t size : {2u, 5u, 32u, 85u, 90u, 1000u, 1000000u}) {
      CAPTURE(kind, size);
      CHECK_THROWS_AS(parse_text(header + std::string(size, '\xff')), io::FileError);
    }
  }
  // A single path to the deepest level is a tree; one level more is none.
  const auto path = [](int inner) {
    std::string nodes;
    for (int n = 0; n < inner; ++n) nodes += std::string("\x03\x00", 2);
    return header_of("binary file", "id OcTree\nsize 17\nres 0.05\n") + nodes +
           std::string("\x02\x00", 2);
  };
  const auto deepest = parse_text(path(15));
  CHECK(deepest->getNumLeafNodes() == 1);
  CHECK(deepest->begin_leafs().getDepth() == 16);
  CHECK_THROWS_AS(parse_text(path(16)), io::FileError);
}

TEST_CASE("a header without a sound resolution, or without nodes that it counts, is refused",
          "[octree][hostile]") {
  for (const std::string kind : {"binary file", "file"}) {
    const auto refusal = [&](const std::string& fields) {
      return refusal_of_text(header_of(kind, fields) + std::string("\x02\x00\x00\x00\x00", 5));
    };
    CAPTURE(kind);
    for (const std::string res : {"0", "-0.05", "nan", "inf", "5cm", "", "1e300", "1e-300"}) {
      CAPTURE(res);
      CHECK(refusal("id OcTree\nsize 1\nres " + res + "\n").find("res") != std::string::npos);
    }
    CHECK(refusal("id OcTree\nsize 1\n").find("res") != std::string::npos);
    CHECK(refusal("size 1\nres 0.05\n").find("type") != std::string::npos);
    const std::string sized = header_of(kind, "id OcTree\nsize 3\nres 0.05\n");
    CHECK(refusal_of_text(sized).find("damaged") != std::string::npos);
    CHECK_THROWS_AS(parse_text(sized.substr(0, sized.size() - 5)), io::FileError);
  }
}

TEST_CASE("a message of a few megabytes does not become a tree of gigabytes", "[octree][hostile]") {
  // Nodes with eight inner children down to the last level but `levels`, whose children are leaves.
  std::string nodes;
  const auto add = [&](auto& self, int below) -> void {
    if (below == 0) {
      nodes += std::string(2, '\xaa');
      return;
    }
    nodes += std::string(2, '\xff');
    for (int child = 0; child < 8; ++child) self(self, below - 1);
  };
  add(add, 7);
  REQUIRE(nodes.size() > 4'000'000);
  const std::string text = header_of("binary file", "id OcTree\nsize 20000000\nres 0.05\n") + nodes;
  CHECK(refusal_of_text(text).find("nodes") != std::string::npos);
}

}  // namespace
}  // namespace quadrille
