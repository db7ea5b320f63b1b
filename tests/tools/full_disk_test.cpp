// Files that do not fit on the disk.
#include <filesystem>
#include <set>

#include "support/catch.hpp"
#include "tools/support_files.hpp"

namespace quadrille::test {
namespace {

namespace fs = std::filesystem;

std::set<std::string> files_in(const TempFolder& folder) {
  std::set<std::string> names;
  for (const auto& file : fs::directory_iterator(folder.path(""))) {
    names.insert(file.path().filename().string());
  }
  return names;
}

}  // namespace

TEST_CASE("a file that does not fit on the disk leaves nothing behind", "[command]") {
  const TempFolder folder;
  const std::string cloud = "'" + folder.path("cloud.ply") + "'", fresh = folder.path("new");
  REQUIRE(run_quadrille("scene --family easy " + cloud).code == 0);
  const std::set<std::string> before = files_in(folder);
  // With the file sizes, in blocks of 512 bytes, that leave room for what is printed.
  const std::vector<std::pair<std::string, std::string>> commands = {
      {"scene --family easy '" + fresh + ".ply'", "1"},
      {"scene --labels --family easy '" + fresh + ".ply'", "1"},
      {"detect " + cloud + " --json '" + fresh + "'", "1"},
      {"detect " + cloud + " --picture '" + fresh + ".png'", "32"},
      {"log '" + fresh + ".lcm' " + cloud, "1"}};
  for (const auto& [command, blocks] : commands) {
    CAPTURE(command);
    const Run run = run_quadrille(command, "trap '' XFSZ; ulimit -f " + blocks + "; ");
    INFO(run.err);
    CHECK(run.code == 1);
    CHECK(lines_of(run.err) == 1);
    CHECK(contains(run.err, fresh));
    CHECK_FALSE(contains(run.err, ".part"));
    CHECK(contains(run.err, "cannot be written"));
    CHECK(files_in(folder) == before);
  }
}

}  // namespace quadrille::test
