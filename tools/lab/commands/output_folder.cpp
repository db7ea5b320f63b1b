#include "lab/commands/output_folder.hpp"

#include <filesystem>

#include "io/file_bytes.hpp"
#include "io/new_file.hpp"

namespace quadrille {

namespace fs = std::filesystem;

OutputFolder::OutputFolder(const std::string& folder, const std::vector<std::string>& names)
    : folder_(folder) {
  if (folder.empty()) throw io::FileError("--out", "", "is empty; give a folder, such as .");
  std::error_code error;
  fs::create_directories(folder, error);
  const std::string why = error ? " (" + error.message() + ")" : "";
  if (!fs::is_directory(folder, error)) {
    throw io::FileError(folder, "", "cannot be made a folder" + why + "; give --out another one");
  }
  // The probe deletes its file when it goes out of scope.
  for (const std::string& name : names) io::NewFile probe(path_of(name));
}

void OutputFolder::write(const std::string& name, const std::string& text) {
  io::write_file(path_of(name), text);
  written_.push_back(name);
}

std::string OutputFolder::list() const {
  std::string paths;
  for (const std::string& name : written_) paths += (paths.empty() ? "" : ", ") + path_of(name);
  return paths;
}

std::string OutputFolder::path_of(const std::string& name) const {
  return (fs::path(folder_) / name).string();
}

}  // namespace quadrille
