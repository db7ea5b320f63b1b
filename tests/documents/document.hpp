#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace quadrille::test {

/// The text of a file of the repository, white space folded to single spaces, so that sentences and
/// rows are found however their lines are broken.
std::string folded_document(const std::string& path);

/// Checks that a document quotes a sentence, whose numbers were just computed: a failure prints the
/// sentence that has to stand there instead.
void check_says(const std::string& path, const std::string& sentence);

/// All documents of the repository.
std::vector<std::string> all_documents();

/// The folder of the repository.
std::filesystem::path repository();

}  // namespace quadrille::test
