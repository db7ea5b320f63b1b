#include "cli/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/file_bytes.hpp"
#include "quadrille/detector/printable.hpp"

namespace quadrille {

JsonLines::JsonLines(const std::string& path) : path_(path) {
  if (path_.empty() || owns_stdout()) return;
  new_file_.emplace(path_);
  file_.open(new_file_->path(), std::ios::trunc);
}

void JsonLines::write(const io::Json& json) {
  if (path_.empty()) return;
  // File names may hold any bytes, but JSON must be valid UTF-8.
  const std::string line = json.dump(-1, ' ', false, io::Json::error_handler_t::replace) + "\n";
  if (owns_stdout()) return print(line);
  file_ << line << std::flush;
  if (!file_) throw io::FileError(path_, "", "cannot be written; check the space left");
}

void JsonLines::finish() {
  if (!new_file_) return;
  file_.close();
  if (!file_) throw io::FileError(path_, "", "cannot be written; check the space left");
  new_file_->commit();
}

std::string PicturePaths::next(const std::string& input) {
  if (!several_) return path_;
  const std::filesystem::path path(path_);
  const std::string stem = std::filesystem::path(input).stem().string();
  const auto seen = std::count(used_.begin(), used_.end(), stem);
  used_.push_back(stem);
  std::string name = fmt::format("{}_{}", path.stem().string(), stem);
  if (seen > 0) name += fmt::format("_{}", seen + 1);
  return (path.parent_path() / (name + path.extension().string())).string();
}

void print_warnings(const std::string& input, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    std::cerr << "quadrille: " << printable(input, kMaxPath)
              << ": warning: " << printable(warning, kMaxLine) << "\n";
  }
}

void add_warnings(const std::string& about, const std::vector<std::string>& warnings,
                  std::vector<std::string>* all) {
  for (const std::string& warning : warnings) {
    all->push_back(fmt::format("{}: {}", about, warning));
  }
}

void print(const std::string& text) {
  std::cout << text << std::flush;
  if (!std::cout) throw std::runtime_error("stdout: cannot be written; is its reader gone?");
}

}  // namespace quadrille
