#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "documents/document.hpp"
#include "support/catch.hpp"

using namespace quadrille;

namespace {

/// The names of all files of the repository's folders, and the paths to them.
std::set<std::string> files_of_repository() {
  std::set<std::string> files;
  for (const char* top :
       {"lcmtypes", "detector", "grasping", "examples", "tests", "tools", ".ci"}) {
    const std::filesystem::path folder = test::repository() / top;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      files.insert(entry.path().filename().string());
      files.insert(entry.path().lexically_relative(test::repository()).string());
    }
  }
  return files;
}

}  // namespace

TEST_CASE("links between documents lead somewhere", "[documents]") {
  const std::regex link("\\]\\(([^)#]+)(#[^)]*)?\\)");
  int found = 0;
  for (const std::string& document : test::all_documents()) {
    const std::string text = test::folded_document(document);
    for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
      const std::string target = (*it)[1].str();
      if (target.starts_with("http")) continue;
      CAPTURE(document, target);
      CHECK(std::filesystem::exists((test::repository() / document).parent_path() / target));
      ++found;
    }
  }
  CHECK(found > 20);
}

TEST_CASE("the files that documents name are there", "[documents]") {
  const std::set<std::string> files = files_of_repository();
  // Between backticks: paths and names of sources.
  const std::regex quoted("`([A-Za-z0-9_./-]*?)([a-z0-9_-]+\\.(cpp|hpp|lcm|cmake))`");
  int found = 0;
  for (const std::string& document : test::all_documents()) {
    const std::string text = test::folded_document(document);
    for (std::sregex_iterator it(text.begin(), text.end(), quoted), end; it != end; ++it) {
      const std::string path = (*it)[1].str() + (*it)[2].str();
      CAPTURE(document, path);
      const bool public_header = path.starts_with("quadrille/");
      CHECK((files.count(path) > 0 || files.count((*it)[2].str()) > 0));
      // A path with folders has to end as a file of the repository does.
      if (path.find('/') == std::string::npos || public_header) continue;
      CHECK(std::any_of(files.begin(), files.end(), [&](const std::string& file) {
        return file == path || file.ends_with("/" + path);
      }));
      ++found;
    }
  }
  CHECK(found > 5);
}
