// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawn_refusal.h"

#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include <nodal/elastic/mechanism.h>
#include <nodal/file.h>

#include "output_file.h"
#include "report/mechanism_svg.h"

namespace nodal {

namespace {

report::Mechanism drawn(const elastic::MechanismError& error, const std::string& study) {
  report::Mechanism mechanism;
  mechanism.title = std::filesystem::path(study).stem().string() + ": a mechanism";
  mechanism.text = error.what();
  mechanism.nodes = elastic::in_plane(error.net.nodes);
  for (const elastic::Spring& s : error.net.springs) mechanism.springs.push_back({s.first, s.second});
  for (std::size_t i = 0; i < error.net.nodes.size(); ++i)
    mechanism.motion.push_back({error.motion[2 * i], error.motion[2 * i + 1]});
  mechanism.rings = error.net.body.rings;
  return mechanism;
}

}  // namespace

Study read_study_or_draw(const std::string& path, const Registry& registry, const StudyOverrides& overrides,
                         const std::string& picture) {
  try {
    return read_study(path, registry, overrides);
  } catch (const elastic::MechanismError& error) {
    if (!picture.empty()) {
      refuse_no_picture("--picture", picture);
      replace_file(picture, report::mechanism_svg(drawn(error, path)));
      std::cerr << fmt::format("written: {}\n", picture);
    }
    throw;
  }
}

}  // namespace nodal
