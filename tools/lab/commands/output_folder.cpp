#include "lab/commands/output_folder.hpp"

#include <cstdlib>
#include <filesystem>

#include "cli/command_line.hpp"
#include "cli/output.hpp"
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

void OutputFolder::draw(const std::string& name, const std::vector<experiments::Plot>& plots) {
  written_.push_back(fs::path(draw_plots(path_of(name), plots)).filename().string());
}

std::string OutputFolder::list() const {
  std::string paths;
  for (const std::string& name : written_) paths += (paths.empty() ? "" : ", ") + path_of(name);
  return paths;
}

std::string OutputFolder::path_of(const std::string& name) const {
  return (fs::path(folder_) / name).string();
}

std::string draw_plots(const std::string& path, const std::vector<experiments::Plot>& plots) {
  std::string script = fs::path(path).replace_extension(".gnuplot").string();
  io::write_file(script, experiments::to_gnuplot(plots));
  io::NewFile picture(path);
  const std::string command = "gnuplot " + in_quotes(script) + " >";
  if (std::system((command + in_quotes(picture.path()) + " 2>/dev/null").c_str()) == 0) {
    picture.commit();
    return path;
  }
  print_warnings(path,
                 {"is not drawn, because gnuplot (package gnuplot-nox) is missing; draw it with: " +
                  command + in_quotes(path)});
  return script;
}

}  // namespace quadrille
