// Names a property of which there is none.
#include "kernel.hpp"

namespace hawser {
class Kernel_ : public Trap<Kernel_> {
 public:
  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    out[u].source = at[PropertySlot<0>()];
  }
};
void build() { Kernel_ kernel; }
}  // namespace hawser
