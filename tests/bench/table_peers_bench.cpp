// SPDX-License-Identifier: MIT
// Bullet and ODE on the tippe top and the rolling disc of the shipped scenes, on the same inputs,
// beside the methods of the stepper table that stand for them: how far the axis points elsewhere
// than in the motion from event to event, and how much the energy is off. docs/performance.md has
// the numbers.
#include <btBulletDynamicsCommon.h>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <ode/ode.h>

#include "math/so3.h"
#include "motion/refinement.h"
#include "motion/solution_method.h"
#include "motion/stepper_table.h"
#include "support/on_table.h"

namespace polhode::bench {
namespace {

// The engines are told lengths in centimetres: their thresholds are for bodies as large as people.
constexpr double kUnits = 100.0;          // per metre
constexpr double kDiscThickness = 0.002;  // m
constexpr double kMu = 0.3;
constexpr int kLooks = 50;

// What is compared: the state at equally spaced times.
using Run = std::vector<State>;

struct Case {
  std::string name;
  BodySpec body;
  MotionSpec motion;
  double radius;         // of sphere or disc, m
  double center_height;  // of the sphere's centre above the centre of mass, along the axis, m
  bool is_disc;
  BodyModel model() const { return with_needed_degrees(make_model(body, motion)); }
};

Case tippe_top() {
  Case c{"tippe top of scenes/tippe_top.toml, dry friction 0.3, 3 s",
         test::tippe_top_body(0.2, 7.8 / 7.2),
         test::on_table(3.0, test::coulomb(kMu)),
         0.02,
         0.004,
         false};
  c.motion.attitude.tilt = 5.0 * kPi / 180.0;
  c.motion.spin.body = Vec3(0, 0, 160);
  return c;
}

Case disc() {
  Case c{"disc that rolls in a circle and wobbles, radius 37.5 mm, 2 mm thick, dry friction 1, 3 s",
         test::disc_body(),
         test::on_table(3.0, test::coulomb(1.0)),
         0.0375,
         0.0,
         true};
  c.body.solid->thickness = kDiscThickness;
  c.motion.attitude.zxz = Vec3(0, 80.0 * kPi / 180.0, 0);
  c.motion.spin.rates = Vec3(2, 0, 18);
  return c;
}

double friction_of(const Case& c) {
  return *c.motion.friction->mu;
}

std::vector<double> looks_of(const Case& c) {
  std::vector<double> times;
  for (int i = 0; i <= kLooks; ++i)
    times.push_back(c.motion.duration * i / kLooks);
  return times;
}

// advances by h, and reads the state in SI units
struct Engine {
  std::function<void(double h)> advance;
  std::function<State()> read;
};

Run run_engine(const Case& c, const Engine& engine, double h) {
  Run run;
  double t = 0.0;
  for (const double look : looks_of(c)) {
    for (; t + 0.5 * h < look; t += h)
      engine.advance(h);
    run.push_back(engine.read());
  }
  return run;
}

btVector3 to_bullet(const Vec3& v) {
  return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())};
}

Run run_bullet(const Case& c, double h) {
  const BodyModel model = c.model();
  const State start = start_state(model, c.motion);
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(to_bullet(kUnits * model.gravity_S));
  btStaticPlaneShape plane(btVector3(0, 0, 1), 0);
  btRigidBody table(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane));
  table.setFriction(1.0);
  world.addRigidBody(&table);
  btSphereShape sphere(kUnits * c.radius);
  btCylinderShapeZ cylinder(
      btVector3(kUnits * c.radius, kUnits * c.radius, 0.5 * kUnits * kDiscThickness));
  cylinder.setMargin(0.01 * kUnits * kDiscThickness);
  btCompoundShape shape;
  btTransform place;
  place.setIdentity();
  place.setOrigin(btVector3(0, 0, kUnits * c.center_height));
  shape.addChildShape(place, c.is_disc ? static_cast<btCollisionShape*>(&cylinder) : &sphere);
  const Quat q = start.q;
  btDefaultMotionState pose(
      btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), to_bullet(kUnits * start.place_S)));
  btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(
      model.body.mass, &pose, &shape, to_bullet(kUnits * kUnits * model.moments)));
  body.setFriction(friction_of(c));
  body.setRestitution(0);
  body.setDamping(0, 0);
  body.setActivationState(DISABLE_DEACTIVATION);
  body.setLinearVelocity(to_bullet(kUnits / model.body.mass * start.linear_momentum_S));
  body.setAngularVelocity(to_bullet(q * angular_velocity(model, start.y)));
  world.addRigidBody(&body);
  const auto read = [&] {
    State s;
    const btTransform& now = body.getWorldTransform();
    const btQuaternion r = now.getRotation();
    s.q = Quat(r.w(), r.x(), r.y(), r.z()).normalized();
    const auto to_vec = [](const btVector3& v) {
      return Vec3(v.x(), v.y(), v.z());
    };
    s.place_S = to_vec(now.getOrigin()) / kUnits;
    s.linear_momentum_S = model.body.mass / kUnits * to_vec(body.getLinearVelocity());
    s.y = model.moments.cwiseProduct(s.q.conjugate() * to_vec(body.getAngularVelocity()));
    return s;
  };
  const Run run = run_engine(c, {[&](double step) { world.stepSimulation(step, 0); }, read}, h);
  world.removeRigidBody(&body);
  world.removeRigidBody(&table);
  return run;
}

struct OdeContacts {
  dWorldID world;
  dJointGroupID joints;
  double mu;
};

void collide(void* data, dGeomID one, dGeomID other) {
  const auto& contacts = *static_cast<const OdeContacts*>(data);
  constexpr int kMost = 8;
  dContact found[kMost];
  const int n = dCollide(one, other, kMost, &found[0].geom, sizeof(dContact));
  for (int i = 0; i < n; ++i) {
    found[i].surface = {};
    found[i].surface.mode = dContactApprox1;
    found[i].surface.mu = contacts.mu;
    const dJointID joint = dJointCreateContact(contacts.world, contacts.joints, &found[i]);
    dJointAttach(joint, dGeomGetBody(one), dGeomGetBody(other));
  }
}

Run run_ode(const Case& c, double h) {
  const BodyModel model = c.model();
  const State start = start_state(model, c.motion);
  dWorldID world = dWorldCreate();
  dSpaceID space = dSimpleSpaceCreate(nullptr);
  dCreatePlane(space, 0, 0, 1, 0);
  OdeContacts contacts{world, dJointGroupCreate(0), friction_of(c)};
  const Vec3 gravity = kUnits * model.gravity_S;
  dWorldSetGravity(world, gravity.x(), gravity.y(), gravity.z());
  dBodyID body = dBodyCreate(world);
  dMass mass;
  const Vec3 moments = kUnits * kUnits * model.moments;
  dMassSetParameters(
      &mass, model.body.mass, 0, 0, 0, moments.x(), moments.y(), moments.z(), 0, 0, 0);
  dBodySetMass(body, &mass);
  dGeomID geom = c.is_disc ? dCreateCylinder(space, kUnits * c.radius, kUnits * kDiscThickness)
                           : dCreateSphere(space, kUnits * c.radius);
  dGeomSetBody(geom, body);
  dGeomSetOffsetPosition(geom, 0, 0, kUnits * c.center_height);
  const Vec3 at = kUnits * start.place_S, w = start.q * angular_velocity(model, start.y);
  const Vec3 v = kUnits / model.body.mass * start.linear_momentum_S;
  const dQuaternion q = {start.q.w(), start.q.x(), start.q.y(), start.q.z()};
  dBodySetPosition(body, at.x(), at.y(), at.z());
  dBodySetQuaternion(body, q);
  dBodySetLinearVel(body, v.x(), v.y(), v.z());
  dBodySetAngularVel(body, w.x(), w.y(), w.z());
  dBodySetAutoDisableFlag(body, 0);
  const auto advance = [&](double step) {
    dSpaceCollide(space, &contacts, collide);
    dWorldStep(world, step);
    dJointGroupEmpty(contacts.joints);
  };
  const auto read = [&] {
    const auto to_vec = [](const dReal* a) {
      return Vec3(a[0], a[1], a[2]);
    };
    State s;
    const dReal* r = dBodyGetQuaternion(body);
    s.q = Quat(r[0], r[1], r[2], r[3]).normalized();
    s.place_S = to_vec(dBodyGetPosition(body)) / kUnits;
    s.linear_momentum_S = model.body.mass / kUnits * to_vec(dBodyGetLinearVel(body));
    s.y = model.moments.cwiseProduct(s.q.conjugate() * to_vec(dBodyGetAngularVel(body)));
    return s;
  };
  const Run run = run_engine(c, {advance, read}, h);
  dJointGroupDestroy(contacts.joints);
  dSpaceDestroy(space);
  dWorldDestroy(world);
  return run;
}

Run run_method(const Case& c, const std::string& method, double fineness) {
  const BodyModel model = c.model();
  const Integration found = integrate_with(
      find_stepper(method), model, start_state(model, c.motion), c.motion.duration, fineness);
  Run run;
  for (const double t : looks_of(c))
    run.push_back(found.trajectory->at(t));
  return run;
}

// the largest angle between axes, and the largest difference of energies over that at the start
void tell(const Case& c, const std::string& name, double h, const Run& run, const Run& truth) {
  const BodyModel model = c.model();
  const double scale = std::abs(energy(model, truth.front()));
  double angle = 0.0, off = 0.0;
  for (std::size_t i = 0; i < run.size(); ++i) {
    angle = std::max(angle, angle_between(run[i].q * Vec3::UnitZ(), truth[i].q * Vec3::UnitZ()));
    off = std::max(off, std::abs(energy(model, run[i]) - energy(model, truth[i])) / scale);
  }
  const double end = angle_between(run.back().q * Vec3::UnitZ(), Vec3::UnitZ());
  std::printf("%-22s %10.3g %10.1f %12.2e %10.1f\n",
              name.c_str(),
              h,
              angle * 180.0 / kPi,
              off,
              end * 180.0 / kPi);
}

void compare(const Case& c) {
  const Run truth = run_method(c, "dop853", 1e-12);
  std::printf("\n%s\n%-22s %10s %10s %12s %10s\n",
              c.name.c_str(),
              "method",
              "step, s",
              "axis, deg",
              "energy",
              "end, deg");
  tell(c, "polhode, tolerance", 1e-8, run_method(c, "dop853", 1e-8), truth);
  for (const double h : {1.0 / 60.0, 1.0 / 240.0, 1e-3, 1e-4}) {
    tell(c, "Bullet", h, run_bullet(c, h), truth);
    tell(c, "ODE", h, run_ode(c, h), truth);
    tell(c, "table_baumgarte", h, run_method(c, "table_baumgarte", h), truth);
  }
}

}  // namespace
}  // namespace polhode::bench

int main() {
  dInitODE2(0);
  polhode::bench::compare(polhode::bench::tippe_top());
  polhode::bench::compare(polhode::bench::disc());
  dCloseODE();
}
