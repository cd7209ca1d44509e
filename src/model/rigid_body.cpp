// SPDX-License-Identifier: MIT
#include "model/rigid_body.h"

namespace polhode {

Vec3 point_velocity(const Vec3& V, const Vec3& Omega, const Vec3& r) {
  return V + Omega.cross(r);
}

Mat3 inertia_tensor(const std::vector<PointMass>& points, const Vec3& origin) {
  Mat3 sum = Mat3::Zero();
  for (const PointMass& point : points)
    sum += steiner_tensor(point.mass, point.at - origin);
  return sum;
}

Mat3 tensor_with_origin_moved(const Mat3& tensor,
                              double mass,
                              const Vec3& first_moment,
                              const Vec3& a) {
  const Mat3 outer = first_moment * a.transpose();
  const Mat3 mixed = 2.0 * first_moment.dot(a) * Mat3::Identity() - outer - outer.transpose();
  return tensor - mixed + steiner_tensor(mass, a);
}

Vec3 angular_momentum(const Mat3& tensor, const Vec3& Omega) {
  return tensor * Omega;
}

KineticEnergy kinetic_energy(const MassProperties& body,
                             const Vec3& origin,
                             const Vec3& V,
                             const Vec3& Omega) {
  KineticEnergy energy;
  energy.translation = 0.5 * body.mass * V.squaredNorm();
  energy.rotation = 0.5 * Omega.dot(tensor_about(body, origin) * Omega);
  energy.coupling = body.mass * V.dot(Omega.cross(body.center - origin));
  return energy;
}

}  // namespace polhode
