// From the deck's <mesh> to a mesh.
#include "hawser/mesh/mesh_deck.hpp"

#include <string>

namespace hawser {
namespace {

Rules flow_directions() { return one_of({"-y", "+y", "-x", "+x"}); }

}  // namespace

Spec<TowBox> TowBox::spec() {
  using P = TowBox;
  return Spec<P>("tow-box",
                 "A box of water with a straight cable in it: regions water, cable, tow-point (the "
                 "cable's start), tail (its end) and the walls inflow, outflow, sides.")
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

Spec<WaterBox> WaterBox::spec() {
  using P = WaterBox;
  return Spec<P>("water-box",
                 "A box of water alone: regions water and the walls inflow, outflow, sides.")
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

Spec<MeshFileDeck> MeshFileDeck::spec() {
  return Spec<MeshFileDeck>("file", "A mesh file made by gmsh.")
      .attribute("name", &MeshFileDeck::name, required(),
                 "MSH 2.2 or 4.1, ASCII or binary, partitioned or not; a relative path starts at "
                 "the deck's folder.")
      .attribute("dimension", &MeshFileDeck::dimension, between(2, 3),
                 "Of the space; in three the file may hold lines and points only.");
}

Spec<GeoMesh::Number> GeoMesh::Number::spec() {
  using P = Number;
  return Spec<P>("number", "A constant of the geometry, which it has by DefineConstant.")
      .attribute("name", &P::name, required(), "As in the file.")
      .attribute("value", &P::value, "1", required() && any(), "In the file's units: metres.");
}

Spec<GeoMesh> GeoMesh::spec() {
  using P = GeoMesh;
  return Spec<P>("geo",
                 "A geometry in gmsh's language (.geo), meshed in the plane; its physical "
                 "groups are the regions.")
      .attribute("file", &P::file, required(), "A relative path starts at the deck's folder.")
      .attribute("refinements", &P::refinements, between(0, 10),
                 "How often every cell of the mesh so described is cut into four.")
      .children(&P::numbers);
}

Spec<MeshDeck> MeshDeck::spec() {
  using P = MeshDeck;
  return Spec<P>("mesh", "Where the mesh comes from: exactly one of the children.")
      .attribute("slits", &P::slits, absent("none"),
                 "Line regions across which the pressure is doubled.")
      .attribute("apart", &P::apart, absent("none"),
                 "Regions that are meant to share no nodes with what lies at the same place, such "
                 "as a cable beside the body or a crack; else that is an error.")
      .attribute("open-boundary", &P::open_boundary,
                 "Boundary edges in no region are meant: nothing is prescribed there and no "
                 "traction acts. Else a note says where they are.")
      .child(&P::tow_box)
      .child(&P::water_box)
      .child(&P::line)
      .child(&P::lines)
      .child(&P::file)
      .child(&P::geo)
      .location(&P::location)
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        if (int(p.tow_box.has_value()) + int(p.water_box.has_value()) + int(p.line.has_value()) +
                int(p.lines.has_value()) + int(p.file.has_value()) + int(p.geo.has_value()) !=
            1)
          diagnostics.error(where,
                            "<mesh> needs exactly one of <tow-box>, <water-box>, <line>, <lines>, "
                            "<file> and <geo>");
      });
}

Spec<LineMesh> LineMesh::spec() {
  using P = LineMesh;
  return Spec<P>("line",
                 "A cable alone, in the plane or in space, straight or laid along a curve: regions "
                 "cable, tow-point (its start), tail (its end) and, with an even number of "
                 "segments, middle.")
      .attribute("from", &P::from, "m", any() && length(2, 3) && absent("shape says it"),
                 "Where it starts.")
      .attribute("to", &P::to, "m", any() && length(2, 3) && absent("shape says it"),
                 "Where it ends.")
      .attribute("segments", &P::segments, required() && at_least(1), "Of equal length.")
      .attribute("shape", &P::shape, absent("straight"),
                 "CSV file of a curve, such as a measured shape, along which the cable is laid "
                 "without strain: columns x_m, y_m, z_m in space, arc_length_m if it is known. A "
                 "relative path starts at the deck's folder.")
      .attribute("length", &P::cable_length, "m", positive() && absent("that of the shape"),
                 "Of the cable that is laid along a shape.")
      .check([](const P& p, const Location& where, Diagnostics& diagnostics) {
        const bool straight = !p.from.empty() || !p.to.empty();
        if (!p.shape->empty()) {
          if (straight) diagnostics.error(where, "a line has either 'from' and 'to', or a shape");
          return;
        }
        if (p.cable_length)
          diagnostics.error(where, "'length' is for a line along a shape; 'from' and 'to' say it");
        if (p.from.empty() || p.to.empty())
          diagnostics.error(where, "a line needs 'from' and 'to', or a shape");
        else if (p.from.size() != p.to.size())
          diagnostics.error(where, "'from' has " + std::to_string(p.from.size()) +
                                       " coordinates and 'to' " + std::to_string(p.to.size()));
        else if (p.from == p.to)
          diagnostics.error(where, "'from' and 'to' are the same point");
      });
}

int MeshDeck::dimension() const {
  if (line) return line->shape->empty() ? static_cast<int>(line->from.size()) : line->dimension;
  if (lines) return lines->dimension();
  return file ? file->dimension : 2;
}

std::string MeshDeck::generate(const Communicator& communicator, const std::string& geometry,
                               const std::string& path) const {
  if (geo) return generate_mesh(communicator, *geo, geometry, path);
  if (tow_box) return generate_mesh(communicator, *tow_box, path);
  if (water_box) return generate_mesh(communicator, *water_box, path);
  if (lines) {
    generate_mesh(communicator, *lines, path);
    int segments = 0;
    for (const auto& each : lines->lines)
      segments += lines->segments(each);
    return std::to_string(lines->lines.size()) + " lines of " + std::to_string(segments) +
           " segments in all";
  }
  generate_mesh(communicator, *line, path);
  return "a line of " + std::to_string(line->segments) + " segments";
}

}  // namespace hawser
