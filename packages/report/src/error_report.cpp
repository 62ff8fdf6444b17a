#include "src/error_report.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/fields/field_sampler.hpp"
#include "hawser/fields/look_up.hpp"
#include "hawser/physics/field_use.hpp"
#include "hawser/report/verification_deck.hpp"

namespace hawser {
namespace {

// An error that is a polynomial of degree 4 on a cell is squared exactly: the quadrature's own
// error is far below the one that is measured.
constexpr int degree = 8;

}  // namespace

Spec<ErrorDeck> ErrorDeck::spec() {
  using P = ErrorDeck;
  return Spec<P>("error",
                 "Reports the difference between a field and its exact solution at the end of the "
                 "run: NAME_error_l2, the root of its integrated square over the moved region (the "
                 "field's unit times m in a body, m^(1/2) on a line), and NAME_error_max.")
      .attribute("name", &P::name, required(), "Start of the quantities' names.")
      .attribute("field", &P::field, required(), "Field by name.")
      .attribute("on", &P::on, required(), "Region: a body or a line.")
      .attribute("exact", &P::exact, "SI", required() && any(),
                 "An expression per component, of x y z (moved), X Y Z (reference), t.")
      .attribute("up-to-constant", &P::up_to_constant,
                 "Leave out the difference's mean: for a pressure whose level nothing fixes.");
}

std::vector<std::string> error_quantities(const std::vector<DeckNode>& reports) {
  std::vector<std::string> names;
  for (const DeckNode& node : reports) {
    const DeckAttribute* const name = node.find_attribute("name");
    if (node.tag != ErrorDeck::spec().tag() || name == nullptr) continue;
    for (const char* norm : {"_error_l2", "_error_max"})
      names.push_back(trimmed(name->value) + norm);
  }
  return names;
}

ErrorReport::ErrorReport(const ErrorDeck& deck, const ReportContext& context,
                         Diagnostics& diagnostics)
    : dofs_(context.dofs()),
      deck_(deck),
      region_(find_region(dofs_.mesh(), deck.on, diagnostics)),
      field_(find_field(dofs_, deck.field, diagnostics)) {
  if (region_ == nullptr || field_ < 0) return;
  const FieldDescription& field = dofs_.fields()[static_cast<std::size_t>(field_)];
  has_rate_ = context.rate_rules[static_cast<std::size_t>(field_)] != RateRule::none;
  components_ = static_cast<std::size_t>(field.components);
  if (deck.exact.value.size() != components_)
    diagnostics.error(deck.exact.location, "field '" + field.name + "' has " +
                                               std::to_string(components_) + " component(s), and " +
                                               std::to_string(deck.exact.value.size()) +
                                               " are given; formulas are set apart by ';'");
  if (region_->dimension == 0)
    diagnostics.error(deck.on.location, "an error is measured on a body or a line, and '" +
                                            region_->name +
                                            "' is a point; a <probe> gives the value there");
  else if (field.numbering == Numbering::sides && region_->shape == CellShape::line)
    diagnostics.error(deck.on.location, "field '" + field.name +
                                            "' may have two values on a line; measure its error "
                                            "on the body");
}

std::vector<ErrorReport::Sample> ErrorReport::sample(const State& state) const {
  const Region& region = *region_;
  FieldSampler at(dofs_, region, quadrature(region.shape, degree), {field_},
                  dofs_.find(field_name::displacement));
  std::vector<Sample> samples;
  for (LocalIndex cell = 0; cell < region.size(); ++cell) {
    if (region.cell_owners[static_cast<std::size_t>(cell)] != dofs_.mesh().communicator.rank())
      continue;
    at.enter(cell, state);
    for (int q = 0; q < at.points().points; ++q) {
      at.go_to(q);
      Sample result{at.points().weights[static_cast<std::size_t>(q)] * at.stretch(), {}};
      for (std::size_t c = 0; c < components_; ++c)
        result.error[c] = at.value(0, static_cast<int>(c)) - deck_.exact.value[c](at.place());
      samples.push_back(result);
    }
  }
  return samples;
}

void ErrorReport::leave_out_mean(std::vector<Sample>& samples) const {
  const Communicator& communicator = dofs_.mesh().communicator;
  double volume = 0, sum[3] = {};
  for (const Sample& one : samples) {
    volume += one.weight;
    for (std::size_t c = 0; c < components_; ++c)
      sum[c] += one.weight * one.error[c];
  }
  volume = communicator.sum(volume);
  for (std::size_t c = 0; c < components_; ++c) {
    const double mean = communicator.sum(sum[c]) / volume;
    for (Sample& one : samples)
      one.error[c] -= mean;
  }
}

void ErrorReport::summarise(const Step& last, Summary& summary) const {
  const Communicator& communicator = dofs_.mesh().communicator;
  std::vector<Sample> samples;
  communicator.together([&] { samples = sample(has_rate_ ? last.end : last.balance); });
  if (deck_.up_to_constant) leave_out_mean(samples);
  double squares = 0, greatest = 0;
  for (const Sample& one : samples)
    for (std::size_t c = 0; c < components_; ++c) {
      squares += one.weight * one.error[c] * one.error[c];
      greatest = std::max(greatest, std::abs(one.error[c]));
    }
  summary.set(deck_.name + "_error_l2", std::sqrt(communicator.sum(squares)));
  summary.set(deck_.name + "_error_max", communicator.max(greatest));
}

}  // namespace hawser
