#include "src/energy_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hawser {
namespace {

/// What a term's quantity is called.
std::string column_name(const EnergyTerm& term) {
  std::string name = term.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  switch (term.kind) {
    case EnergyTerm::Kind::stored: return name + "_energy";
    case EnergyTerm::Kind::supplied: return "work_of_" + name;
    case EnergyTerm::Kind::dissipated: return "dissipation_by_" + name;
    case EnergyTerm::Kind::numerical: return "numerical_dissipation_by_" + name;
    default: return "energy_carried_off_by_" + name;
  }
}

}  // namespace

Spec<EnergyBalance> EnergyBalance::spec() {
  return {"energy-balance",
          "Reports the energy balance: what is stored, and, since the start, the work of loads and "
          "supports, what was dissipated by the equations and by their discretisation, and what is "
          "left unexplained."};
}

EnergyReport::EnergyReport(const EnergyBalance& /*deck*/, const ReportContext& context,
                           Diagnostics& /*diagnostics*/)
    : assembler_(context.assembler) {}

std::vector<Column> EnergyReport::columns() const {
  const std::string unit = std::string("J") + assembler_.dofs().mesh().per_depth();
  std::vector<Column> result;
  for (const EnergyTerm& term : assembler_.energy_terms())
    result.push_back({column_name(term), unit});
  for (const char* name : {"work_of_supports", "work_of_boundaries",
                           "numerical_dissipation_in_time", "energy_residue", "work_done"})
    result.push_back({name, unit});
  result.push_back({"energy_residue_of_work_done", ""});
  return result;
}

std::vector<double> EnergyReport::measure(const Step& step) {
  const EnergyAccount& account = *step.energy;
  std::vector<double> values;
  for (std::size_t i = 0; i < account.energy.size(); ++i)
    values.push_back(assembler_.energy_terms()[i].kind == EnergyTerm::Kind::stored
                         ? account.energy[i]
                         : account.work[i]);
  values.insert(values.end(), {account.supports, account.boundaries, account.time_dissipation,
                               account.residue, account.done, account.residue_of_work_done()});
  return values;
}

std::string EnergyReport::closing() const {
  const std::vector<Column> all = columns();
  std::string text = fmt::format("energy balance, {}\n", all.front().unit);
  for (std::size_t i = 0; i < all.size(); ++i)
    text += fmt::format("  {:<36}{:14.6g}\n", all[i].name, values()[i]);
  return text;
}

}  // namespace hawser
