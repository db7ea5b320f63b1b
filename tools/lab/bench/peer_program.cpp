#include "lab/bench/peer_program.hpp"

#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "io/file_bytes.hpp"
#include "io/ply/ply.hpp"

extern char** environ;

namespace quadrille::bench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A temporary folder that is deleted on destruction.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "quadrille-bench-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw std::runtime_error(name + ": cannot be made; check TMPDIR and the space left");
    }
    path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

void run(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t process = 0;
  int status = 0;
  const bool done =
      posix_spawn(&process, words[0].c_str(), nullptr, nullptr, arguments.data(), environ) == 0 &&
      waitpid(process, &status, 0) == process && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (!done) throw std::runtime_error(words[0] + ": failed; leave it out with --contender");
}

Outcome outcome_of(const json& result) {
  Outcome outcome;
  outcome.wall_ms = result.at("wall_ms");
  outcome.cpu_ms = result.at("cpu_ms");
  for (const json& finding : result.at("findings")) {
    Vector10d q;
    for (int i = 0; i < 10; ++i) q[i] = finding.at("q").at(i);
    outcome.findings.push_back({Quadric(q), finding.at("score")});
  }
  return outcome;
}

}  // namespace

Outcome run_program_on(const std::string& program, const Frame& frame) {
  const ScratchFolder folder;
  const std::string cloud = folder.file("cloud.ply"), out = folder.file("found.json");
  io::write_ply(cloud, frame.cloud);
  run({program, cloud, frame.family, out});
  const std::vector<std::byte> bytes = io::read_file(out);
  const char* text = reinterpret_cast<const char*>(bytes.data());
  return outcome_of(json::parse(text, text + bytes.size()));
}

}  // namespace quadrille::bench
