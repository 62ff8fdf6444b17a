// Declares three fields and describes two.
#include "kernel.hpp"

namespace hawser {
class Kernel_ : public Trap<Kernel_> {
 public:
  static constexpr std::array<FieldUse, 3> uses = {
      scalar.as(Role::adds, need::gradient),
      StandardFields<2>::velocity.as(Role::reads, need::value)};
  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    out[u].flux = at[u].gradient;
  }
};
void build() { Kernel_ kernel; }
}  // namespace hawser
