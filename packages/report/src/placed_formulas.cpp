#include "src/placed_formulas.hpp"

#include <limits>

namespace hawser {

PlacedFormulas::PlacedFormulas(const ReportContext& context,
                               const std::vector<FieldExpression>& formulas,
                               const std::string& unit, const std::string& user,
                               const Location& where, Diagnostics& diagnostics)
    : dofs_(context.dofs()), instant_(context) {
  if (!context.mesh().has_body()) {
    diagnostics.error(where, user +
                                 " looks into the cells of a body, and this mesh has none; a "
                                 "<probe> looks at the node of a point region");
    return;
  }
  for (const FieldExpression& formula : formulas) {
    formulas_.emplace_back(dofs_, formula, false, diagnostics);
    const FormulaFields& found = formulas_.back();
    if (!found.complete()) continue;
    instant_.look_at(found);
    const std::string name = found.plain_name(), own = found.plain_unit(dofs_);
    const std::string number = formulas.size() > 1 ? std::to_string(formulas_.size()) : "";
    columns_.push_back({name.empty() ? number : name, name.empty() ? unit : own});
  }
  locator_ = std::make_unique<CellLocator>(dofs_, moving_field(dofs_));
}

PlacedFormulas::Values PlacedFormulas::evaluate(const std::vector<Place>& places,
                                                const State& state) const {
  return each(places, state, [](const FormulaFields& formula, const FieldSampler& at) {
    return formula.value(at);
  });
}

std::vector<char> PlacedFormulas::inside(const std::vector<Place>& places,
                                         const State& state) const {
  return each(places, state, [](const FormulaFields&, const FieldSampler&) { return 0.0; }).inside;
}

template <class Evaluate>
PlacedFormulas::Values PlacedFormulas::each(const std::vector<Place>& places, const State& state,
                                            Evaluate&& evaluate) const {
  const Mesh& mesh = dofs_.mesh();
  const Region& body = mesh.body;
  locator_->move_to(state);
  constexpr GlobalIndex nowhere = std::numeric_limits<GlobalIndex>::max();
  std::vector<GlobalIndex> mine(places.size(), nowhere), cells(places.size());
  std::vector<CellLocator::Place> found(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    if (const auto place = locator_->find(places[i].data())) {
      found[i] = *place;
      mine[i] = body.cell_ids[static_cast<std::size_t>(place->cell)];
    }
  MPI_Allreduce(mine.data(), cells.data(), static_cast<int>(cells.size()), MPI_LONG_LONG, MPI_MIN,
                mesh.communicator.mpi());

  // The places of this rank's cells, as the points of one rule.
  std::vector<std::size_t> here;
  Quadrature points;
  points.shape = body.shape;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (mine[i] != nowhere && mine[i] == cells[i]) {
      here.push_back(i);
      points.locations.insert(points.locations.end(), found[i].xi, found[i].xi + body.dimension);
    }
  points.points = static_cast<int>(here.size());
  points.weights.assign(here.size(), 1);
  std::vector<double> sums(places.size() * formulas_.size(), 0), known(sums);
  mesh.communicator.together([&] {
    for (std::size_t f = 0; f < formulas_.size() && !here.empty(); ++f) {
      const FormulaFields& formula = formulas_[f];
      FieldSampler sampler(dofs_, body, points, formula.fields(), moving_field(dofs_));
      for (std::size_t q = 0; q < here.size(); ++q) {
        sampler.enter(found[here[q]].cell, state);
        sampler.go_to(static_cast<int>(q));
        bool lives = true;
        for (std::size_t k = 0; k < formula.fields().size(); ++k)
          lives = lives && sampler.lives_here(k);
        if (!lives) continue;
        sums[here[q] * formulas_.size() + f] = evaluate(formula, sampler);
        known[here[q] * formulas_.size() + f] = 1;
      }
    }
  });
  for (std::vector<double>* const all : {&sums, &known})
    MPI_Allreduce(MPI_IN_PLACE, all->data(), static_cast<int>(all->size()), MPI_DOUBLE, MPI_SUM,
                  mesh.communicator.mpi());
  Values result{std::vector<char>(places.size(), 1), std::move(sums)};
  for (std::size_t i = 0; i < known.size(); ++i)
    if (known[i] == 0) {
      result.inside[i / formulas_.size()] = 0;
      result.values[i] = std::numeric_limits<double>::quiet_NaN();
    }
  return result;
}

std::string PlacedFormulas::reach() const {
  const std::vector<double> box = locator_->box();
  const std::size_t dimension = box.size() / 2;
  return "the body reaches from " + place_text(box.data(), dimension) + " to " +
         place_text(box.data() + dimension, dimension) + " m";
}

std::string place_text(const double* place, std::size_t dimension) {
  std::string text = "(";
  for (std::size_t j = 0; j < dimension; ++j)
    text += (j == 0 ? "" : ", ") + write_value(place[j]);
  return text + ")";
}

}  // namespace hawser
