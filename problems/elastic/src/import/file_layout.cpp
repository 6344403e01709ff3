// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/error.h>

#include "import/system_files.h"
#include "points/layout.h"
#include "points/written_places.h"

namespace nodal::elastic {

namespace {

LaidNodes read_nodes(const LayoutRequest& request) {
  const Options points = request.problem.table("points");
  if (!points.has("file"))
    throw InputError(points.values().source,
                     "layout 'file' needs a file with the nodes: points = { file = \"nodes.csv\" }");
  LaidNodes laid;
  laid.net.body = request.body;
  InputFiles& files = request.context.files;
  read_node_file(files, files.path(points.text("file")), laid.net, request.account, read_table_options(points));
  if (!request.problem.table("body").has("on_outline"))
    laid.net.body.on_outline = on_outline_as_written(in_plane(laid.net.nodes), request.body);
  find_border(laid.net);
  return laid;
}

}  // namespace

const Layout kFileLayout = {.name = "file",
                            .summary = "as a file says",
                            .connection = "delaunay",
                            .keys = {"file", "columns", "scale"},
                            .without_outline = true,
                            .make = read_nodes};

}  // namespace nodal::elastic
