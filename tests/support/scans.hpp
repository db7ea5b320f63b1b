#pragma once

#include <filesystem>

namespace quadrille::test {

/// The folder of the real scans that come with the source: tests/data.
std::filesystem::path scans_folder();

}  // namespace quadrille::test
