// Cables alone, in the plane and in space, against exact answers.
#include <Teuchos_LAPACK.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "deck_run.hpp"
#include "figure.hpp"
#include "hawser/base/constants.hpp"

namespace hawser {
namespace {

std::string in(int dimension) { return dimension == 3 ? " in space" : " in the plane"; }
std::string tag(int dimension) { return dimension == 3 ? ".space" : ".plane"; }

/// "a" in the plane, "a; 0" or what else is given in space: the components of a deck's vector.
std::string vector(int dimension, const std::string& in_plane, const std::string& third = "0") {
  return dimension == 3 ? in_plane + "; " + third : in_plane;
}

/// What the assembler's matrix says about the small free motion about the present state: stiffness
/// d(force)/d(displacement) and mass d(force)/d(acceleration), between all nodes' components that
/// are not on a fixed region.
class FreeMotion {
 public:
  FreeMotion(DeckRun& run, const std::vector<std::string>& fixed) : run_(run) {
    const DofMap& dofs = run.dofs();
    const int displacement = dofs.find("displacement");
    std::vector<char> free(static_cast<std::size_t>(dofs.owned()), 1);
    for (const std::string& name : fixed)
      for (const LocalIndex row : dofs.region_rows(displacement, dofs.mesh().region(name)))
        for (int c = 0; c < dofs.mesh().dimension; ++c)
          free[static_cast<std::size_t>(row + c)] = 0;
    for (const auto& pair : run.system().assembler->kinematic_pairs())
      if (free[static_cast<std::size_t>(pair.displacement)] != 0) pairs_.push_back(pair);
  }

  /// rad/s, ascending.
  std::vector<double> frequencies() {
    std::vector<double> stiffness = entries(0, true), mass = entries(1, false);
    const std::vector<double> still = entries(0, false);  // damping and the like
    for (std::size_t i = 0; i < mass.size(); ++i)
      mass[i] -= still[i];
    const int n = static_cast<int>(pairs_.size());
    std::vector<double> squares(pairs_.size()), work(pairs_.size() * 8);
    int info = -1;
    Teuchos::LAPACK<int, double>().SYGV(1, 'N', 'L', n, stiffness.data(), n, mass.data(), n,
                                        squares.data(), work.data(), static_cast<int>(work.size()),
                                        &info);
    EXPECT_EQ(info, 0);
    for (double& value : squares)
      value = std::sqrt(value);
    return squares;
  }

 private:
  /// [column][row] of the momentum rows; columns are the displacements or the velocities, whose
  /// rates follow them by `slope`.
  std::vector<double> entries(double slope, bool of_displacement) {
    Assembler& assembler = *run_.system().assembler;
    State state = run_.state();
    for (std::size_t row = 0; row < state.rate_slope.size(); ++row)
      state.rate_slope[row] = slope;
    assembler.tangent(state);
    std::vector<double> result;
    for (const auto& column : pairs_)
      for (const auto& row : pairs_)
        result.push_back(
            entry(row.velocity, of_displacement ? column.displacement : column.velocity));
    return result;
  }
  double entry(LocalIndex row, LocalIndex column) {
    Assembler& assembler = *run_.system().assembler;
    const LocalIndex* const begin = assembler.row_columns(row);
    const LocalIndex* const end = begin + assembler.row_size(row);
    const LocalIndex* const found = std::lower_bound(begin, end, column);
    return found != end && *found == column ? assembler.row_values(row)[found - begin] : 0;
  }

  DeckRun& run_;
  std::vector<Assembler::KinematicPair> pairs_;
};

/// Solved for its place at rest.
std::string resting_deck(int dimension, const std::string& end, int segments,
                         const std::string& cable, const std::string& conditions) {
  return "<hawser><mesh><line from=\"" + vector(dimension, "0; 0") + "\" to=\"" + end +
         "\" segments=\"" + std::to_string(segments) + "\"/></mesh><modules>" + cable +
         "</modules><conditions><prescribe field=\"displacement\" on=\"tow-point\" value=\"" +
         vector(dimension, "0; 0") + "\"/>" + conditions +
         R"(</conditions><time scheme="steady" end="1"/>
         <solver><linear method="mumps" tolerance="1e-8"/><newton tolerance="1e-9"/></solver>
         </hawser>)";
}

class InDimension : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Structures, InDimension, testing::Values(2, 3));

// Half the zeros of the Bessel function J0 (Daniel Bernoulli, 1738).
TEST_P(InDimension, HangingChainSwingsAtItsThreeLowestFrequencies) {
  const int D = GetParam();
  DeckRun run(resting_deck(D, D == 3 ? "0; 0; -10" : "0; -10", 100,
                           "<cable region=\"cable\" mass-per-length=\"2\" axial-stiffness=\"1e6\" "
                           "gravity=\"" +
                               std::string(D == 3 ? "0 0 -9.81" : "0 -9.81") + "\"/>",
                           ""));
  run.step();
  const std::vector<double> omega = FreeMotion(run, {"tow-point"}).frequencies();
  const double exact[] = {1.2024, 2.7600, 4.3270};
  for (std::size_t mode = 0; mode < 3; ++mode)
    for (int direction = 0; direction < D - 1; ++direction)  // in space each mode has two
      record({"structures.chain." + std::to_string(mode + 1) + tag(D) +
                  (direction == 1 ? ".across" : ""),
              "Structures",
              "hanging chain" + in(D) + ", omega sqrt(L/g) of mode " + std::to_string(mode + 1),
              "1",
              omega[mode * static_cast<std::size_t>(D - 1) + static_cast<std::size_t>(direction)] *
                  std::sqrt(10 / 9.81),
              exact[mode], 0.005 * exact[mode], "half the zeros of J0, 0.5 %"});
}

TEST_P(InDimension, TautStringSwingsAtItsFundamentalFrequency) {
  const int D = GetParam();
  const double strain = 0.005, stiffness = 1e6, mass = 2, length = 10;
  DeckRun run(resting_deck(
      D, vector(D, "10; 0"), 40,
      R"(<cable region="cable" mass-per-length="2" axial-stiffness="1e6"/>)",
      "<prescribe field=\"displacement\" on=\"tail\" value=\"" + vector(D, "0.05; 0") + "\"/>"));
  run.step();
  const std::vector<double> omega = FreeMotion(run, {"tow-point", "tail"}).frequencies();
  // Second Piola tension, mass and length all belong to the unstretched string.
  const double tension = stiffness * (strain + strain * strain / 2);
  const double exact = std::sqrt(tension / mass) / (2 * length);
  for (int direction = 0; direction < D - 1; ++direction)
    record({"structures.string" + tag(D) + (direction == 1 ? ".across" : ""), "Structures",
            "taut string" + in(D) + ", frequency", "Hz",
            omega[static_cast<std::size_t>(direction)] / (2 * pi), exact, 0.005 * exact,
            "sqrt(T/m)/(2 L), 0.5 %"});
}

TEST_P(InDimension, BarUnderDeadLoadFollowsGreenLagrangeStrain) {
  const int D = GetParam();
  const double load = 7e3, stiffness = 1e4;
  DeckRun run(
      resting_deck(D, vector(D, "10; 0"), 10,
                   "<cable region=\"cable\" axial-stiffness=\"1e4\"><point-load on=\"tail\" "
                   "force=\"" +
                       vector(D, "7e3; 0") + "\"/></cable>",
                   ""));
  run.step();
  double stretch = 0;
  run.visit_nodes("displacement", "tail",
                  [&](LocalIndex, const double*, const double* d) { stretch = 1 + d[0] / 10; });
  record({"structures.bar" + tag(D), "Structures",
          "bar under a dead load" + in(D) + ", lambda^3 - lambda", "1",
          stretch * stretch * stretch - stretch, 2 * load / stiffness, 1e-8, "2 P/EA, to 1e-8"});
}

/// Cantilever of length 1 and stiffness 1 under a dead end load P across: place of the end, by
/// elliptic integrals (Bisshopp and Drucker, Q. Appl. Math. 3 (1945) 272).
struct Elastica {
  double x, y;
  explicit Elastica(double load) {
    const auto modulus = [](double angle) { return std::sqrt((1 + std::sin(angle)) / 2); };
    const auto start = [&](double k) { return std::asin(1 / (k * std::sqrt(2.0))); };
    double low = 0, high = pi / 2;  // the end's angle, by bisection
    for (int i = 0; i < 100; ++i) {
      const double k = modulus((low + high) / 2);
      (std::comp_ellint_1(k) - std::ellint_1(k, start(k)) < std::sqrt(load) ? low : high) =
          (low + high) / 2;
    }
    const double k = modulus(low);
    x = std::sqrt(2 * std::sin(low) / load);
    y = 1 - 2 / std::sqrt(load) * (std::comp_ellint_2(k) - std::ellint_2(k, start(k)));
  }
};

std::string beam(int dimension, const std::string& attributes, const std::string& load_point,
                 double load) {
  return "<cable region=\"cable\" axial-stiffness=\"1e7\" bending-stiffness=\"1e4\" "
         "compressive-ratio=\"1\" " +
         attributes + "><point-load on=\"" + load_point + "\" force=\"" +
         vector(dimension, dimension == 3 ? "0; 0" : "0; -t*" + std::to_string(load),
                "-t*" + std::to_string(load)) +
         "\"/></cable>";
}

TEST_P(InDimension, ClampedBeamIsTheElastica) {
  const int D = GetParam();
  DeckRun run(
      resting_deck(D, vector(D, "10; 0"), 40, beam(D, "clamped=\"tow-point\"", "tail", 500), ""));
  for (int n = 0; n < 10; ++n)
    run.step(0.1);
  const Elastica exact(5);  // P L^2/EI
  run.visit_nodes("displacement", "tail", [&](LocalIndex, const double* X, const double* d) {
    record({"structures.cantilever.x" + tag(D), "Structures",
            "cantilever" + in(D) + ", P L^2/EI = 5, 40 segments: x of the end over L", "1",
            (X[0] + d[0]) / 10, exact.x, 0.005 * exact.x, "elastica, elliptic integrals, 0.5 %"});
    record({"structures.cantilever.y" + tag(D), "Structures",
            "cantilever" + in(D) + ", P L^2/EI = 5, 40 segments: deflection of the end over L", "1",
            -d[D - 1] / 10, exact.y, 0.005 * exact.y, "elastica, elliptic integrals, 0.5 %"});
  });
}

TEST_P(InDimension, HingedBeamIsTwoHalvesOfTheElastica) {
  const int D = GetParam();
  std::string roller =
      "<prescribe field=\"displacement\" on=\"tail\" component=\"y\" value=\"0\"/>";
  if (D == 3)
    roller += "<prescribe field=\"displacement\" on=\"tail\" component=\"z\" value=\"0\"/>";
  DeckRun run(resting_deck(D, vector(D, "10; 0"), 40, beam(D, "", "middle", 1600), roller));
  for (int n = 0; n < 10; ++n)
    run.step(0.1);
  const Elastica exact(2);  // half the load on half the length: 800 * 5^2/1e4
  run.visit_nodes("displacement", "middle", [&](LocalIndex, const double*, const double* d) {
    record({"structures.hinged" + tag(D), "Structures",
            "beam on two hinges" + in(D) + ", 40 segments: deflection over half the length", "1",
            -d[D - 1] / 5, exact.y, 0.005 * exact.y, "elastica, elliptic integrals, 0.5 %"});
  });
}

TEST_P(InDimension, TensionOfAnAlignedCableIsLinear) {
  const int D = GetParam();
  const std::string zero = vector(D, "0; 0");
  DeckRun run("<hawser><mesh><line from=\"" + zero + "\" to=\"" + vector(D, "0; -420") +
              "\" segments=\"42\"/></mesh><modules>"
              "<cable region=\"cable\" mass-per-length=\"2.9\" axial-stiffness=\"1e7\">"
              "<drag diameter=\"0.06\" current=\"" +
              vector(D, "0; -0.7") +
              "\"/></cable></modules><conditions>"
              "<prescribe field=\"displacement\" on=\"tow-point\" value=\"" +
              zero + R"("/></conditions><time step="20" end="1"/>
              <solver><linear method="mumps" tolerance="1e-8"/>
              <newton tolerance="1e-8" line-search="false" max-iterations="40" divergence="1e14"/></solver></hawser>)");
  for (int n = 0; n < 100; ++n)
    run.step();
  const double friction = 0.5 * 1025 * 0.01 * pi * 0.06 * 0.7 * 0.7;  // N/m
  const Region& cable = run.dofs().mesh().region("cable");
  const auto tension = run.system().assembler->cell_quantities(cable, run.state()).front().values;
  double worst = 0;
  for (LocalIndex cell = 0; cell < cable.size(); ++cell) {
    const std::size_t c = static_cast<std::size_t>(cell);
    double arc = 0;
    for (const std::size_t k : {2 * c, 2 * c + 1})
      arc -=
          0.5 * run.dofs().mesh().coordinates[static_cast<std::size_t>(cable.vertices[k] * D + 1)];
    worst = std::max(worst, std::abs(tension[c] / (friction * (420 - arc)) - 1));
  }
  record({"structures.aligned" + tag(D), "Structures",
          "cable along the current" + in(D) +
              ": tension against rho Ct pi D W^2 (L - s)/2, worst segment, relative",
          "1", worst, 0, 1e-3, "friction on what is downstream, 0.1 %"});
}

}  // namespace
}  // namespace hawser
