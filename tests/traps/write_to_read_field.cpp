// Writes to a field that it only reads.
#include "kernel.hpp"

namespace hawser {
class Kernel_ : public Trap<Kernel_> {
 public:
  template <class Point, class Form>
  void weak_form(const Point& at, Form& out) const {
    out[u].flux = at[u].gradient;
    out[velocity].source[0] = 1.0;
  }
};
void build() { Kernel_ kernel; }
}  // namespace hawser
