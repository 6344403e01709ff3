# Makes one script of Vega's modules as Debian installs them (cmake -DVEGA_DIR=… -DOUTPUT=… -P BundleVega.cmake).
#
# The package has a file per module, each written for a loader (CommonJS), but no single vega.min.js. Each is wrapped
# into a block with a loader of one line; what the charts don't use (maps, force layouts, hierarchies, word clouds,
# Voronoi cells, labels, regression) stays out. The last lines do what Vega's own index does.
include("${CMAKE_CURRENT_LIST_DIR}/VegaModules.cmake")

set(script "var vega = (() => {\n\"use strict\";\nconst modules = {};\nconst require = (name) => modules[name];\n")
foreach(module IN LISTS NODAL_VEGA_MODULES)
  file(READ "${VEGA_DIR}/${module}.min.js" source)
  string(REGEX REPLACE "//# sourceMappingURL=[^\n]*" "" source "${source}")
  # The file of this module is named in the singular, the module in the plural.
  string(REPLACE "vega-selection" "vega-selections" name "${module}")
  string(APPEND script "{ const exports = modules[\"${name}\"] = {}, module = { exports };\n${source}\n}\n")
endforeach()
string(APPEND script "const dataflow = require(\"vega-dataflow\");
Object.assign(dataflow.transforms, require(\"vega-transforms\"), require(\"vega-view-transforms\"),
              require(\"vega-encode\"));
return { parse: require(\"vega-parser\").parse, View: require(\"vega-view\").View,
         expressionFunction: require(\"vega-functions\").expressionFunction };
})();\n")
string(FIND "${script}" "</script" closing)
if(NOT closing EQUAL -1)
  message(FATAL_ERROR "Vega's modules contain a closing script tag: they can't stand inside a page")
endif()
file(WRITE "${OUTPUT}" "${script}")
