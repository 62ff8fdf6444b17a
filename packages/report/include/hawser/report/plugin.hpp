#pragma once
// What a plug-in with reports exports; it may have modules (HAWSER_PLUGIN) beside them.
//
//   HAWSER_REPORT_PLUGIN(reports) { reports.add<KineticEnergy>(); }
#include "hawser/physics/abi.hpp"
#include "hawser/report/report_registry.hpp"

#define HAWSER_REPORT_PLUGIN(reports)                                                          \
  extern "C" __attribute__((visibility("default"))) const char* hawser_report_plugin_stamp() { \
    return HAWSER_ABI_STAMP;                                                                   \
  }                                                                                            \
  extern "C" __attribute__((visibility("default"))) void hawser_report_plugin_register(        \
      ::hawser::ReportRegistry& reports)
