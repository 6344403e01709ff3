// SPDX-License-Identifier: GPL-3.0-or-later
// Micro-benchmarks. Results carry where they come from: revision, compiler, BLAS, processor.
#include <benchmark/benchmark.h>

#include <string>

#include <nodal/components.h>
#include <nodal/provenance.h>

namespace {

std::string text_of(const nodal::Value& value) { return value.is_text() ? value.text() : to_json(value); }

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  nodal::Registry registry;
  nodal::register_components(registry);  // which makes the libraries' versions known
  const nodal::Value here = nodal::provenance();
  for (const char* key : {"revision", "compiler", "flags", "libraries", "processor"})
    if (const nodal::Value* value = here.find(key)) benchmark::AddCustomContext(key, text_of(*value));
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
