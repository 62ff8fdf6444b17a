#include "src/probe_report.hpp"

#include "hawser/fields/look_up.hpp"
#include "hawser/report/report_name.hpp"

namespace hawser {

Spec<ProbeDeck> ProbeDeck::spec() {
  using P = ProbeDeck;
  return Spec<P>("probe", "Writes a field at one point over time.")
      .attribute("name", &P::name, required(), "Column name and start of the quantities' names.")
      .attribute("on", &P::on, required(), "Point region.")
      .attribute("field", &P::field, required(), "Field by name.")
      .check(check_report_name<P>);
}

ProbeReport::ProbeReport(const ProbeDeck& deck, const ReportContext& context,
                         Diagnostics& diagnostics)
    : communicator_(context.mesh().communicator) {
  const DofMap& dofs = context.dofs();
  const Region* const point =
      find_point(dofs.mesh(), deck.on, "probe '" + deck.name + "'", diagnostics);
  const int index = find_field(dofs, deck.field, diagnostics);
  if (index < 0) return;
  const FieldDescription& field = dofs.fields()[static_cast<std::size_t>(index)];
  for (int c = 0; c < field.components; ++c) {
    std::string name = deck.name + "_" + field.name;
    if (field.components > 1) name += std::string("_") + static_cast<char>('x' + c);
    columns_.push_back({name, field.unit});
  }
  if (point == nullptr) return;
  const std::vector<LocalIndex> rows = dofs.region_rows(index, *point);
  if (!rows.empty() && rows.front() < dofs.owned()) first_row_ = rows.front();
  if (!communicator_.any(first_row_ >= 0))
    diagnostics.error(deck.on.location, "no module solves for '" + deck.field.value + "' at '" +
                                            deck.on.value + "': there is nothing to probe");
}

std::vector<double> ProbeReport::measure(const Step& step) {
  std::vector<double> values;
  for (std::size_t c = 0; c < columns_.size(); ++c)
    values.push_back(communicator_.sum(
        first_row_ < 0 ? 0.0 : step.end.value[static_cast<std::size_t>(first_row_) + c]));
  return values;
}

}  // namespace hawser
