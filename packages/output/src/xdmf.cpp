#include "src/xdmf.hpp"

#include <fmt/format.h>

namespace hawser {
namespace {

// Version 2: ParaView's legacy reader is the one that reads our files right.
constexpr auto head = "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n";
constexpr auto foot = "</Domain>\n</Xdmf>\n";

std::string table(const std::string& data, const std::string& name, GlobalIndex rows,
                  int components, const char* type) {
  const std::string shape =
      components == 1 ? fmt::format("{}", rows) : fmt::format("{} {}", rows, components);
  return fmt::format(
      "<DataItem Dimensions=\"{}\" NumberType=\"{}\" Precision=\"8\" "
      "Format=\"HDF\">{}:/{}</DataItem>",
      shape, type, data, name);
}

const char* attribute_type(int written) {
  if (written == 1) return "Scalar";
  return written == 3 ? "Vector" : "Matrix";
}

}  // namespace

int written_components(int components) { return components == 2 ? 3 : components; }

std::string xdmf_grid(const Grid& grid, const std::string& data,
                      const std::vector<PointField>& fields) {
  const bool triangles = grid.kind == CellKind::triangle;
  std::string text = fmt::format("<Grid Name=\"{}\" GridType=\"Uniform\">\n", grid.name);
  text += fmt::format("<Topology TopologyType=\"{}\" NumberOfElements=\"{}\"{}>\n{}\n</Topology>\n",
                      triangles ? "Triangle" : "Polyline", grid.cell_count,
                      triangles ? "" : " NodesPerElement=\"2\"",
                      table(data, "cells", grid.cell_count, triangles ? 3 : 2, "Int"));
  text += fmt::format("<Geometry GeometryType=\"XYZ\">\n{}\n</Geometry>\n",
                      table(data, "points", grid.point_count, 3, "Float"));
  for (const PointField& field : fields) {
    const int written = written_components(field.components);
    text += fmt::format(
        "<Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">\n{}\n</Attribute>\n",
        field.name, attribute_type(written), field.of_cells ? "Cell" : "Node",
        table(data, "fields/" + field.name, rows_of(grid, field), written, "Float"));
  }
  return text + "</Grid>\n";
}

std::string xdmf_single(const std::string& grid) { return head + grid + foot; }

std::string xdmf_series(const std::string& name, const std::map<int, SavedOutput>& outputs) {
  std::string text = head;
  text +=
      fmt::format("<Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n", name);
  for (const auto& [step, output] : outputs) {
    const auto body = output.grid.find('\n') + 1;  // the time belongs within the element
    text += output.grid.substr(0, body);
    text += fmt::format("<Time Value=\"{:.12g}\"/>\n", output.time) + output.grid.substr(body);
  }
  return text + "</Grid>\n" + foot;
}

std::string xdmf_grid_of(const std::string& single) {
  const auto begin = single.find("<Grid");
  const auto end = single.find(foot);
  if (begin == std::string::npos || end == std::string::npos) return {};
  return single.substr(begin, end - begin);
}

}  // namespace hawser
