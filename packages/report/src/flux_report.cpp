#include "src/flux_report.hpp"

#include <algorithm>
#include <set>

#include "hawser/report/report_name.hpp"

namespace hawser {

Spec<FluxDeck> FluxDeck::spec() {
  using P = FluxDeck;
  return Spec<P>("flux",
                 "Reports what flows into a field's balance at the nodes of a region: the reaction "
                 "of what prescribes it there (a wall's heat, positive into the body), or what one "
                 "module brings. It closes the balance to the solver's tolerance, as the integral "
                 "of a gradient does not. Per component of the field.")
      .attribute("name", &P::name, required(), "Start of the quantities' names.")
      .attribute("field", &P::field, required(), "Field by name.")
      .attribute("on", &P::on, required(),
                 "Regions whose rows are summed; a node of several counts once.")
      .attribute("module", &P::module,
                 "Module whose contribution on the region is reported; all for the reaction.")
      .attribute("module-on", &P::module_on, absent("all modules of that name"),
                 "Regions of the modules that are meant, where several have the name.")
      .check(check_report_name<P>)
      .source("doc/decks.md");
}

FluxReport::FluxReport(const FluxDeck& deck, const ReportContext& context, Diagnostics& diagnostics)
    : dofs_(context.dofs()),
      deck_(deck),
      loads_({deck.name, "flux", deck.on, deck.field, deck.module, deck.module_on}, context,
             diagnostics) {
  if (loads_.field() < 0) return;
  const FieldDescription& field = dofs_.fields()[static_cast<std::size_t>(loads_.field())];
  for (int c = 0; c < field.components; ++c)
    columns_.push_back(
        {deck.name + "_flux" +
             (field.components > 1 ? std::string("_") + static_cast<char>('x' + c) : ""),
         field.residual_unit});
}

void FluxReport::look_ahead(const Outlook& outlook, Diagnostics& diagnostics) const {
  if (!loads_.of_reaction()) return;
  std::set<LocalIndex> held;
  for (const PrescribedRow& row : outlook.conditions.prescribed(outlook.state, outlook.state))
    held.insert(row.row);
  const int components = dofs_.fields()[static_cast<std::size_t>(loads_.field())].components;
  bool any = false;
  for (const LocalIndex row : loads_.rows())
    for (int c = 0; c < components; ++c)
      any = any || held.count(row + c) > 0;
  if (!dofs_.mesh().communicator.any(any))
    diagnostics.note(deck_.on.location,
                     "flux '" + deck_.name + "': nothing prescribes '" + deck_.field.value +
                         "' on '" + Domain(deck_.on.value).text() +
                         "' at the start, and where nothing does there is no reaction; "
                         "module=\"...\" gives what a module brings, an <integral> what is carried "
                         "across");
}

}  // namespace hawser
