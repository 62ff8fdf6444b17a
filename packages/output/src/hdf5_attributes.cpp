// The part of Hdf5File that deals in names, attributes and texts.
#include "src/hdf5_file.hpp"

namespace hawser {
namespace {

Hdf5Handle scalar() { return {H5Screate(H5S_SCALAR), H5Sclose}; }

Hdf5Handle text_type(std::size_t size) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, size == 0 ? 1 : size);  // HDF5 knows no text of length 0
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

// Shorter than its type, and so ended by a null, only when it is empty.
std::string without_padding(std::string text) {
  text.erase(text.find_last_not_of('\0') + 1);
  return text;
}

}  // namespace

void Hdf5File::make_group(const std::string& name) {
  const Hdf5Handle group(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Gclose);
  require(group.valid());
}

bool Hdf5File::has(const std::string& name) const {
  return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5File::names(const std::string& group) const {
  std::vector<std::string> found;
  const auto keep = [](hid_t, const char* name, const H5L_info_t*, void* data) -> herr_t {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
  };
  const Hdf5Handle opened(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose);
  require(opened.valid());
  require(H5Literate(opened, H5_INDEX_NAME, H5_ITER_INC, nullptr, keep, &found) >= 0);
  return found;
}

std::vector<std::string> Hdf5File::attributes(const std::string& of) const {
  std::vector<std::string> found;
  const auto keep = [](hid_t, const char* name, const H5A_info_t*, void* data) -> herr_t {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
  };
  const Hdf5Handle object(H5Oopen(file_, of.c_str(), H5P_DEFAULT), H5Oclose);
  require(object.valid());
  require(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, keep, &found) >= 0);
  return found;
}

void Hdf5File::set(const std::string& of, const std::string& name, hid_t type, const void* value) {
  const Hdf5Handle object(H5Oopen(file_, of.c_str(), H5P_DEFAULT), H5Oclose);
  const Hdf5Handle attribute(
      H5Acreate2(object, name.c_str(), type, scalar(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(attribute.valid() && H5Awrite(attribute, type, value) >= 0);
}

void Hdf5File::set(const std::string& of, const std::string& name, double value) {
  set(of, name, H5T_NATIVE_DOUBLE, &value);
}

void Hdf5File::set(const std::string& of, const std::string& name, GlobalIndex value) {
  set(of, name, H5T_NATIVE_LLONG, &value);
}

void Hdf5File::set(const std::string& of, const std::string& name, const std::string& value) {
  set(of, name, text_type(value.size()), value.c_str());
}

bool Hdf5File::has(const std::string& of, const std::string& name) const {
  return H5Aexists_by_name(file_, of.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

double Hdf5File::number(const std::string& of, const std::string& name) const {
  double value = 0;
  const Hdf5Handle attribute(
      H5Aopen_by_name(file_, of.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(attribute.valid() && H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) >= 0);
  return value;
}

std::string Hdf5File::text(const std::string& of, const std::string& name) const {
  const Hdf5Handle attribute(
      H5Aopen_by_name(file_, of.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(attribute.valid());
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
  std::string value(H5Tget_size(type), '\0');
  require(H5Aread(attribute, type, value.data()) >= 0);
  return without_padding(value);
}

GlobalIndex Hdf5File::integer(const std::string& of, const std::string& name) const {
  GlobalIndex value = 0;
  const Hdf5Handle attribute(
      H5Aopen_by_name(file_, of.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(attribute.valid() && H5Aread(attribute, H5T_NATIVE_LLONG, &value) >= 0);
  return value;
}

void Hdf5File::write_text(const std::string& name, const std::string& text) {
  const Hdf5Handle type = text_type(text.size());
  const Hdf5Handle space = scalar();
  const Hdf5Handle data(
      H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose);
  require(data.valid());
  // Ranks must not write the same bytes: rank 0 does.
  const bool done = !communicator_.is_root() ||
                    H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()) >= 0;
  require(done);
}

void Hdf5File::write_bytes(const std::string& name, const std::string& bytes) {
  auto size = static_cast<unsigned long long>(bytes.size());
  MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG_LONG, 0, communicator_.mpi());
  const hsize_t sizes[] = {size};
  const Hdf5Handle space(H5Screate_simple(1, sizes, nullptr), H5Sclose);
  const Hdf5Handle data(H5Dcreate2(file_, name.c_str(), H5T_NATIVE_UCHAR, space, H5P_DEFAULT,
                                   H5P_DEFAULT, H5P_DEFAULT),
                        H5Dclose);
  require(data.valid());
  const bool done =
      !communicator_.is_root() || size == 0 ||
      H5Dwrite(data, H5T_NATIVE_UCHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) >= 0;
  require(done);
}

std::string Hdf5File::read_bytes(const std::string& name) const {
  const Shape found = shape(name);
  const Hdf5Handle data(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  require(data.valid());
  std::string bytes;
  bool done = true;
  if (communicator_.is_root() && found.rows > 0) {
    bytes.resize(static_cast<std::size_t>(found.rows));
    done = H5Dread(data, H5T_NATIVE_UCHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) >= 0;
  }
  require(done);
  return bytes;
}

std::string Hdf5File::read_text(const std::string& name) const {
  const Hdf5Handle data(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  require(data.valid());
  const Hdf5Handle type(H5Dget_type(data), H5Tclose);
  std::string text(H5Tget_size(type), '\0');
  require(H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) >= 0);
  return without_padding(text);
}

}  // namespace hawser
