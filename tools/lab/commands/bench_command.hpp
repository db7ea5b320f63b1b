#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `bench [CLOUD…]`, which compares the detector with its variants, with plain baselines and
/// with the available peers, and writes bench.md, bench.csv, bench.json and bench.svg.
void add_bench_command(CLI::App& app);

}  // namespace quadrille
