// Looks at a value that its uses do not declare.
#include "kernel.hpp"

namespace hawser {
class Kernel_ : public Trap<Kernel_> {
 public:
  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    out[u].source = 2.0 * at[u].value;
  }
};
void build() { Kernel_ kernel; }
}  // namespace hawser
