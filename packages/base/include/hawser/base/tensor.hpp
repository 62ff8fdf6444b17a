#pragma once
// Vectors and second-order tensors of fixed size over doubles or automatic-differentiation numbers.
// Only what weak forms need; every function works in two and three dimensions unless it says
// otherwise.

namespace hawser {

/// The number type of a product: that of the factor which carries derivatives.
template <class A, class B>
struct Promoted;
template <class T>
struct Promoted<T, T> {
  using Type = T;
};
template <class T>
struct Promoted<T, double> {
  using Type = T;
};
template <class T>
struct Promoted<double, T> {
  using Type = T;
};
template <>
struct Promoted<double, double> {
  using Type = double;
};
template <class A, class B>
using Product = typename Promoted<A, B>::Type;

template <class T, int D>
struct Vector {
  T component[D] = {};
  T& operator[](int i) { return component[i]; }
  const T& operator[](int i) const { return component[i]; }
};

/// For the gradient of a vector u: (i, j) is d u_i / d x_j.
template <class T, int D>
struct Tensor {
  T component[D][D] = {};
  T& operator()(int i, int j) { return component[i][j]; }
  const T& operator()(int i, int j) const { return component[i][j]; }
};

template <class A, class B, int D>
Product<A, B> dot(const Vector<A, D>& a, const Vector<B, D>& b) {
  Product<A, B> sum = a[0] * b[0];
  for (int i = 1; i < D; ++i)
    sum += a[i] * b[i];
  return sum;
}

/// A_ik B_kj.
template <class A, class B, int D>
Tensor<Product<A, B>, D> multiply(const Tensor<A, D>& a, const Tensor<B, D>& b) {
  Tensor<Product<A, B>, D> result;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      result(i, j) = a(i, 0) * b(0, j);
      for (int k = 1; k < D; ++k)
        result(i, j) += a(i, k) * b(k, j);
    }
  return result;
}

/// A_ij b_j.
template <class A, class B, int D>
Vector<Product<A, B>, D> multiply(const Tensor<A, D>& a, const Vector<B, D>& b) {
  Vector<Product<A, B>, D> result;
  for (int i = 0; i < D; ++i) {
    result[i] = a(i, 0) * b[0];
    for (int j = 1; j < D; ++j)
      result[i] += a(i, j) * b[j];
  }
  return result;
}

/// a_i B_ij.
template <class A, class B, int D>
Vector<Product<A, B>, D> multiply(const Vector<A, D>& a, const Tensor<B, D>& b) {
  Vector<Product<A, B>, D> result;
  for (int j = 0; j < D; ++j) {
    result[j] = a[0] * b(0, j);
    for (int i = 1; i < D; ++i)
      result[j] += a[i] * b(i, j);
  }
  return result;
}

template <class T, int D>
T trace(const Tensor<T, D>& a) {
  T sum = a(0, 0);
  for (int i = 1; i < D; ++i)
    sum += a(i, i);
  return sum;
}

template <class T>
T determinant(const Tensor<T, 2>& a) {
  return a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
}
template <class T>
T determinant(const Tensor<T, 3>& a) {
  return a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) -
         a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0)) +
         a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
}

/// Inverse times determinant: finite even where the determinant is zero.
template <class T>
Tensor<T, 2> adjugate(const Tensor<T, 2>& a) {
  Tensor<T, 2> result;
  result(0, 0) = a(1, 1);
  result(0, 1) = -a(0, 1);
  result(1, 0) = -a(1, 0);
  result(1, 1) = a(0, 0);
  return result;
}
template <class T>
Tensor<T, 3> adjugate(const Tensor<T, 3>& a) {
  Tensor<T, 3> result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int p = (j + 1) % 3, q = (j + 2) % 3, r = (i + 1) % 3, s = (i + 2) % 3;
      result(i, j) = a(p, r) * a(q, s) - a(p, s) * a(q, r);
    }
  return result;
}

}  // namespace hawser
