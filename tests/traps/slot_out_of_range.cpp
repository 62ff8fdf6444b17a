// Names a field beyond its list.
#include "kernel.hpp"

namespace hawser {
class Kernel_ : public Trap<Kernel_> {
 public:
  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    out[u].source = at[Slot<2>()].value;
  }
};
void build() { Kernel_ kernel; }
}  // namespace hawser
