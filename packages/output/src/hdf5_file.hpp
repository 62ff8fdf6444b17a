#pragma once
// The little of HDF5 that Hawser needs: one file, opened by all ranks, of tables and attributes.
// Every member is collective and throws OutputError on all ranks.
#include <hdf5.h>

#include <string>
#include <vector>

#include "hawser/base/communicator.hpp"
#include "hawser/base/types.hpp"

namespace hawser {

/// An HDF5 identifier and the function that closes it.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(other.id_), close_(other.close_) {
    other.id_ = H5I_INVALID_HID;
  }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;
  ~Hdf5Handle() { reset(); }

  bool reset() {
    const bool closed = id_ < 0 || close_(id_) >= 0;
    id_ = H5I_INVALID_HID;
    return closed;
  }
  /// Leaves it open for good.
  void abandon() { id_ = H5I_INVALID_HID; }
  bool valid() const { return id_ >= 0; }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

class Hdf5File {
 public:
  struct Shape {
    GlobalIndex rows = 0;
    int components = 0;
  };

  /// The first `free_bytes` (0, or a power of 2 from 512 on) are left to the caller.
  static Hdf5File create(const Communicator& communicator, const std::string& path,
                         int free_bytes = 0);
  static Hdf5File open(const Communicator& communicator, const std::string& path);
  Hdf5File(Hdf5File&&) = default;
  /// A file that could not be written is left open: HDF5, asked twice to close what it cannot
  /// flush, crashes over its own remains. It asks itself when MPI ends, so a program must end
  /// without that.
  ~Hdf5File() {
    if (writes_) file_.abandon();
  }

  /// A table [rows][components] (rank 1 for one component); this rank fills the rows at
  /// `positions`.
  void write(const std::string& name, Shape shape, const std::vector<GlobalIndex>& positions,
             const std::vector<double>& values);
  void write(const std::string& name, Shape shape, const std::vector<GlobalIndex>& positions,
             const std::vector<GlobalIndex>& values);
  Shape shape(const std::string& name) const;
  std::vector<double> read(const std::string& name,
                           const std::vector<GlobalIndex>& positions) const;

  void make_group(const std::string& name);
  bool has(const std::string& name) const;
  std::vector<std::string> names(const std::string& group) const;

  /// Attributes of the group or dataset `of`; the same on all ranks.
  void set(const std::string& of, const std::string& name, double value);
  void set(const std::string& of, const std::string& name, GlobalIndex value);
  void set(const std::string& of, const std::string& name, const std::string& value);
  bool has(const std::string& of, const std::string& name) const;
  std::vector<std::string> attributes(const std::string& of) const;
  double number(const std::string& of, const std::string& name) const;
  GlobalIndex integer(const std::string& of, const std::string& name) const;
  std::string text(const std::string& of, const std::string& name) const;

  /// A text of any length as a dataset (an attribute ends at 64 KiB).
  void write_text(const std::string& name, const std::string& text);
  std::string read_text(const std::string& name) const;
  /// Any bytes, of rank 0; nothing on the others.
  void write_bytes(const std::string& name, const std::string& bytes);
  std::string read_bytes(const std::string& name) const;

  /// Needed to learn of an error at closing; the destructor cannot tell.
  void close();

 private:
  Hdf5File(const Communicator& communicator, std::string path, Hdf5Handle file, bool writes);
  void require(bool done) const;
  void write_table(const std::string& name, Shape shape, const std::vector<GlobalIndex>& positions,
                   hid_t type, const void* sorted_values);
  void set(const std::string& of, const std::string& name, hid_t type, const void* value);

  Communicator communicator_;
  std::string path_;
  bool writes_;
  Hdf5Handle file_;
};

}  // namespace hawser
