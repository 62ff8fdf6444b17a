#pragma once
// A taut string that swings: a mesh of ten lines, a mode exact enough to see a wrong step.
#include "hawser/simulation/stepper.hpp"

namespace hawser {

inline const char* const sample_deck = R"deck(<hawser title="String">
  <parameter name="amplitude" value="0.005 m"/>
  <mesh>
    <line from="0 0" to="10 0" segments="10"/>
  </mesh>
  <modules>
    <cable region="cable" mass-per-length="2" axial-stiffness="1e6"/>
  </modules>
  <conditions>
    <initial name="shape" field="displacement" on="cable" value="0.005*X; amplitude*sin(pi*X/10)"/>
    <prescribe name="left" field="displacement" on="tow-point" value="0 0"/>
    <prescribe name="right" field="displacement" on="tail" value="0.05 0"/>
  </conditions>
  <time scheme="newmark" beta="0.25" gamma="0.5" step="0.01" end="0.06"/>
  <solver>
    <linear method="mumps"/>
  </solver>
  <output>
    <probe name="middle" on="middle" field="displacement"/>
  </output>
</hawser>)deck";

inline void step_to_the_end(Stepper& stepper) {
  while (!stepper.finished())
    stepper.advance();
}

}  // namespace hawser
