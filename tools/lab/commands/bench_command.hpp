#pragma once

namespace CLI {
class App;
}

namespace quadrille {

/// Adds `bench [CLOUD…]`: compares the detector with its variants, with plain baselines and with
/// the peers that are there, and writes bench.md, bench.csv, bench.json and bench.svg.
void add_bench_command(CLI::App& app);

}  // namespace quadrille
