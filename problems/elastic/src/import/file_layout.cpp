// SPDX-License-Identifier: GPL-3.0-or-later
#include <nodal/error.h>

#include "import/named_file.h"
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
  read_node_file(files, named_file(files, points.at("file")), laid.net, request.account, read_table_options(points));
  if (!request.problem.table("body").has("on_outline"))
    laid.net.body.on_outline = on_outline_as_written(in_plane(laid.net.nodes), request.body);
  find_border(laid.net);
  return laid;
}

OptionSchema file_options() {
  return {
      {.name = "file",
       .type = OptionType::text,
       .help = "nodes of your own, in the plane: CSV with columns x, y and if you like node (a number that names it) "
               "and mass, or a system file as 'nodal fit --export' writes it"},
      columns_option({"node", "x", "y", "mass"}),
      scale_option("its coordinates"),
  };
}

}  // namespace

extern const Layout kFileLayout = {.name = "file",
                                   .summary = "as a file says",
                                   .connection = "delaunay",
                                   .options = file_options,
                                   .without_outline = true,
                                   .make = read_nodes};

}  // namespace nodal::elastic
