// SPDX-License-Identifier: MIT
#include "peers.h"

#include <cmath>
#include <memory>

#include <boost/numeric/odeint.hpp>
#include <cvode/cvode.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "math/so3.h"

namespace polhode::bench {
namespace {

namespace odeint = boost::numeric::odeint;

PeerState boost_rk4(const PeerProblem& p, double steps) {
  PeerState x = p.start;
  odeint::runge_kutta4<PeerState> method;
  const auto f = [&](const PeerState& s, PeerState& ds, double) {
    p.rate(s, ds);
  };
  const auto n = static_cast<std::size_t>(steps);
  odeint::integrate_n_steps(method, f, x, 0.0, p.duration / steps, n);
  return x;
}

template <class Method>
PeerState boost_adaptive(Method method, const PeerProblem& p) {
  PeerState x = p.start;
  const auto f = [&](const PeerState& s, PeerState& ds, double) {
    p.rate(s, ds);
  };
  odeint::integrate_adaptive(method, f, x, 0.0, p.duration, 0.01);
  return x;
}

PeerState boost_dopri5(const PeerProblem& p, double tolerance) {
  return boost_adaptive(
      odeint::make_controlled<odeint::runge_kutta_dopri5<PeerState>>(tolerance, tolerance), p);
}

PeerState boost_rkf78(const PeerProblem& p, double tolerance) {
  return boost_adaptive(
      odeint::make_controlled<odeint::runge_kutta_fehlberg78<PeerState>>(tolerance, tolerance), p);
}

PeerState boost_bulirsch_stoer(const PeerProblem& p, double tolerance) {
  return boost_adaptive(odeint::bulirsch_stoer<PeerState>(tolerance, tolerance), p);
}

PeerState gsl_rk8pd(const PeerProblem& p, double tolerance) {
  const auto f = [](double, const double* x, double* dx, void* data) {
    PeerState in, out;
    std::copy(x, x + 7, in.begin());
    static_cast<const PeerProblem*>(data)->rate(in, out);
    std::copy(out.begin(), out.end(), dx);
    return static_cast<int>(GSL_SUCCESS);
  };
  gsl_odeiv2_system system{f, nullptr, 7, const_cast<PeerProblem*>(&p)};
  gsl_odeiv2_driver* driver =
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 0.01, tolerance, tolerance);
  PeerState x = p.start;
  double t = 0.0;
  gsl_odeiv2_driver_apply(driver, &t, p.duration, x.data());
  gsl_odeiv2_driver_free(driver);
  return x;
}

PeerState sundials_cvode(const PeerProblem& p, double tolerance) {
  static SUNContext context = [] {
    SUNContext made = nullptr;
    SUNContext_Create(nullptr, &made);
    return made;
  }();
  const auto f = [](double, N_Vector x, N_Vector dx, void* data) {
    PeerState in, out;
    std::copy(NV_DATA_S(x), NV_DATA_S(x) + 7, in.begin());
    static_cast<const PeerProblem*>(data)->rate(in, out);
    std::copy(out.begin(), out.end(), NV_DATA_S(dx));
    return 0;
  };
  N_Vector x = N_VNew_Serial(7, context);
  std::copy(p.start.begin(), p.start.end(), NV_DATA_S(x));
  void* solver = CVodeCreate(CV_ADAMS, context);
  CVodeInit(solver, f, 0.0, x);
  CVodeSStolerances(solver, tolerance, tolerance);
  CVodeSetUserData(solver, const_cast<PeerProblem*>(&p));
  CVodeSetMaxNumSteps(solver, 10'000'000);
  SUNNonlinearSolver iteration = SUNNonlinSol_FixedPoint(x, 0, context);
  CVodeSetNonlinearSolver(solver, iteration);
  CVodeSetStopTime(solver, p.duration);
  double t = 0.0;
  CVode(solver, p.duration, x, &t, CV_NORMAL);
  PeerState end;
  std::copy(NV_DATA_S(x), NV_DATA_S(x) + 7, end.begin());
  SUNNonlinSolFree(iteration);
  CVodeFree(&solver);
  N_VDestroy(x);
  return end;
}

}  // namespace

PeerProblem::PeerProblem(const BodyModel& model, const State& s, double T)
    : moments(model.moments),
      chi(model.chi_P),
      up(model.up_S),
      heavy(model.chi_P.squaredNorm() > 0.0),
      duration(T) {
  const Vec3 w = angular_velocity(model, s.y);
  start = {w[0], w[1], w[2], s.q.w(), s.q.x(), s.q.y(), s.q.z()};
}

void PeerProblem::rate(const PeerState& x, PeerState& dx) const {
  const double a = x[0], b = x[1], c = x[2];
  dx[0] = (moments[1] - moments[2]) / moments[0] * b * c;
  dx[1] = (moments[2] - moments[0]) / moments[1] * c * a;
  dx[2] = (moments[0] - moments[1]) / moments[2] * a * b;
  const double w = x[3], p = x[4], q = x[5], r = x[6];
  if (heavy) {
    // up in the body, for up = e3
    const Vec3 gamma(2.0 * (p * r - w * q), 2.0 * (q * r + w * p), w * w - p * p - q * q + r * r);
    dx[0] += (gamma[1] * chi[2] - gamma[2] * chi[1]) / moments[0];
    dx[1] += (gamma[2] * chi[0] - gamma[0] * chi[2]) / moments[1];
    dx[2] += (gamma[0] * chi[1] - gamma[1] * chi[0]) / moments[2];
  }
  dx[3] = 0.5 * (-p * a - q * b - r * c);
  dx[4] = 0.5 * (w * a + q * c - r * b);
  dx[5] = 0.5 * (w * b + r * a - p * c);
  dx[6] = 0.5 * (w * c + p * b - q * a);
}

State to_state(const PeerProblem& problem, const PeerState& x) {
  State s;
  s.q = normalized(Quat(x[3], x[4], x[5], x[6]));
  s.y = problem.moments.cwiseProduct(Vec3(x[0], x[1], x[2]));
  return s;
}

const std::vector<Peer>& peers() {
  static const std::vector<Peer> table = {
      {"Boost.odeint rk4", true, boost_rk4},
      {"Boost.odeint dopri5", false, boost_dopri5},
      {"Boost.odeint rkf78", false, boost_rkf78},
      {"Boost.odeint bulirsch_stoer", false, boost_bulirsch_stoer},
      {"GSL rk8pd", false, gsl_rk8pd},
      {"SUNDIALS CVODE Adams", false, sundials_cvode},
  };
  return table;
}

}  // namespace polhode::bench
