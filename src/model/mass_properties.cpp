// SPDX-License-Identifier: MIT
#include "model/mass_properties.h"

namespace polhode {

Mat3 steiner_tensor(double mass, const Vec3& offset) {
  // squares that cancel are left out
  const Vec3 squares = offset.cwiseAbs2();
  Mat3 tensor = -offset * offset.transpose();
  tensor.diagonal() << squares[1] + squares[2], squares[2] + squares[0], squares[0] + squares[1];
  return mass * tensor;
}

Mat3 tensor_about(const MassProperties& body, const Vec3& about) {
  return body.tensor + steiner_tensor(body.mass, body.center - about);
}

MassProperties moved(const MassProperties& body, const Mat3& R, const Vec3& shift) {
  return {body.mass, R * body.center + shift, R * body.tensor * R.transpose()};
}

MassProperties composed(const std::vector<MassProperties>& parts) {
  MassProperties whole;
  for (const MassProperties& part : parts) {
    whole.mass += part.mass;
    whole.center += part.mass * part.center;
  }
  whole.center /= whole.mass;

  // each tensor is carried to the common centre, never to the origin: nothing large cancels
  for (const MassProperties& part : parts)
    whole.tensor += tensor_about(part, whole.center);
  return whole;
}

MassProperties of_points(const std::vector<PointMass>& points) {
  std::vector<MassProperties> parts;
  parts.reserve(points.size());
  for (const PointMass& point : points)
    parts.push_back({point.mass, point.at, Mat3::Zero()});
  return composed(parts);
}

}  // namespace polhode
