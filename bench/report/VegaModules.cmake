# The modules of Vega that the charts need, each after those that it requires.
set(NODAL_VEGA_MODULES
  vega-util vega-time vega-format vega-loader vega-dataflow vega-canvas vega-scale vega-scenegraph vega-statistics
  vega-expression vega-selection vega-event-selector vega-functions vega-runtime vega-encode vega-transforms
  vega-view-transforms vega-parser vega-view)
