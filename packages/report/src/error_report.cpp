#include "src/error_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "hawser/element/cell_geometry.hpp"
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
  const Mesh& mesh = dofs_.mesh();
  const Region& region = *region_;
  const ShapeTraits& cell_shape = traits(region.shape);
  const int moved = dofs_.find(field_name::displacement);
  const Quadrature rule = quadrature(region.shape, degree);
  const Tabulation field = tabulate(dofs_.fields()[static_cast<std::size_t>(field_)].basis, rule);
  const Tabulation geometry =
      tabulate(moved < 0 ? Basis::p1 : dofs_.fields()[static_cast<std::size_t>(moved)].basis, rule);

  std::vector<Sample> samples;
  std::vector<LocalIndex> rows;
  std::vector<LocalIndex> moved_rows;
  std::vector<std::array<double, 3>> X, x;  // of the nodes that move the cell
  for (LocalIndex cell = 0; cell < region.size(); ++cell) {
    if (region.cell_owners[static_cast<std::size_t>(cell)] != mesh.communicator.rank()) continue;
    X.assign(static_cast<std::size_t>(geometry.nodes), {});
    for (int k = 0; k < cell_shape.vertices; ++k) {
      const LocalIndex vertex =
          region.vertices[static_cast<std::size_t>(cell * cell_shape.vertices + k)];
      for (int j = 0; j < mesh.dimension; ++j)
        X[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)] =
            mesh.coordinates[static_cast<std::size_t>(mesh.dimension * vertex + j)];
    }
    for (int e = 0; cell_shape.vertices + e < geometry.nodes; ++e)
      for (std::size_t j = 0; j < 3; ++j)
        X[static_cast<std::size_t>(cell_shape.vertices + e)][j] =
            0.5 * (X[static_cast<std::size_t>(cell_shape.edge[e][0])][j] +
                   X[static_cast<std::size_t>(cell_shape.edge[e][1])][j]);
    x = X;
    moved_rows.clear();
    if (moved >= 0) dofs_.append_cell_rows(moved, region, cell, moved_rows);
    for (std::size_t a = 0; a < moved_rows.size(); ++a)
      for (std::size_t j = 0; moved_rows[a] >= 0 && j < static_cast<std::size_t>(mesh.dimension);
           ++j)
        x[a][j] += state.value[static_cast<std::size_t>(moved_rows[a]) + j];
    rows.clear();
    dofs_.append_cell_rows(field_, region, cell, rows);
    for (int q = 0; q < rule.points; ++q) {
      const auto shape = [&](const Tabulation& table, std::size_t a) {
        return table.values[static_cast<std::size_t>(q * table.nodes) + a];
      };
      double place[2][3] = {};  // X, x
      for (std::size_t k = 0; k < X.size(); ++k)
        for (std::size_t j = 0; j < 3; ++j) {
          place[0][j] += shape(geometry, k) * X[k][j];
          place[1][j] += shape(geometry, k) * x[k][j];
        }
      const SpaceTime at{place[1][0], place[1][1], place[1][2], place[0][0],
                         place[0][1], place[0][2], state.time};
      Sample result{
          rule.weights[static_cast<std::size_t>(q)] * stretch_at(q, rule, geometry, x[0].data()),
          {}};
      for (std::size_t c = 0; c < components_; ++c) {
        result.error[c] = -deck_.exact.value[c](at);
        for (std::size_t a = 0; a < rows.size(); ++a)
          result.error[c] += shape(field, a) * state.value[static_cast<std::size_t>(rows[a]) + c];
      }
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
