#include "io/gripper_file.hpp"

#include <filesystem>
#include <set>
#include <stdexcept>

#include "io/toml_file.hpp"

namespace quadrille::io {
namespace {

/// Reads one key after the other and remembers which ones it knows.
class GripperReader {
 public:
  explicit GripperReader(const std::string& path) : path_(path), table_(read_toml(path)) {}

  void read(const char* key, double* value) { *value = number(key, required(key)); }

  template <int Size>
  void read(const char* key, Eigen::Matrix<double, Size, 1>* value) {
    const toml::node& node = required(key);
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() != Size) {
      throw FileError(path_, line_of(node),
                      "key '" + std::string(key) + "' must be an array of " + std::to_string(Size) +
                          " numbers [m]");
    }
    for (int i = 0; i < Size; ++i) (*value)[i] = number(key, (*array)[static_cast<size_t>(i)]);
  }

  std::string read_name() {
    known_.insert("name");
    return table_["name"].value_or(std::filesystem::path(path_).stem().string());
  }

  void refuse_unknown() const {
    for (const auto& [key, node] : table_) {
      if (!known_.count(std::string(key.str()))) {
        throw FileError(
            path_, line_of(node),
            "unknown key '" + std::string(key.str()) + "'; remove it or mend its spelling");
      }
    }
  }

 private:
  const toml::node& required(const char* key) {
    known_.insert(key);
    const toml::node* node = table_.get(key);
    if (node == nullptr) throw FileError(path_, "", "key '" + std::string(key) + "' is missing");
    return *node;
  }

  double number(const char* key, const toml::node& node) const {
    if (!node.is_number()) {
      throw FileError(path_, line_of(node), "key '" + std::string(key) + "' must be a number");
    }
    return *node.value<double>();
  }

  const std::string& path_;
  toml::table table_;
  std::set<std::string> known_;
};

}  // namespace

Gripper read_gripper(const std::string& path) {
  GripperReader reader(path);
  Gripper gripper;
  gripper.name = reader.read_name();
  reader.read("max_opening", &gripper.max_opening);
  reader.read("min_opening", &gripper.min_opening);
  reader.read("finger", &gripper.finger);
  reader.read("finger_front", &gripper.finger_front);
  reader.read("pad", &gripper.pad);
  reader.read("palm", &gripper.palm);
  reader.read("max_force", &gripper.max_force);
  reader.refuse_unknown();
  try {
    gripper.check();
  } catch (const std::invalid_argument& error) {
    throw FileError(path, "", error.what());
  }
  return gripper;
}

Gripper load_gripper(const std::string& name_or_path) {
  if (name_or_path.ends_with(".toml")) return read_gripper(name_or_path);
  return gripper_by_name(name_or_path);
}

}  // namespace quadrille::io
