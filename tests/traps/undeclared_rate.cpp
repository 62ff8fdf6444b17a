// Looks at a rate that its uses do not declare.
#include "kernel.hpp"

namespace hawser {
class Kernel_ : public Trap<Kernel_> {
 public:
  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    out[u].source = at[velocity].value[0] + at[u].rate;
  }
};
void build() { Kernel_ kernel; }
}  // namespace hawser
