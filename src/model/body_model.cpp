// SPDX-License-Identifier: MIT
#include "model/body_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "base/error.h"
#include "model/solids.h"

namespace polhode {
namespace {

constexpr double kSameAxis = 1e-9;  // two direction cosines closer than this are a tie

// the tensor as the user gave it, from either key
Mat3 given_tensor(const BodySpec& spec) {
  if (spec.moments) return spec.moments->asDiagonal();
  const Mat3& tensor = *spec.tensor;
  if ((tensor - tensor.transpose()).cwiseAbs().maxCoeff() > 1e-9 * tensor.cwiseAbs().maxCoeff()) {
    throw input_error("must be symmetric").at({{}, 0, "body.tensor"});
  }
  return 0.5 * (tensor + tensor.transpose());
}

const char* tensor_key(const BodySpec& spec) {
  return spec.moments ? "body.moments" : "body.tensor";
}

// the turn of a basis within the plane or space that it spans that brings it closest to the body
// axes with these indices (orthogonal Procrustes problem, Schoenemann 1966)
void align(Mat3& R_BP, const std::vector<int>& indices) {
  const auto n = static_cast<Eigen::Index>(indices.size());
  Eigen::MatrixXd basis(3, n), seen(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    basis.col(j) = R_BP.col(indices[static_cast<std::size_t>(j)]);
  for (Eigen::Index j = 0; j < n; ++j)
    seen.col(j) = basis.transpose() * Vec3::Unit(indices[static_cast<std::size_t>(j)]);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(seen, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::MatrixXd turned = basis * svd.matrixU() * svd.matrixV().transpose();
  for (Eigen::Index j = 0; j < n; ++j)
    R_BP.col(indices[static_cast<std::size_t>(j)]) = turned.col(j);
}

// the axis that stands alone goes to the body axis it is closest to, of equals to the last; the
// other two follow x, y, z as closely as they can
Mat3 frame_of_symmetric(const Vec3& alone) {
  int axis = 2;
  for (int i = 1; i >= 0; --i) {
    if (std::abs(alone[i]) > std::abs(alone[axis]) + kSameAxis) axis = i;
  }
  Mat3 R_BP;
  R_BP.col(axis) = alone[axis] < 0.0 ? Vec3(-alone) : alone;
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  R_BP.col(next) = Vec3::Unit(last).cross(R_BP.col(axis)).normalized();
  R_BP.col(last) = R_BP.col(axis).cross(R_BP.col(next));
  align(R_BP, {next, last});
  return R_BP;
}

// each axis at the body axis it is closest to, of equals the first order
Mat3 frame_of_asymmetric(const Mat3& axes) {
  std::array<int, 3> order = {0, 1, 2};
  std::array<int, 3> best = order;
  double most = 0.0;
  do {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
      sum += std::abs(axes(i, order[static_cast<std::size_t>(i)]));
    if (sum > most + kSameAxis) {
      most = sum;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  Mat3 R_BP;
  int least = 2;
  for (int i = 2; i >= 0; --i) {
    const Vec3 axis = axes.col(best[static_cast<std::size_t>(i)]);
    R_BP.col(i) = axis[i] < 0.0 ? Vec3(-axis) : axis;
    if (std::abs(axis[i]) < std::abs(R_BP(least, least)) - kSameAxis) least = i;
  }
  if (R_BP.determinant() < 0.0) R_BP.col(least) = -R_BP.col(least);
  return R_BP;
}

// Right-handed principal frame, as close to the body axes as it can be: where moments coincide, or
// do but for round-off, an eigensolver's axes are any, and the next bit would turn them.
void find_principal_frame(const Mat3& tensor, double equal, Mat3& R_BP, Vec3& moments) {
  Mat3 off_diagonal = tensor;
  off_diagonal.diagonal().setZero();
  R_BP = Mat3::Identity();
  moments = tensor.diagonal();
  if (off_diagonal.cwiseAbs().maxCoeff() <= 0.01 * equal * tensor.cwiseAbs().maxCoeff()) return;

  // ascending
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(tensor);
  const Vec3& found = solver.eigenvalues();
  const double close = equal * found.cwiseAbs().maxCoeff();
  const bool low = found[1] - found[0] <= close;
  const bool high = found[2] - found[1] <= close;
  if (low && high) return;
  if (low || high) {
    R_BP = frame_of_symmetric(solver.eigenvectors().col(low ? 2 : 0));
  } else {
    R_BP = frame_of_asymmetric(solver.eigenvectors());
  }
  moments = (R_BP.transpose() * tensor * R_BP).diagonal();
}

void refuse_impossible(const Vec3& moments, const BodySpec& spec, const std::string& where) {
  const std::string key = spec.moments           ? "body.moments"
                          : spec.tensor          ? "body.tensor"
                          : !spec.points.empty() ? "body.points"
                          : spec.solid           ? "body.solid"
                                                 : "body.parts";
  const double largest = moments.maxCoeff();
  if (largest == 0.0 && !spec.points.empty()) {
    throw input_error("all mass is in one point; such a body has no attitude").at({{}, 0, key});
  }
  if (moments.minCoeff() < -1e-12 * largest || largest <= 0.0) {
    throw input_error("moments of inertia ({}, {}, {}) kg m^2 {} must not be negative or all zero",
                      moments[0],
                      moments[1],
                      moments[2],
                      where)
        .at({{}, 0, key});
  }
  // products of moments and momenta would vanish; the smallest solid has more
  constexpr double kLeastMoment = 1e-60;
  if (largest < kLeastMoment) {
    throw input_error(
        "moments of inertia ({:.3g}, {:.3g}, {:.3g}) kg m^2 {} are too small; the largest must be "
        "at least {:.0e}",
        moments[0],
        moments[1],
        moments[2],
        where,
        kLeastMoment)
        .at({{}, 0, key});
  }
  int zeros = 0;
  for (int i = 0; i < 3; ++i)
    zeros += moments[i] <= 1e-12 * largest ? 1 : 0;
  if (zeros > 1) {
    throw input_error("two moments {} are zero: such a body has no attitude", where)
        .at({{}, 0, key});
  }
  // all mass on a line: about any point of it the other two moments are equal
  if (zeros == 1 && 2.0 * largest > moments.sum() * (1.0 + 1e-9)) {
    throw input_error(
        "a moment {} is zero (less than 1e-12 of the largest), so all mass is on a line "
        "and the other two must be equal",
        where)
        .at({{}, 0, key});
  }
  const std::string wrong = impossible_moments(moments);
  if (!wrong.empty() && !spec.mathematical) {
    throw input_error(
        "no body has these moments {}: {}; set body.mathematical = true to allow them",
        where,
        wrong)
        .at({{}, 0, key});
  }
}

// masses on a line take up no torque about that line
void refuse_torque_about_line(const BodyModel& model) {
  if (!model.kind.rotator) return;
  Eigen::Index line = 0;
  model.moments.minCoeff(&line);
  for (std::size_t i = 0; i < model.loads.listed.size(); ++i) {
    const Load& load = model.loads.listed[i];
    const auto refuse = [&](const char* name, const char* remedy) {
      throw input_error("all mass lies on a line and takes up no torque about it; {}", remedy)
          .at({{}, 0, fmt::format("motion.torque[{}].{}", i, name)});
    };
    if (load.kind == Load::Kind::torque) {
      if (!load.in_body) refuse("space", "give it in body axes and across the line, or as a force");
      if (std::abs(load.vector[line]) > 1e-12 * load.vector.norm())
        refuse("body", "leave out the component along it");
    }
    Vec3 aside = load.arm_P;
    aside[line] = 0.0;
    if (aside.norm() > 1e-12 * load.arm_P.norm()) refuse("at", "let forces act on the line");
  }
}

}  // namespace

std::string TopKind::name() const {
  static constexpr const char* kNames[] = {
      "spherical", "symmetric prolate", "symmetric oblate", "asymmetric"};
  std::string text = kNames[static_cast<int>(shape)];
  if (planar) text += " planar";
  if (rotator) text += " rotator";
  return text;
}

std::string impossible_moments(const Vec3& moments) {
  for (int i = 0; i < 3; ++i) {
    const double others = moments[(i + 1) % 3] + moments[(i + 2) % 3];
    if (moments[i] > others * (1.0 + 1e-9)) {
      return fmt::format("{} is greater than the sum of the other two, {}", moments[i], others);
    }
  }
  return {};
}

TopKind classify(const Vec3& moments, double equal) {
  TopKind kind;
  const double largest = moments.maxCoeff();
  const auto agree = [&](int i, int j) {
    return std::abs(moments[i] - moments[j]) <= equal * largest;
  };
  kind.rotator = moments.minCoeff() <= kEqualMoments * largest;
  kind.planar =
      !kind.rotator && std::abs(2.0 * largest - moments.sum()) <= 4.0 * kEqualMoments * largest;
  if (agree(0, 1) && agree(1, 2)) {
    kind.shape = TopKind::Shape::spherical;
    return kind;
  }
  for (int axis = 2; axis >= 0; --axis) {
    const int other = (axis + 1) % 3;
    if (!agree(other, (axis + 2) % 3)) continue;
    kind.axis = axis;
    kind.shape = moments[axis] < moments[other] ? TopKind::Shape::prolate : TopKind::Shape::oblate;
    return kind;
  }
  return kind;
}

namespace {

constexpr double kFewRoundings = 4.0 * 0x1p-53;  // of a sum

// How far round-off may have moved the moments of a tensor, kg m^2. In principal axes as they are
// given or calculated each has an error of its own size, which does not count; from others, all
// have that of the largest.
double rounding_of_moments(const BodySpec& spec, const Mat3& tensor) {
  constexpr double kMoreOfMeshes = 16.0;
  const double rounding = kFewRoundings * tensor.cwiseAbs().maxCoeff();
  const auto many_sums = [](const SolidSpec& solid) {
    return solid.mesh != nullptr || solid.kind == "lathe";
  };
  if ((spec.solid && many_sums(*spec.solid)) ||
      std::any_of(spec.parts.begin(), spec.parts.end(), many_sums))
    return kMoreOfMeshes * rounding;
  const bool in_order = tensor(0, 1) == 0.0 && tensor(1, 2) == 0.0 && tensor(2, 0) == 0.0;
  return in_order ? 0.0 : rounding;
}

// how far a tensor in principal axes is from that of a body with equal moments, which count as
// equal
double left_out_by(const TopKind& kind, Mat3 tensor_P) {
  if (kind.shape == TopKind::Shape::asymmetric) return 0.0;
  Vec3 moments = tensor_P.diagonal();
  if (kind.symmetric()) {
    const int i = (kind.axis + 1) % 3, j = (kind.axis + 2) % 3;
    moments[i] = moments[j] = 0.5 * (moments[i] + moments[j]);
  } else {
    moments.setConstant(moments.mean());
  }
  tensor_P.diagonal() -= moments;
  return tensor_P.cwiseAbs().maxCoeff();
}

}  // namespace

MassProperties mass_properties(const BodySpec& spec) {
  const bool by_tensor = spec.moments || spec.tensor;
  if (!by_tensor && (spec.mass || spec.center_of_mass)) {
    throw input_error(
        "is allowed only with moments or tensor; solids, parts and points have their own")
        .at({{}, 0, spec.mass ? "body.mass" : "body.center_of_mass"});
  }
  if (!by_tensor && spec.about != "center") {
    throw input_error("is allowed only with moments or tensor").at({{}, 0, "body.about"});
  }

  // points, a solid, or parts carry everything
  if (!spec.points.empty()) {
    std::vector<PointMass> points;
    for (const PointSpec& point : spec.points)
      points.push_back({point.m, point.at});
    return of_points(points);
  }
  if (spec.solid) return mass_properties(*spec.solid, "body.solid");
  if (!spec.parts.empty()) {
    std::vector<MassProperties> parts;
    for (std::size_t i = 0; i < spec.parts.size(); ++i) {
      parts.push_back(mass_properties(spec.parts[i], fmt::format("body.parts[{}]", i)));
    }
    return composed(parts);
  }

  // a tensor about the pivot is carried back to the centre of mass
  MassProperties body{
      spec.mass.value_or(1.0), spec.center_of_mass.value_or(Vec3::Zero()), given_tensor(spec)};
  if (spec.about == "pivot") {
    body.tensor -= steiner_tensor(body.mass, body.center - spec.pivot);
    const Vec3 left = Eigen::SelfAdjointEigenSolver<Mat3>(body.tensor).eigenvalues();
    if (!spec.mathematical && left.minCoeff() < -1e-9 * given_tensor(spec).trace()) {
      throw input_error(
          "about the pivot they are too small for the mass ({} kg) and its distance "
          "from the pivot ({} m)",
          body.mass,
          (body.center - spec.pivot).norm())
          .at({{}, 0, tensor_key(spec)});
    }
  }
  return body;
}

BodyModel make_model(const BodySpec& spec,
                     bool on_pivot,
                     const Vec3& gravity_S,
                     const std::vector<LoadSpec>& loads,
                     bool finely) {
  const double equal = finely ? kSameMoments : kEqualMoments;
  BodyModel model;
  model.body = mass_properties(spec);
  model.on_pivot = on_pivot;
  model.pivot_B = spec.pivot;
  model.gravity_S = gravity_S;

  // principal frame about the point the body turns about; a tensor given about that very point is
  // used as it stands, so that no digit is lost by moving it there and back
  const bool as_given = on_pivot && spec.about == "pivot";
  const Mat3 tensor = as_given   ? given_tensor(spec)
                      : on_pivot ? tensor_about(model.body, spec.pivot)
                                 : model.body.tensor;
  find_principal_frame(tensor, equal, model.R_BP, model.moments);
  refuse_impossible(model.moments, spec, on_pivot ? "about the pivot" : "about the centre of mass");
  model.kind = classify(model.moments, equal);
  model.left_out = left_out_by(model.kind, model.R_BP.transpose() * tensor * model.R_BP);
  model.moments_off = rounding_of_moments(spec, tensor);
  if (!as_given && spec.about == "pivot")
    model.moments_off += kFewRoundings * given_tensor(spec).cwiseAbs().maxCoeff();
  const double least = kEqualMoments * model.moments.maxCoeff();
  for (int i = 0; i < 3; ++i) {
    if (model.moments[i] <= least) model.moments[i] = 0.0;
    model.inverse_moments[i] = model.moments[i] > 0.0 ? 1.0 / model.moments[i] : 0.0;
  }

  // gravity turns only a body that is held away from its centre of mass, by more than round-off
  const double g = gravity_S.norm();
  if (g > 0.0) model.up_S = -gravity_S / g;
  const Vec3 arm = model.body.center - spec.pivot;
  const double gyration = std::sqrt(model.moments.maxCoeff() / model.body.mass);
  const double places = model.body.center.norm() + spec.pivot.norm();
  // a centre that is given has no round-off
  const bool is_given = spec.moments || spec.tensor;
  model.lever_off = is_given ? 0.0 : kFewRoundings * (places + gyration);
  const double noise = finely ? model.lever_off : kNoArm * (places + (is_given ? 0.0 : gyration));
  if (on_pivot && arm.norm() > noise) {
    model.chi_P = model.R_BP.transpose() * (model.body.mass * g * arm);
  } else if (on_pivot) {
    model.torque_left_out = model.body.mass * g * arm.norm();
  }
  const double no_arm = finely ? (is_given ? 0.0 : kFewRoundings) : kNoArm;
  model.loads = make_loads(
      loads, on_pivot, model.body.center, model.reference_B(), model.R_BP, model.moments, no_arm);
  model.torque_left_out += model.loads.left_out;
  refuse_torque_about_line(model);
  return model;
}

BodyModel moved_by_rounding(BodyModel model) {
  Vec3 signs(1.0, -1.0, 1.0);
  if (model.kind.symmetric()) {
    signs.setConstant(-1.0);
    signs[model.kind.axis] = 1.0;
  } else if (model.kind.shape == TopKind::Shape::spherical) {
    signs.setOnes();
  }
  for (int i = 0; i < 3; ++i) {
    double& moment = model.moments[i];
    if (moment == 0.0) continue;
    moment += signs[i] * std::min(model.moments_off, 0.5 * moment);
    model.inverse_moments[i] = 1.0 / moment;
  }
  for (std::vector<Load>* loads : {&model.loads.turning, &model.loads.listed}) {
    for (Load& load : *loads)
      load.moments = model.moments;
  }
  const double arm = (model.body.center - model.pivot_B).norm();
  if (model.lever_off > 0.0 && arm > 0.0) model.chi_P *= 1.0 + model.lever_off / arm;
  return model;
}

Vec3 torque_of_loads(const BodyModel& m, double t, const State& s) {
  const Vec3 w_P = angular_velocity(m, s.y);
  return wrench_of(m.loads.turning, t, s.q, s.y, w_P, s.place_S).torque_P;
}

Vec3 torque(const BodyModel& m, double t, const State& s) {
  Vec3 sum = up_in_body(m, s.q).cross(m.chi_P) + torque_of_loads(m, t, s);
  if (m.loads.gimbals) sum += torque_of_rings(*m.loads.gimbals, s.rings, m.moments, sum);
  return sum;
}

std::optional<Vec3> frame_rotation_of(const BodyModel& m) {
  for (const Load& load : m.loads.turning) {
    if (load.kind == Load::Kind::frame) return load.vector;
  }
  return {};
}

void set_rings(const BodyModel& m, const GimbalPose& rings, State& s) {
  const Quat q = attitude_of(*m.loads.gimbals, rings.angles);
  s.q = q.dot(s.q) < 0.0 ? Quat(-q.coeffs()) : q;
  s.y = m.moments.cwiseProduct(angular_velocity_of(*m.loads.gimbals, rings));
  s.rings = rings;
}

Vec3 force(const BodyModel& m, double t, const State& s) {
  const Vec3 w_P = angular_velocity(m, s.y);
  Vec3 sum =
      m.body.mass * m.gravity_S + wrench_of(m.loads.turning, t, s.q, s.y, w_P, s.place_S).force_S;
  for (const Push& push : m.loads.pushes)
    sum += push.at(t);
  return sum;
}

double energy(const BodyModel& m, const State& s) {
  double sum = 0.5 * s.y.dot(angular_velocity(m, s.y)) + m.chi_P.dot(up_in_body(m, s.q)) +
               potential_of(m.loads.turning, s.q, s.place_S);
  if (m.loads.gimbals) {
    sum += kinetic_energy_of_gimbals(m, s) + frame_potential(*m.loads.gimbals, s.rings.angles);
  }
  if (!m.with_translation) return sum;
  return sum + 0.5 * s.linear_momentum_S.squaredNorm() / m.body.mass +
         potential_of_place(m, s.place_S);
}

double power_of_loads(const BodyModel& m, double t, const State& s) {
  const Vec3 w_P = angular_velocity(m, s.y);
  Wrench sum;
  for (const Load& load : m.loads.turning) {
    if (!load.conservative()) add_wrench(load, t, s.q, s.y, w_P, s.place_S, sum);
  }
  for (const Push& push : m.loads.pushes) {
    if (push.rate != 0.0) sum.force_S += push.at(t);
  }
  return sum.torque_P.dot(w_P) + sum.force_S.dot(s.linear_momentum_S) / m.body.mass;
}

double kinetic_energy_of_gimbals(const BodyModel& m, const State& s) {
  if (!m.loads.gimbals) return 0.0;
  return kinetic_energy(*m.loads.gimbals, s.rings);
}

double potential_of_place(const BodyModel& m, const Vec3& center_S) {
  double sum = -m.body.mass * m.gravity_S.dot(center_S);
  for (const Push& push : m.loads.pushes)
    sum -= push.rate == 0.0 ? push.force_S.dot(center_S) : 0.0;
  return sum;
}

bool keeps_energy(const BodyModel& m) {
  const auto& turning = m.loads.turning;
  const auto& pushes = m.loads.pushes;
  if (m.loads.gimbals && !m.loads.gimbals->friction.isZero(0.0)) return false;
  if (m.table && !m.table->friction.keeps_energy()) return false;
  return std::all_of(
             turning.begin(), turning.end(), [](const Load& l) { return l.conservative(); }) &&
         (!m.with_translation ||
          std::all_of(pushes.begin(), pushes.end(), [](const Push& p) { return p.rate == 0.0; }));
}

bool keeps_momentum(const BodyModel& m) {
  return !m.loads.turn_body() && !m.table;
}

bool center_on_symmetry_axis(const BodyModel& model) {
  if (!model.kind.symmetric()) return false;
  Vec3 aside = model.chi_P;
  aside[model.kind.axis] = 0.0;
  return aside.norm() <= kEqualMoments * model.chi_P.norm();
}

}  // namespace polhode
