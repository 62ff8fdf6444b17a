// A bar is pulled longer and longer, in half of the steps by this run and in half by one that goes
// on from its checkpoint.
#include <cstdio>

#include "hawser/simulation/stepper.hpp"

const char* const deck = R"(<hawser title="Bar under a growing load">
  <parameter name="load" value="5000 N" unit="N"/>
  <mesh><line from="0 0" to="10 0" segments="10"/></mesh>
  <modules>
    <cable region="cable" mass-per-length="1" axial-stiffness="1e4">
      <point-load on="tail" force="load*t; 0"/>
    </cable>
  </modules>
  <conditions><prescribe field="displacement" on="tow-point" value="0 0"/></conditions>
  <time scheme="steady" step="0.25" end="1"/>
  <solver><linear method="mumps"/></solver>
  <output><probe name="tail" on="tail" field="displacement"/></output>
</hawser>)";

struct Steps : hawser::Observer {
  void attempted(hawser::Stepper& stepper, const hawser::Attempt& attempt) override {
    const auto tail = stepper.quantity("tail_displacement_x_m");
    if (attempt.accepted && stepper.run_case().communicator().is_root())
      std::printf("t = %g s: %d iterations, the tail has gone %.4f m\n", attempt.time,
                  attempt.newton.iterations, *tail);
  }
} steps;

void compute(const hawser::Environment& environment) {
  hawser::CaseOptions options;
  options.changes = {{"load", "9375 N"}};  // as --set; 10 m become 15 m
  hawser::Stepper stepper(hawser::Case::from_text(environment, deck, "bar.xml", options));
  stepper.observe(steps);
  while (stepper.time() < 0.5)
    stepper.advance();
  stepper.save("bar.h5");
  hawser::Stepper second(hawser::Case::from_checkpoint(environment, "bar.h5"));
  second.observe(steps);
  while (!second.finished())
    second.advance();
  const hawser::FieldValues moved = second.field("displacement");  // of this rank's nodes
  for (std::size_t i = 0; i < moved.ids.size(); ++i)
    std::printf("node %lld: X = %g m, x = %.4f m\n", moved.ids[i], moved.positions[2 * i],
                moved.positions[2 * i] + moved.values[2 * i]);
}

int main() {
  hawser::Environment
      environment;  // starts MPI and Kokkos; Environment(comm) adopts a communicator
  return environment.guarded([&] { return compute(environment), 0; });
}
