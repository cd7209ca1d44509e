// SPDX-License-Identifier: MIT
// A second formulation of a body on a table, which shares nothing with the program: Newton's and
// Euler's equations in space axes with forces as multipliers, the contact found on the implicit
// surface of an ellipsoid, all in long double (64 bits of mantissa), by classical Runge-Kutta steps
// extrapolated once.
#pragma once

#include <array>
#include <cmath>
#include <utility>

namespace polhode::test {

using Real = long double;
using Real3 = std::array<Real, 3>;

// An ellipsoid (a sphere, too) on a table.
struct OracleBody {
  Real mass = 1.0L, gravity = 9.80665L;
  std::array<Real3, 3> tensor{};  // about the centre of mass, in body axes
  Real3 semi_axes{};              // along the body axes
  Real3 middle{};                 // of the ellipsoid, from the centre of mass
  enum class Law { frictionless, rolling, viscous, sliding } law = Law::rolling;
  Real coefficient = 0.0L;  // c or mu; `sliding` is Coulomb's law without sticking
};

// Place and velocity of the centre of mass, rotation (columns: body axes in space), angular
// velocity in space, and the contact in body axes from the centre of mass.
struct OracleState {
  Real3 x{}, v{}, w{}, contact{};
  std::array<Real3, 3> R{};  // R[i][j]: component i of body axis j
};

class ContactOracle {
 public:
  explicit ContactOracle(const OracleBody& body) : b_(body) {}

  // after `duration` (s), in `steps` steps and twice as many
  OracleState after(const OracleState& start, Real duration, int steps) const {
    const OracleState coarse = run(start, duration, steps), fine = run(start, duration, 2 * steps);
    Vector result = vector_of(fine);
    const Vector other = vector_of(coarse);
    for (std::size_t i = 0; i < kSize; ++i)
      result[i] += (result[i] - other[i]) / 15.0L;
    return state_of(result);
  }

  // the lowest point for an attitude, from the centre of mass, in body axes
  Real3 lowest(const std::array<Real3, 3>& R) const {
    Real3 point{};
    Real size = 0.0L;
    for (std::size_t i = 0; i < 3; ++i)
      size += b_.semi_axes[i] * b_.semi_axes[i] * R[2][i] * R[2][i];
    for (std::size_t i = 0; i < 3; ++i) {
      point[i] = b_.middle[i] - b_.semi_axes[i] * b_.semi_axes[i] * R[2][i] / std::sqrt(size);
    }
    return point;
  }

 private:
  static constexpr std::size_t kSize = 21;
  using Vector = std::array<Real, kSize>;

  static Vector vector_of(const OracleState& s) {
    Vector v{};
    std::size_t k = 0;
    for (const Real3* part : {&s.x, &s.v, &s.w, &s.contact, &s.R[0], &s.R[1], &s.R[2]})
      for (const Real value : *part)
        v[k++] = value;
    return v;
  }
  static OracleState state_of(const Vector& v) {
    OracleState s;
    std::size_t k = 0;
    for (Real3* part : {&s.x, &s.v, &s.w, &s.contact, &s.R[0], &s.R[1], &s.R[2]})
      for (Real& value : *part)
        value = v[k++];
    return s;
  }

  static Real3 cross(const Real3& a, const Real3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static Real3 to_space(const std::array<Real3, 3>& R, const Real3& a) {
    Real3 c{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        c[i] += R[i][j] * a[j];
    return c;
  }

  // Gauss's elimination with pivots
  template <std::size_t N>
  static std::array<Real, N> solve(std::array<std::array<Real, N>, N> A, std::array<Real, N> b) {
    for (std::size_t k = 0; k < N; ++k) {
      std::size_t best = k;
      for (std::size_t i = k + 1; i < N; ++i)
        if (std::abs(A[i][k]) > std::abs(A[best][k])) best = i;
      std::swap(A[k], A[best]);
      std::swap(b[k], b[best]);
      for (std::size_t i = k + 1; i < N; ++i) {
        const Real factor = A[i][k] / A[k][k];
        for (std::size_t j = k; j < N; ++j)
          A[i][j] -= factor * A[k][j];
        b[i] -= factor * b[k];
      }
    }
    for (std::size_t k = N; k-- > 0;) {
      for (std::size_t j = k + 1; j < N; ++j)
        b[k] -= A[k][j] * b[j];
      b[k] /= A[k][k];
    }
    return b;
  }

  // The rate of the contact in body axes: on the surface f = 0 its normal stays downwards, grad f =
  // -l up, so that H p' + l' up = -l up' and up . p' = 0.
  Real3 contact_rate(const OracleState& s) const {
    Real3 up{}, w_body{}, hessian{}, normal{};
    for (std::size_t i = 0; i < 3; ++i) {
      up[i] = s.R[2][i];
      for (std::size_t j = 0; j < 3; ++j)
        w_body[i] += s.R[j][i] * s.w[j];
      hessian[i] = 2.0L / (b_.semi_axes[i] * b_.semi_axes[i]);
      normal[i] = hessian[i] * (s.contact[i] - b_.middle[i]);
    }
    const Real3 up_rate = cross(up, w_body);
    Real l = 0.0L;
    for (std::size_t i = 0; i < 3; ++i)
      l -= normal[i] * up[i];
    std::array<std::array<Real, 4>, 4> A{};
    std::array<Real, 4> b{};
    for (std::size_t i = 0; i < 3; ++i) {
      A[i][i] = hessian[i];
      A[i][3] = A[3][i] = up[i];
      b[i] = -l * up_rate[i];
    }
    const std::array<Real, 4> found = solve<4>(A, b);
    return {found[0], found[1], found[2]};
  }

  Vector slope(const Vector& vector) const {
    const OracleState s = state_of(vector);
    const Real3 contact_turned = contact_rate(s);
    const Real3 arm = to_space(s.R, s.contact);
    const Real3 turning = cross(s.w, arm), moved = to_space(s.R, contact_turned);
    const Real3 arm_rate = {turning[0] + moved[0], turning[1] + moved[1], turning[2] + moved[2]};
    const Real3 carried = cross(s.w, arm_rate);

    // the tensor in space, and Euler's term
    std::array<Real3, 3> I{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k)
          for (std::size_t l = 0; l < 3; ++l)
            I[i][j] += s.R[i][k] * b_.tensor[k][l] * s.R[j][l];
    const Real3 L = {I[0][0] * s.w[0] + I[0][1] * s.w[1] + I[0][2] * s.w[2],
                     I[1][0] * s.w[0] + I[1][1] * s.w[1] + I[1][2] * s.w[2],
                     I[2][0] * s.w[0] + I[2][1] * s.w[1] + I[2][2] * s.w[2]};
    const Real3 gyro = cross(s.w, L);

    // unknowns: accelerations (3), angular accelerations (3), force at the contact (3)
    std::array<std::array<Real, 9>, 9> A{};
    std::array<Real, 9> b{};
    for (std::size_t i = 0; i < 3; ++i) {
      A[i][i] = b_.mass;
      A[i][6 + i] = -1.0L;
      for (std::size_t j = 0; j < 3; ++j)
        A[3 + i][3 + j] = I[i][j];
      b[3 + i] = -gyro[i];
      // arm x F
      const std::size_t n = (i + 1) % 3, p = (i + 2) % 3;
      A[3 + i][6 + p] -= arm[n];
      A[3 + i][6 + n] += arm[p];
    }
    b[2] = -b_.mass * b_.gravity;
    // v' + w' x arm + w x arm' = 0 in the directions that are held; else the law of friction
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t n = (i + 1) % 3, p = (i + 2) % 3;
      if (i == 2 || b_.law == OracleBody::Law::rolling) {
        A[6 + i][i] = 1.0L;
        A[6 + i][3 + n] = arm[p];
        A[6 + i][3 + p] = -arm[n];
        b[6 + i] = -carried[i];
        continue;
      }
      const Real3 slip = {s.v[0] + turning[0], s.v[1] + turning[1], 0.0L};
      const Real speed = std::sqrt(slip[0] * slip[0] + slip[1] * slip[1]);
      A[6 + i][6 + i] = 1.0L;
      if (b_.law == OracleBody::Law::viscous) A[6 + i][8] = b_.coefficient * slip[i];
      if (b_.law == OracleBody::Law::sliding) A[6 + i][8] = b_.coefficient * slip[i] / speed;
    }
    const std::array<Real, 9> found = solve<9>(A, b);

    OracleState rate;
    rate.x = s.v;
    rate.contact = contact_turned;
    for (std::size_t i = 0; i < 3; ++i) {
      rate.v[i] = found[i];
      rate.w[i] = found[3 + i];
    }
    for (std::size_t j = 0; j < 3; ++j) {
      const Real3 turned = cross(s.w, {s.R[0][j], s.R[1][j], s.R[2][j]});
      for (std::size_t i = 0; i < 3; ++i)
        rate.R[i][j] = turned[i];
    }
    return vector_of(rate);
  }

  OracleState run(const OracleState& start, Real duration, int steps) const {
    Vector v = vector_of(start);
    const Real h = duration / static_cast<Real>(steps);
    const auto moved = [](const Vector& from, Real by, const Vector& rate) {
      Vector to = from;
      for (std::size_t i = 0; i < kSize; ++i)
        to[i] += by * rate[i];
      return to;
    };
    for (int n = 0; n < steps; ++n) {
      const Vector k1 = slope(v), k2 = slope(moved(v, 0.5L * h, k1));
      const Vector k3 = slope(moved(v, 0.5L * h, k2)), k4 = slope(moved(v, h, k3));
      for (std::size_t i = 0; i < kSize; ++i)
        v[i] += h / 6.0L * (k1[i] + 2.0L * k2[i] + 2.0L * k3[i] + k4[i]);
    }
    return state_of(v);
  }

  OracleBody b_;
};

}  // namespace polhode::test
