#pragma once

#include <filesystem>
#include <optional>

namespace quadrille::test {

/// The folder of real scans and scorers: $QUADRILLE_DATA, or ../shared beside the checkout.
/// Without it, says so on stderr (once) and returns nullopt.
std::optional<std::filesystem::path> data_folder();

}  // namespace quadrille::test
