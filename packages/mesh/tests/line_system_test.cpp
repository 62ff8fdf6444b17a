// Lines joined at nodes: their regions, lengths and shapes at first.
#include "hawser/mesh/line_system.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/mesh/mesh.hpp"
#include "mesh_text.hpp"

namespace hawser {
namespace {

using Points = std::vector<std::vector<double>>;

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double squared = 0;
  for (std::size_t j = 0; j < a.size(); ++j)
    squared += (b[j] - a[j]) * (b[j] - a[j]);
  return std::sqrt(squared);
}

/// What the chain's own weight leaves over at its joints, over the pull in its first link: the
/// links' directions must be those of forces that differ by one weight from link to link.
double imbalance(const Points& x) {
  // Along the horizontal the force is the same in all links; its vertical part is that times the
  // slope.
  double worst = 0, first = 0;
  for (std::size_t k = 1; k + 1 < x.size(); ++k) {
    const auto slope = [&](std::size_t i) {
      return (x[i + 1].back() - x[i].back()) /
             std::hypot(x[i + 1][0] - x[i][0], x[i].size() == 3 ? x[i + 1][1] - x[i][1] : 0);
    };
    const double weight = slope(k) - slope(k - 1);  // of a link over the pull
    if (k == 1) first = weight;
    worst = std::max(worst, std::abs(weight - first) / first);
  }
  return worst;
}

TEST(Chain, HangsInBalanceWithLinksOfEqualLength) {
  struct Case {
    std::vector<double> to;
    double length;
    int links;
  };
  for (const Case& c :
       {Case{{100, 0}, 120, 40}, Case{{100, -60}, 117, 2}, Case{{30, 40}, 500, 101},
        Case{{2000, -1000}, 2300, 200}, Case{{1, 0}, 1 + 1e-7, 8}, Case{{0.2, 1}, 3, 16},
        Case{{3, 4, 12}, 20, 25}, Case{{1000, 10, 0}, 1000.1, 50}}) {
    std::vector<double> down(c.to.size(), 0);
    down.back() = -1;
    const std::vector<double> from(c.to.size(), 0);
    const Points x = hang_chain(from, c.to, c.length, c.links, down);
    ASSERT_EQ(x.size(), static_cast<std::size_t>(c.links + 1));
    for (int k = 0; k < c.links; ++k)
      EXPECT_NEAR(distance(x[static_cast<std::size_t>(k)], x[static_cast<std::size_t>(k + 1)]),
                  c.length / c.links, 1e-11 * c.length);
    EXPECT_LT(imbalance(x), 1e-6) << c.length;
  }
}

TEST(Chain, BecomesACatenaryWithTheSquareOfItsLinks) {
  // y = a cosh(x/a) between x = -a and a: of length 2 a sinh 1, a (cosh 1 - 1) deep.
  const double a = 40, exact = -a * (std::cosh(1) - 1);
  double errors[2];
  for (const int level : {0, 1}) {
    const int links = 40 << level;
    const Points x = hang_chain({0, 0}, {2 * a, 0}, 2 * a * std::sinh(1), links, {0, -1});
    errors[level] = std::abs(x[static_cast<std::size_t>(links / 2)][1] - exact);
  }
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.1);
  EXPECT_LT(errors[1], 1e-3 * a);
}

TEST(Chain, HasNoPlaceWhereItIsTooShortOrDoubled) {
  EXPECT_THROW(hang_chain({0, 0}, {10, 0}, 9, 5, {0, -1}), MeshError);
  EXPECT_THROW(hang_chain({0, 0}, {0, -10}, 12, 5, {0, -1}), MeshError);
}

LineSystem::Node node(const std::string& name, std::vector<double> at) {
  return {{name, {}}, std::move(at), {}};
}

TEST(LineSystem, MakesARegionOfEachLineNodeAndPoint) {
  LineSystem system;
  system.nodes = {node("ship", {0, 0, 0}), node("fish", {-30, 0, -40}),
                  node("tail", {-90, 0, -40})};
  system.lines.resize(2);
  system.lines[0] = {{"cable", {}}, {"ship", {}}, {"fish", {}}, 10, {60, {}}, {}, {}};
  system.lines[1] = {{"streamer", {}}, {"fish", {}}, {"tail", {}}, 6, {}, {}, {}};
  system.lines[1].points = {{{"bird", {}}, {20, {}}}};
  const Communicator all;
  for (const int refinements : {0, 1}) {
    system.refinements = refinements;
    generate_mesh(all, system, "lines.msh");
    const Mesh mesh = read_mesh(all, {"lines.msh", {}, 3, {Domain::ends("streamer", "bird")}});
    const int halves = 1 << refinements;
    EXPECT_EQ(mesh.vertices.global_count, 16 * halves + 1);
    EXPECT_EQ(count_cells(mesh, "cable"), 10 * halves);
    EXPECT_EQ(count_cells(mesh, Domain::ends("streamer", "bird")), 2);
    double length[2] = {0, 0};
    for (const int l : {0, 1}) {
      const Region& line = mesh.region(std::string(l == 0 ? "cable" : "streamer"));
      for (LocalIndex c = 0; c < line.size(); ++c) {
        if (line.cell_owners[static_cast<std::size_t>(c)] != all.rank()) continue;
        std::vector<double> ends[2];
        for (int k = 0; k < 2; ++k) {
          const auto v = line.vertices[static_cast<std::size_t>(2 * c + k)];
          for (int j = 0; j < 3; ++j)
            ends[k].push_back(mesh.coordinates[static_cast<std::size_t>(3 * v + j)]);
        }
        length[l] += distance(ends[0], ends[1]);
      }
    }
    EXPECT_NEAR(all.sum(length[0]), 60, 1e-10);
    EXPECT_NEAR(all.sum(length[1]), 60, 1e-10);
    for (const LocalIndex v : mesh.region("bird").vertices)
      EXPECT_NEAR(mesh.coordinates[static_cast<std::size_t>(3 * v)], -50, 1e-12);
  }
}

}  // namespace
}  // namespace hawser
