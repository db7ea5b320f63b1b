#include "lab/bench/scratch_folder.hpp"

#include <stdlib.h>

#include <stdexcept>
#include <system_error>

namespace quadrille::bench {

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "quadrille-bench-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error(name + ": cannot be made; check TMPDIR and the space left");
  }
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace quadrille::bench
