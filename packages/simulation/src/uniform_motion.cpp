#include "src/uniform_motion.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/physics/vector_parameters.hpp"

namespace hawser {
namespace {

constexpr auto for_lines_alone =
    "uniform motion is for a mesh of lines alone, without water around them";

}  // namespace

void check_uniform_motion(const RunDeck& deck, Diagnostics& diagnostics) {
  if (!deck.start.equilibrium || deck.start.equilibrium->velocity->empty()) return;
  const auto& velocity = deck.start.equilibrium->velocity;
  check_components(velocity, "velocity", deck.mesh.dimension(), diagnostics);
  if (deck.time.steady())
    diagnostics.error(velocity.location,
                      "a run with scheme=\"steady\" has no motion to start from; let the water "
                      "come instead, with the current less this velocity");
  if (deck.mesh.tow_box || deck.mesh.water_box)
    diagnostics.error(velocity.location, for_lines_alone);
}

std::array<double, 3> drift_of_start(const System& system, const RunDeck& deck) {
  const auto& velocity = deck.start.equilibrium->velocity;
  std::array<double, 3> drift{};
  if (velocity->empty()) return drift;
  if (system.mesh.has_body()) throw DeckError(velocity.location.text() + ": " + for_lines_alone);
  std::copy(velocity->begin(), velocity->end(), drift.begin());
  State start = system.problem->state();
  start.step = deck.time.step;  // it moves
  const DofMap& dofs = *system.dofs;
  std::vector<char> is_of_structure(static_cast<std::size_t>(dofs.rows()), 0);
  for (const auto& pair : system.assembler->kinematic_pairs())
    is_of_structure[static_cast<std::size_t>(pair.velocity)] = 1;
  double worst = 0, size = 0;
  for (const double component : drift)
    size = std::max(size, std::abs(component));
  for (const PrescribedRow& row : system.conditions->prescribed(start, start))
    if (is_of_structure[static_cast<std::size_t>(row.row)] != 0)
      worst = std::max(
          worst,
          std::abs(row.value - drift[static_cast<std::size_t>(dofs.info(row.row).component)]));
  worst = system.mesh.communicator.max(worst);
  if (worst > 1e-6 * size)
    throw DeckError(velocity.location.text() +
                    ": at t = " + write_value(system.integrator->history().time) +
                    " s a node is prescribed to move otherwise, by " + write_value(worst) +
                    " m/s, and in uniform motion all moves alike; a <track> without a ramp, or a "
                    "prescribed displacement of velocity * t, does");
  return drift;
}

}  // namespace hawser
