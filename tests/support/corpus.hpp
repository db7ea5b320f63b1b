#pragma once

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/scans.hpp"

namespace quadrille::test {

/// One input of a fuzzer.
struct CorpusFile {
  std::string name;
  std::vector<std::uint8_t> bytes;
};

/// All inputs in tests/corpus of a fuzzer, by name.
inline std::vector<CorpusFile> read_corpus(const std::string& fuzzer) {
  std::vector<CorpusFile> files;
  for (const auto& entry : std::filesystem::directory_iterator(corpus_folder(fuzzer))) {
    std::ifstream file(entry.path(), std::ios::binary);
    files.push_back({entry.path().filename().string(), {std::istreambuf_iterator<char>(file), {}}});
  }
  std::sort(files.begin(), files.end(),
            [](const CorpusFile& a, const CorpusFile& b) { return a.name < b.name; });
  return files;
}

}  // namespace quadrille::test
