#include "hawser/simulation/deck_parameters.hpp"

#include <algorithm>
#include <cctype>

namespace hawser {
namespace {

void copy(const std::vector<double>& from, double* to) { std::copy(from.begin(), from.end(), to); }

Rules flow_directions() { return one_of({"-y", "+y", "-x", "+x"}); }

Spec<LinearOptions> linear_spec() {
  using P = LinearOptions;
  return Spec<P>("linear", "Solver of the linear equations in each Newton iteration.")
      .choice("method", &P::method, {{"gmres", P::Method::gmres}, {"mumps", P::Method::mumps}},
              "GMRES preconditioned by overlapping Schwarz with an incomplete factor, or by MUMPS' "
              "complete one.")
      .attribute("tolerance", &P::tolerance, "1", between(1e-14, 0.5),
                 "Of the row-scaled residual, relative to the right-hand side.")
      .attribute("restart", &P::restart, at_least(1), "GMRES vectors kept before a restart.")
      .attribute("max-iterations", &P::max_iterations, at_least(1),
                 "GMRES iterations before it counts as failed.")
      .attribute("fill-level", &P::fill_level, between(0, 10),
                 "Fill level of the incomplete factor.")
      .attribute("overlap", &P::overlap, between(0, 10),
                 "Schwarz overlap between ranks, in layers.")
      .attribute("keep-factor", &P::keep_factor,
                 "Keep a factor for later matrices until it costs too many iterations.")
      .attribute("refresh-ratio", &P::refresh_ratio, "1", at_least(1),
                 "A kept factor is renewed beyond this multiple of its first iteration count ...")
      .attribute("refresh-slack", &P::refresh_slack, at_least(0), "... plus this many.")
      .attribute("repeatable", &P::repeatable,
                 "MUMPS on one rank, the same to the last bit each time; else on all ranks.");
}

Spec<NonlinearOptions> newton_spec() {
  using P = NonlinearOptions;
  return Spec<P>("newton", "Newton's method.")
      .source("doc/numerics.md, doc/decisions/0003-convergence-norm.md")
      .attribute("tolerance", &P::tolerance, "1", between(1e-15, 1e-1),
                 "Largest residual of a block relative to the contributions that cancel in it.")
      .attribute("max-iterations", &P::max_iterations, at_least(1),
                 "Iterations before a step is rejected.")
      .attribute("line-search", &P::line_search,
                 "Halve an update that is not admissible or explodes.")
      .attribute("divergence", &P::divergence, "1", greater_than(1),
                 "Growth of the residual against the first one that ends the solve. Without line "
                 "search a stiff, slender cable passes through large ones.")
      .attribute("lagged", &P::lagged,
                 "First iterate with the Jacobian of an earlier step, Anderson-accelerated.")
      .attribute("forcing", &P::forcing,
                 "Looser linear solves far from the solution (Eisenstat-Walker).")
      .attribute("forcing-max", &P::forcing_max, "1", between(1e-12, 0.9),
                 "Loosest linear tolerance with forcing.");
}

Spec<StepTargets> adapt_spec() {
  using P = StepTargets;
  return Spec<P>("adapt",
                 "Steers the length of the steps; the same run twice takes the same steps.")
      .attribute(
          "error", &P::error, "1", between(0, 0.1),
          "Wanted local error of a step, relative to the field, of the fields with a dynamic "
          "rate; a step with more is repeated. 0 for no look at it.")
      .attribute("newton-iterations", &P::newton_iterations, between(0, 50),
                 "Wanted Newton iterations per step; 0 for no look at them.")
      .attribute("longest-step", &P::longest, "s", non_negative(),
                 "No step is longer; 0 for no such limit.")
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        if (p.error == 0 && p.newton_iterations == 0)
          diagnostics.error(where, "<adapt> needs error or newton-iterations, or both");
      });
}

Spec<ConditionDeck> condition_spec(const std::string& tag, const std::string& meaning) {
  using P = ConditionDeck;
  return Spec<P>(tag, meaning)
      .attribute("name", &P::name, absent("it has none"),
                 "By which another deck or --set can change it.")
      .attribute("field", &P::field, required(), "Field by name, such as velocity.")
      .attribute("on", &P::on, required(), "Regions, by name.")
      .attribute("component", &P::component, one_of({"all", "x", "y", "z"}),
                 "Which component the value is for.")
      .attribute("value", &P::value, "SI", any() && absent("table or track says it"),
                 "A number or expression per component, of x y z (moved), X Y Z (reference), t.")
      .attribute(
          "table", &P::table, absent("no table"),
          "CSV file of columns t, x, y and a column per component; linear between its rows. A "
          "relative path starts at the deck's folder.")
      .attribute("track", &P::track, absent("no track"), "The displacement along this <track>.")
      .check([tag](const P& p, const Location& where, Diagnostics& diagnostics) {
        if (int(p.value.has_value()) + int(p.table.has_value()) + int(p.track.has_value()) != 1)
          diagnostics.error(where, "<" + tag + "> needs exactly one of value, table and track");
      });
}

}  // namespace

Spec<TowBoxDeck> TowBoxDeck::spec() {
  using P = TowBoxDeck;
  return Spec<P>("tow-box", "A box of water with a straight cable in it.")
      .attribute("min", &P::min, "m", required() && any() && length(2), "Lower left corner.")
      .attribute("max", &P::max, "m", required() && any() && length(2), "Upper right corner.")
      .attribute("tow-point", &P::tow_point, "m", any() && length(2), "Where the cable starts.")
      .attribute("tail", &P::tail, "m", required() && any() && length(2), "Where the cable ends.")
      .attribute("cable-size", &P::cable_size, "m", positive(), "Segment length on the cable.")
      .attribute("far-size", &P::far_size, "m", positive(), "Largest cell size.")
      .attribute("growth", &P::growth, "1", positive(),
                 "Growth of the cell size per distance from the cable.")
      .attribute("end-size", &P::end_size, "m", non_negative(),
                 "Segment length at the cable's ends; 0 for the same as on the cable.")
      .attribute("flow-direction", &P::flow_direction, flow_directions(),
                 "Which boundary is the outflow.")
      .attribute("refinements", &P::refinements, between(0, 10),
                 "How often every triangle of the mesh so described is cut into four.");
}

TowBox TowBoxDeck::box() const {
  TowBox box;
  box.x_min = min[0], box.y_min = min[1], box.x_max = max[0], box.y_max = max[1];
  copy(tow_point, box.tow_point);
  copy(tail, box.tail);
  box.cable_size = cable_size, box.far_size = far_size, box.growth = growth,
  box.end_size = end_size;
  box.flow_direction = flow_direction;
  box.refinements = refinements;
  return box;
}

Spec<WaterBoxDeck> WaterBoxDeck::spec() {
  using P = WaterBoxDeck;
  return Spec<P>("water-box", "A box of water alone.")
      .attribute("min", &P::min, "m", required() && any() && length(2), "Lower left corner.")
      .attribute("max", &P::max, "m", required() && any() && length(2), "Upper right corner.")
      .attribute("size", &P::size, "m", non_negative(), "Cell size of an unstructured mesh.")
      .attribute("cells", &P::cells, "1", length(2) && non_negative(),
                 "Cells in x and y of a structured mesh; 0 0 for an unstructured one.")
      .attribute("flow-direction", &P::flow_direction, flow_directions(),
                 "Which boundary is the outflow.")
      .attribute("refinements", &P::refinements, between(0, 10),
                 "How often every triangle of the mesh so described is cut into four.")
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        if ((p.size > 0) == (p.cells[0] > 0 && p.cells[1] > 0))
          diagnostics.error(where, "<water-box> needs either size or cells, and not both");
      });
}

WaterBox WaterBoxDeck::box() const {
  WaterBox box;
  box.x_min = min[0], box.y_min = min[1], box.x_max = max[0], box.y_max = max[1];
  box.size = size;
  box.cells[0] = static_cast<int>(cells[0]), box.cells[1] = static_cast<int>(cells[1]);
  box.flow_direction = flow_direction;
  box.refinements = refinements;
  return box;
}

Spec<MeshFileDeck> MeshFileDeck::spec() {
  return Spec<MeshFileDeck>("file", "A mesh file made by gmsh.")
      .attribute("name", &MeshFileDeck::name, required(),
                 "MSH 2.2 or 4.1, ASCII; a relative path starts at the deck's folder.")
      .attribute("dimension", &MeshFileDeck::dimension, between(2, 3),
                 "Of the space; in three the file may hold lines and points only.");
}

Spec<MeshDeck> MeshDeck::spec() {
  using P = MeshDeck;
  return Spec<P>("mesh", "Where the mesh comes from: exactly one of the children.")
      .attribute("slits", &P::slits, absent("none"),
                 "Line regions across which the pressure is doubled.")
      .child(&P::tow_box)
      .child(&P::water_box)
      .child(&P::line)
      .child(&P::file)
      .location(&P::location)
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        if (int(p.tow_box.has_value()) + int(p.water_box.has_value()) + int(p.line.has_value()) +
                int(p.file.has_value()) !=
            1)
          diagnostics.error(
              where, "<mesh> needs exactly one of <tow-box>, <water-box>, <line> and <file>");
      });
}

Spec<ParameterDeck> ParameterDeck::spec() {
  using P = ParameterDeck;
  return Spec<P>("parameter", "A value with a name, for use in numbers and formulas of the deck.")
      .attribute("name", &P::name, required(), "Letters, digits and _, such as tow_speed.")
      .attribute("value", &P::value, required(),
                 "A number, a number with its unit, or a formula of earlier parameters.")
      .attribute("unit", &P::unit, absent("SI, unless the value has its own"),
                 "Of a bare number as value; also the dimension of any other.")
      .attribute("meaning", &P::meaning, absent("none"), "What it is, for the reader.");
}

Spec<PluginDeck> PluginDeck::spec() {
  return Spec<PluginDeck>("plugin", "A shared library with further physics modules.")
      .attribute("name", &PluginDeck::name, required(), "Its name, without folder and ending.");
}

Spec<ModulesDeck> ModulesDeck::spec() {
  return Spec<ModulesDeck>("modules", "The physics.")
      .any_children(&ModulesDeck::modules, "physics modules");
}

Spec<ConditionDeck> ConditionDeck::initial_spec() {
  return condition_spec("initial",
                        "A field's values at the start; later ones replace earlier ones.");
}
Spec<ConditionDeck> ConditionDeck::prescribe_spec() {
  using P = ConditionDeck;
  return condition_spec("prescribe",
                        "A field's values on a region, at all times or within a window.")
      .attribute("from", &P::from, "s", any() && absent("from the start"),
                 "Holds for steps that end after this time.")
      .attribute("until", &P::until, "s", any() && absent("to the end"),
                 "Holds for steps that end at this time or before.");
}

Spec<ConditionsDeck> ConditionsDeck::spec() {
  using P = ConditionsDeck;
  return Spec<P>("conditions", "Initial and prescribed values.")
      .children(&P::initial, ConditionDeck::initial_spec())
      .children(&P::prescribe, ConditionDeck::prescribe_spec());
}

TimeScheme TimeDeck::scheme() const {
  TimeScheme result;
  result.method = method;
  result.beta = beta.value_or(result.beta);
  result.gamma = gamma.value_or(result.gamma);
  result.rho_infinity = rho_infinity.value_or(result.rho_infinity);
  result.euler_start = euler_start;
  return result;
}

Spec<TimeDeck> TimeDeck::spec() {
  using P = TimeDeck;
  using Method = TimeScheme::Method;
  return Spec<P>("time", "Time stepping.")
      .source("doc/numerics.md")
      .choice("scheme", &P::method,
              {{"newmark", Method::newmark},
               {"generalised-alpha", Method::generalised_alpha},
               {"steady", Method::steady}},
              "Newmark's method, generalised-alpha, or solves without rates: one at `end`, or, "
              "where `step` is shorter, one per step, in which loads may grow with t.")
      .attribute("beta", &P::beta, "1", between(0.25, 1) && absent("0.3025"), "Newmark's beta.")
      .attribute("gamma", &P::gamma, "1", between(0.5, 1) && absent("0.6"),
                 "Newmark's gamma. More than 0.5 damps and is first order; 0.5 "
                 "is second "
                 "order, but lets accelerations and forces ring after any kink in time.")
      .attribute("rho-infinity", &P::rho_infinity, "1", between(0, 1) && absent("0.5"),
                 "What generalised-alpha leaves of the fastest motions per step: 0 damps most, 1 "
                 "nothing.")
      .choice("start", &P::euler_start, {{"implicit-euler", true}, {"initial-rates", false}},
              "How the first step is made: by implicit Euler, which asks for no initial rates, or "
              "by the scheme with the rates of the initial values' expressions (0 for constants).")
      .attribute("step", &P::step, "s", positive(),
                 "Length of a step; of the first one with <adapt>.")
      .attribute("least-step", &P::least, "s", non_negative(),
                 "A rejected step is halved down to this length; 0 for a thousandth of the step.")
      .attribute("end", &P::end, "s", positive(), "Time at which the run ends.")
      .attribute("grow-after", &P::grow_after, at_least(1),
                 "Accepted steps in a row after which a cut step is doubled again.")
      .child(&P::targets, adapt_spec())
      .location(&P::location)
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        const TimeScheme scheme = p.scheme();
        if (p.method != Method::newmark && (p.beta || p.gamma))
          diagnostics.error(where, "beta and gamma belong to scheme=\"newmark\"");
        if (p.method != Method::generalised_alpha && p.rho_infinity)
          diagnostics.error(where, "rho-infinity belongs to scheme=\"generalised-alpha\"");
        if (p.steady() && p.targets)
          diagnostics.error(where, "a steady solve has no steps that <adapt> could steer");
        if (2 * scheme.beta < scheme.gamma)
          diagnostics.error(where, "beta is " + write_value(scheme.beta) + " and gamma " +
                                       write_value(scheme.gamma) +
                                       ": Newmark's method is unstable; beta must be at least "
                                       "gamma/2");
        if (p.least > p.step)
          diagnostics.error(where, "least-step is " + write_value(p.least) +
                                       " s, longer than the step of " + write_value(p.step) + " s");
      });
}

Spec<SolverDeck> SolverDeck::spec() {
  return Spec<SolverDeck>("solver", "How the equations are solved.")
      .child(&SolverDeck::linear, linear_spec())
      .child(&SolverDeck::newton, newton_spec());
}

Spec<TowDeck> TowDeck::spec() {
  using P = TowDeck;
  return Spec<P>("tow",
                 "Reports the positioning errors of a towed cable and the force at its tow point.")
      .attribute("cable", &P::cable, required(), "Line region of the cable.")
      .attribute("tow-point", &P::tow_point, required(), "Point region where it is towed.")
      .attribute("angle", &P::angle, "deg", between(-180, 180),
                 "Of the tow axis from upstream (+y) toward +x.")
      .attribute("speed", &P::speed, "m/s", non_negative(),
                 "Of the tow, for the exact straight-cable values.")
      .attribute("current", &P::current, "m/s", non_negative(), "Of the water along -y, likewise.")
      .attribute("track", &P::track, absent("straight on"),
                 "The <track> that is towed along: the tow axis is its present course, instead of "
                 "angle and speed.")
      .child(&P::receivers);
}

Spec<ReceiversDeck> ReceiversDeck::spec() {
  using P = ReceiversDeck;
  return Spec<P>("receivers", "Writes receivers.csv: where each receiver of the cable is.")
      .attribute("spacing", &P::spacing, "m", positive(), "Between receivers, unstretched.")
      .attribute("first", &P::first, "m", non_negative(),
                 "From the tow point to the first receiver, unstretched.")
      .attribute("times", &P::times, "s", non_negative() && absent("at none"),
                 "When; between two steps the positions are interpolated.")
      .attribute("every", &P::every, at_least(0),
                 "Steps between further entries; 0 for none. With neither, at the end.");
}

namespace {

/// It becomes part of a table's columns and of the names in summary.json.
template <class P>
void check_column_name(const P& p, const Location& where, Diagnostics& diagnostics) {
  const bool fits = std::all_of(p.name.begin(), p.name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
  if (!fits)
    diagnostics.error(where, "the name '" + p.name +
                                 "' becomes a column of history.csv; letters, digits, _ and - are "
                                 "allowed");
}

}  // namespace

Spec<ForceDeck> ForceDeck::spec() {
  using P = ForceDeck;
  return Spec<P>("force",
                 "Reports the force on a region: of one module, or the support's reaction.")
      .attribute("name", &P::name, required(), "Start of the quantities' names.")
      .attribute("on", &P::on, required(), "Region whose velocity rows are summed.")
      .attribute("module", &P::module,
                 "Module whose load on the region is reported; all for the reaction.")
      .attribute("axis", &P::axis, "1", any() && length(2, 3) && absent("+x"),
                 "Direction of the component called along; across is 90 degrees left, in "
                 "space the magnitude of the rest.")
      .check(check_column_name<P>);
}

Spec<ProbeDeck> ProbeDeck::spec() {
  using P = ProbeDeck;
  return Spec<P>("probe", "Writes a field at one point over time.")
      .attribute("name", &P::name, required(), "Column name and start of the quantities' names.")
      .attribute("on", &P::on, required(), "Point region.")
      .attribute("field", &P::field, required(), "Field by name.")
      .check(check_column_name<P>);
}

Spec<OutputDeck> OutputDeck::spec() {
  using P = OutputDeck;
  return Spec<P>("output", "What is written, and how often.")
      .attribute("fields-every", &P::fields_every, at_least(0),
                 "Steps between outputs of the fields; 0 for the end only.")
      .attribute("history-every", &P::history_every, at_least(1),
                 "Steps between rows of the histories.")
      .attribute("checkpoint-every", &P::checkpoint_every, at_least(0),
                 "Steps between checkpoints; 0 for none.")
      .children(&P::probes);
}

Spec<ExpectDeck> ExpectDeck::spec() {
  using P = ExpectDeck;
  return Spec<P>("expect", "A reported quantity that must come out; otherwise the exit code is 8.")
      .attribute("quantity", &P::quantity, required(), "Name in summary.json.")
      .attribute("value", &P::value, "as the quantity", required() && any(), "What is expected.")
      .attribute("within", &P::within, "as the quantity", required() && non_negative(),
                 "Allowed difference.")
      .attribute("why", &P::why, required(), "Where the value comes from.");
}

Spec<RunDeck> RunDeck::spec() {
  using P = RunDeck;
  return Spec<P>("hawser", "One simulation.")
      .attribute("title", &P::title, absent("none"), "What this run is.")
      .attribute("extends", &P::extends, absent("it stands for itself"),
                 "Another deck, of which this one says what differs.")
      .children(&P::parameters)
      .child(&P::mesh, required())
      .children(&P::plugins)
      .child(&P::modules, required())
      .children(&P::tracks)
      .child(&P::conditions)
      .child(&P::time, required())
      .child(&P::solver)
      .child(&P::output)
      .child(&P::tow)
      .children(&P::forces)
      .children(&P::expectations)
      .children(&P::errors)
      .child(&P::converge);
}

}  // namespace hawser
