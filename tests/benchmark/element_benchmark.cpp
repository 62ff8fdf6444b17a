// Cost of one stabilised P1/P1 triangle of the flow, without insertion: residual alone, and
// residual with the exact 15 x 15 tangent.
//   build/tests/bin/element_benchmark
#include <Kokkos_Core.hpp>
#include <benchmark/benchmark.h>

#include <vector>

#include "fluid_kernel.hpp"

namespace hawser {
namespace {

struct Triangle {
  FluidKernel<2> kernel{
      "water", {std::vector<double>{1000}, std::vector<double>{300}, std::nullopt, std::nullopt}};
  std::vector<double> coordinates = {0, 0, 20, 1, 8, 18};
  std::vector<double> velocity = {0.1, -0.5, 0.2, -0.4, 0.0, -0.45};
  std::vector<double> pressure = {10, 20, -5};
  std::vector<double> displacement = {1, 0.5, 1.2, 0.4, 0.9, 0.7};
  std::vector<double> zero = std::vector<double>(6, 0.0);
  std::vector<double> slope = std::vector<double>(6, 0.1);
  std::vector<FieldOnCell> fields;
  CellInput cell;

  Triangle() {
    kernel.bind(
        tabulate_cell({Basis::p1, Basis::p1, Basis::p1}, quadrature(CellShape::triangle, 2)));
    for (const auto* values : {&velocity, &pressure, &displacement})
      fields.push_back({values->data(), zero.data(), zero.data(), slope.data(), zero.data()});
    cell.step = 20;
    cell.coordinates = coordinates.data();
    cell.fields = fields.data();
  }
};

void residual(benchmark::State& state) {
  const Triangle triangle;
  double result[15];
  for (auto _ : state) {
    triangle.kernel.residual(triangle.cell, result);
    benchmark::DoNotOptimize(result);
  }
}
BENCHMARK(residual);

void residual_and_tangent(benchmark::State& state) {
  const Triangle triangle;
  double result[15];
  double tangent[15 * 15];
  for (auto _ : state) {
    triangle.kernel.tangent(triangle.cell, result, tangent);
    benchmark::DoNotOptimize(tangent);
  }
}
BENCHMARK(residual_and_tangent);

}  // namespace
}  // namespace hawser

int main(int argc, char** argv) {
  const Kokkos::ScopeGuard kokkos;  // tabulate() computes with Kokkos arrays
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
