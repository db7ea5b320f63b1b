#include "documents/document.hpp"

#include <fstream>
#include <sstream>

#include "support/catch.hpp"

namespace quadrille::test {
namespace {

std::string folded(std::istream& in) {
  std::string text, word;
  while (in >> word) text += (text.empty() ? "" : " ") + word;
  return text;
}

}  // namespace

std::filesystem::path repository() { return QUADRILLE_SOURCE_DIR; }

std::string folded_document(const std::string& path) {
  std::ifstream file(repository() / path);
  INFO(path);
  REQUIRE(file);
  return folded(file);
}

void check_says(const std::string& path, const std::string& sentence) {
  std::istringstream in(sentence);
  INFO(path << " should say: " << sentence);
  CHECK(folded_document(path).find(folded(in)) != std::string::npos);
}

std::vector<std::string> all_documents() {
  std::vector<std::string> documents;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(repository())) {
    const std::filesystem::path path = entry.path().lexically_relative(repository());
    const bool is_ours = !path.string().starts_with("build") && !path.string().starts_with("out");
    // What has changed is history: it names what is gone.
    if (is_ours && path.extension() == ".md" && path != "CHANGELOG.md") documents.push_back(path);
  }
  return documents;
}

}  // namespace quadrille::test
