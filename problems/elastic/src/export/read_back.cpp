// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nodal/error.h>
#include <nodal/file.h>

#include "export/system_format.h"

namespace nodal::elastic {

std::vector<double> read_back(Table<SystemFormat> formats, InputFiles& files, const std::filesystem::path& path,
                              const Net& net) {
  const auto named = std::ranges::find(formats, extension_of(path), &SystemFormat::extension);
  const SystemFormat& format = named == formats.end() ? *formats.front() : **named;
  if (format.read) return format.read(files, path, net);
  std::vector<std::string> readable;
  for (const SystemFormat* other : formats)
    if (other->read) readable.push_back(fmt::format("{} ({})", other->summary, other->extension));
  throw InputError({path.string(), 0}, fmt::format("stiffnesses can't be read back from {}, only from {}",
                                                   format.summary, fmt::join(readable, " or ")));
}

}  // namespace nodal::elastic
