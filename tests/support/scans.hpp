#pragma once

#include <filesystem>
#include <string>

namespace quadrille::test {

/// The folder of the real scans that come with the source: tests/data.
std::filesystem::path scans_folder();

/// The folder of a fuzzer's inputs, such as "detect": tests/corpus/detect.
std::filesystem::path corpus_folder(const std::string& fuzzer);

}  // namespace quadrille::test
