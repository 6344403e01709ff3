// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/provenance.h>

#include <sys/utsname.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include <nodal/random.h>

#include "program_hash.h"
#include "revision.h"

namespace nodal {

namespace {

// The only mutable global of the library: filled while components are registered, read afterwards.
struct Libraries {
  std::mutex mutex;
  std::map<std::string, std::string> versions;
};

Libraries& libraries() {
  static Libraries instance;
  return instance;
}

std::string processor_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string system_name() {
  utsname name{};
  if (uname(&name) != 0) return "unknown";
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

// What can change speed or last digits without any word in the study.
Value environment() {
  Value set;
  for (const char* name : {"OMP_NUM_THREADS", "OMP_THREAD_LIMIT", "OPENBLAS_NUM_THREADS", "OPENBLAS_CORETYPE",
                           "LD_PRELOAD", "LD_LIBRARY_PATH"})
    if (const char* value = std::getenv(name)) set.set(name, value);
  return set;
}

}  // namespace

std::string version() { return NODAL_VERSION; }

std::string revision() { return NODAL_REVISION; }

std::vector<std::pair<std::string, std::string>> library_versions() {
  const std::lock_guard lock(libraries().mutex);
  return {libraries().versions.begin(), libraries().versions.end()};
}

void add_library_version(const std::string& name, const std::string& version) {
  const std::lock_guard lock(libraries().mutex);
  libraries().versions[name] = version;
}

Value provenance() {
  Value used;
  for (const auto& [name, number] : library_versions()) used.set(name, number);
  Value result;
  result.set("version", version());
  result.set("revision", revision());
  result.set("compiler", NODAL_COMPILER);
  result.set("flags", NODAL_FLAGS);
  result.set("build_type", NODAL_BUILD_TYPE);
  result.set("libraries", used);
  for (const auto& [key, part] : program_hashes().table()) result.set(key, part);
  result.set("processor", processor_name());
  result.set("threads", static_cast<std::int64_t>(std::thread::hardware_concurrency()));
  result.set("environment", environment());
  result.set("system", system_name());
  return result;
}

std::string build_identity(const Value& provenance) {
  Value identity;
  for (const char* key : {"version", "revision", "compiler", "flags", "build_type", "libraries", "executable"})
    if (const Value* part = provenance.find(key)) identity.set(key, *part);
  if (const Value* objects = provenance.find("objects"); objects && objects->is_table()) {
    Value::List hashes;  // not their paths: a build may be moved
    for (const auto& [path, hash] : objects->table()) hashes.push_back(hash);
    identity.set("objects", Value(std::move(hashes)));
  }
  return to_canonical_json(identity);
}

std::string build_id(const Value& provenance) { return fmt::format("{:016x}", hash64(build_identity(provenance))); }

}  // namespace nodal
