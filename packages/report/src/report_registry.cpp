#include "hawser/report/report_registry.hpp"

#include "hawser/base/error.hpp"
#include "src/energy_report.hpp"
#include "src/error_report.hpp"
#include "src/extreme_report.hpp"
#include "src/flux_report.hpp"
#include "src/force_report.hpp"
#include "src/integral_report.hpp"
#include "src/line_report.hpp"
#include "src/point_report.hpp"
#include "src/probe_report.hpp"
#include "src/statistics_report.hpp"

namespace hawser {

void register_reports(ReportRegistry& registry) {
  registry.add<ForceReport>();
  registry.add<ProbeReport>("output");
  registry.add<ErrorReport>();
  registry.add<EnergyReport>();
  registry.add<IntegralReport>();
  registry.add<FluxReport>();
  registry.add<ExtremeReport>();
  registry.add<PointReport>();
  registry.add<LineReport>();
  registry.add<StatisticsReport>();
}

std::vector<NodeSpec> ReportRegistry::specs(const std::string& parent) const {
  std::vector<NodeSpec> result;
  for (const Entry& entry : entries_)
    if (entry.parent == parent) result.push_back(entry.spec);
  return result;
}

std::vector<PlannedReport> ReportRegistry::read(const std::vector<DeckNode>& nodes,
                                                const NodeSpec& parent,
                                                Diagnostics& diagnostics) const {
  std::vector<std::string> allowed;
  for (const ChildSpec& child : parent.children)
    allowed.push_back(child.node.tag);
  for (const NodeSpec& spec : specs(parent.tag))
    allowed.push_back(spec.tag);
  for (const DeckNode& node : nodes)
    is_known_child(node, parent.tag, allowed, diagnostics);
  std::vector<PlannedReport> result;
  for (const Entry& entry : entries_)
    for (const DeckNode& node : nodes)
      if (entry.parent == parent.tag && entry.spec.tag == node.tag)
        result.push_back(entry.read(node, diagnostics));
  return result;
}

void ReportRegistry::insert(Entry entry) {
  for (const Entry& known : entries_)
    if (known.spec.tag == entry.spec.tag)
      throw PluginError("two reports want the tag <" + known.spec.tag + ">; rename one of them");
  entries_.push_back(std::move(entry));
}

}  // namespace hawser
