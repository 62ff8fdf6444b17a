#include "distribute.hpp"

#include <cstring>
#include <type_traits>
#include <utility>

#include "cut_mesh.hpp"

namespace hawser {
namespace {

class Packer {
 public:
  template <class T>
  void operator()(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    append(&value, sizeof(T));
  }
  template <class T>
  void operator()(const std::vector<T>& values) {
    (*this)(values.size());
    append(values.data(), values.size() * sizeof(T));
  }
  void operator()(const std::string& text) { (*this)(std::vector<char>(text.begin(), text.end())); }
  template <class T, class Each>
  void list(const std::vector<T>& values, Each&& each) {
    (*this)(values.size());
    for (const auto& value : values)
      each(value);
  }

  std::vector<char> bytes;

 private:
  void append(const void* data, std::size_t size) {
    const auto* begin = static_cast<const char*>(data);
    bytes.insert(bytes.end(), begin, begin + size);
  }
};

class Unpacker {
 public:
  explicit Unpacker(std::vector<char> bytes) : bytes_(std::move(bytes)) {}

  template <class T>
  void operator()(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    take(&value, sizeof(T));
  }
  template <class T>
  void operator()(std::vector<T>& values) {
    std::size_t size = 0;
    (*this)(size);
    values.resize(size);
    take(values.data(), size * sizeof(T));
  }
  void operator()(std::string& text) {
    std::vector<char> letters;
    (*this)(letters);
    text.assign(letters.begin(), letters.end());
  }
  template <class T, class Each>
  void list(std::vector<T>& values, Each&& each) {
    std::size_t size = 0;
    (*this)(size);
    values.resize(size);
    for (auto& value : values)
      each(value);
  }

 private:
  void take(void* data, std::size_t size) {
    if (size > 0) std::memcpy(data, bytes_.data() + position_, size);
    position_ += size;
  }
  std::vector<char> bytes_;
  std::size_t position_ = 0;
};

template <class Archive, class Points>
void visit_points(Archive& archive, Points& points) {
  archive(points.owned);
  archive(points.global_count);
  archive(points.ids);
  archive(points.owners);
}

template <class Archive, class AnyRegion>
void visit_region(Archive& archive, AnyRegion& region) {
  archive(region.name);
  archive(region.dimension);
  archive(region.shape);
  archive(region.vertices_per_cell);
  archive(region.edges_per_cell);
  archive(region.cell_ids);
  archive(region.cell_owners);
  archive(region.vertices);
  archive(region.split_vertices);
  archive(region.edges);
}

// One list of members for both directions, so that they cannot disagree.
template <class Archive, class AnyMesh>
void visit(Archive& archive, AnyMesh& mesh) {
  archive(mesh.dimension);
  visit_points(archive, mesh.vertices);
  visit_points(archive, mesh.split_vertices);
  visit_points(archive, mesh.edges);
  archive(mesh.coordinates);
  archive(mesh.vertex_of_split);
  archive(mesh.edge_ends);
  visit_region(archive, mesh.body);
  archive.list(mesh.regions, [&](auto& region) { visit_region(archive, region); });
  archive.list(mesh.derived, [&](auto& derived) {
    auto& [domain, region] = derived;
    archive.list(domain.regions, [&](auto& name) { archive(name); });
    archive(domain.kind);
    archive(domain.point);
    visit_region(archive, region);
  });
}

void send(const Mesh& part, const Communicator& communicator, int rank) {
  Packer packer;
  visit(packer, part);
  communicator.send(packer.bytes, rank);
}

Mesh receive(const Communicator& communicator) {
  Unpacker unpacker(communicator.receive(0));
  Mesh part;
  part.communicator = communicator;
  visit(unpacker, part);
  return part;
}

}  // namespace

Mesh distribute(const Communicator& communicator, const Mesh& whole,
                const std::vector<int>& owner_of_vertex) {
  if (!communicator.is_root()) return receive(communicator);
  const MeshCutter cutter(whole, owner_of_vertex, communicator.size());
  for (int rank = 1; rank < communicator.size(); ++rank) {
    send(cutter.part(rank), communicator, rank);
  }
  return cutter.part(0);
}

}  // namespace hawser
