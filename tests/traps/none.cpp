// Nothing wrong: it compiles, so that the others fail for their own reason.
#include "kernel.hpp"

namespace hawser {
class Kernel_ : public Trap<Kernel_> {
 public:
  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    out[u].flux = at[u].gradient;
    out[u].source = at[velocity].value[0];
  }
};
void build() { Kernel_ kernel; }
}  // namespace hawser
