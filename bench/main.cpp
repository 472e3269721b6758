#include <benchmark/benchmark.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/benchmarks.h"
#include "src/core/names.h"

/// The program that `ricochet bench` runs.
int main(int argc, char** argv) {
  CLI::App app("The speed measurements", "ricochet bench");
  std::string format = "text";
  app.add_option("--format", format, "What to print: text or json")
      ->check(CLI::IsMember({"text", "json"}));
  app.allow_extras();
  app.footer("Further flags are Google Benchmark's, such as --benchmark_filter=simulate");
  try {
    app.parse(argc - 1, argv + 1);  // after "ricochet"
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help
    std::fprintf(stderr, "ricochet: bench: %s\n", ricochet::one_line(error.what()).c_str());
    return 2;
  }

  std::vector<std::string> arguments = app.remaining();
  arguments.insert(arguments.begin(), "ricochet bench");
  if (format == "json") arguments.push_back("--benchmark_format=json");
  std::vector<char*> flags;
  for (std::string& argument : arguments) flags.push_back(argument.data());
  int flag_count = static_cast<int>(flags.size());
  flags.push_back(nullptr);
  ricochet::bench::add_simulation_benchmarks();
  ricochet::bench::add_derivative_benchmarks();
  ricochet::bench::add_gradient_cost_benchmarks();
  ricochet::bench::add_integrator_benchmarks();
  ricochet::bench::add_lanes_benchmarks();
  ricochet::bench::add_memory_benchmarks();
  ricochet::bench::add_overhead_benchmarks();
  ricochet::bench::add_regime_benchmarks();
  ricochet::bench::add_roofline_benchmarks();
  ricochet::bench::add_shape_benchmarks();
  benchmark::Initialize(&flag_count, flags.data());
  if (flag_count > 1) {
    std::fprintf(stderr,
                 "ricochet: bench: unknown argument %s; allowed: the flags of Google Benchmark, "
                 "--benchmark_...\n",
                 ricochet::one_line(flags[1]).c_str());
    return 2;
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
