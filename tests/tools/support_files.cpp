#include "tools/support_files.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "support/catch.hpp"

namespace quadrille::test {

Run run_quadrille(const std::string& arguments, const std::string& before) {
  const TempFolder folder;
  const std::string out = folder.path("out"), err = folder.path("err");
  const std::string command =
      before + "'" + QUADRILLE_EXECUTABLE + "' " + arguments + " >'" + out + "' 2>'" + err + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(err)};
}

void check_failure(const Run& run, const std::string& part) {
  INFO(run.err);
  CHECK(run.code == 1);
  CHECK(run.out.empty());
  CHECK(lines_of(run.err) == 1);
  CHECK(contains(run.err, part));
}

std::string ply_of(const std::vector<std::string>& points) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(points.size()) +
                     "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (const std::string& point : points) text += point + "\n";
  return text;
}

int lines_of(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace quadrille::test
