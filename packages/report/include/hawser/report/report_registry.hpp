#pragma once
// From a deck's tag to a report: its parameters' declaration and its maker. A plain object, filled
// by the program and by plug-ins in the same way.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hawser/deck/spec.hpp"
#include "hawser/report/report.hpp"

namespace hawser {

/// A report whose element has been read, before there is a mesh.
struct PlannedReport {
  Location location;  ///< of the element
  /// Unknown regions and fields go to the diagnostics. Collective.
  std::function<std::unique_ptr<Report>(const ReportContext&, Diagnostics&)> make;
};

class ReportRegistry {
 public:
  /// R::Parameters has a static spec(), whose tag names the report in <hawser>, or in <output>; R
  /// is built from (const R::Parameters&, const ReportContext&, Diagnostics&).
  template <class R>
  void add(const std::string& parent = "hawser") {
    using Parameters = typename R::Parameters;
    insert({parent, Parameters::spec().node_spec(), [](const DeckNode& node, Diagnostics& faults) {
              const Parameters parameters = Parameters::spec().read(node, faults);
              return PlannedReport{node.location,
                                   [parameters](const ReportContext& context, Diagnostics& found) {
                                     return std::make_unique<R>(parameters, context, found);
                                   }};
            }});
  }

  /// Specs of what may stand in `parent`, in the order of registration.
  std::vector<NodeSpec> specs(const std::string& parent) const;

  /// Reads the children of `parent` that its own spec does not declare: in the order of
  /// registration, those of one kind as in the deck. One of no known kind is a fault.
  std::vector<PlannedReport> read(const std::vector<DeckNode>& nodes, const NodeSpec& parent,
                                  Diagnostics& diagnostics) const;

 private:
  struct Entry {
    std::string parent;
    NodeSpec spec;
    std::function<PlannedReport(const DeckNode&, Diagnostics&)> read;
  };
  void insert(Entry entry);  ///< PluginError when the tag is taken
  std::vector<Entry> entries_;
};

/// <force>, <error> and, in <output>, <probe>.
void register_reports(ReportRegistry& registry);

}  // namespace hawser
