// Inverse dynamics by Pinocchio: RNEA of the tree, and for closed chains drives of least norm.
//
// The tree has the platform's joint first, then limb by limb three coordinates; each limb ends in a joint
// that holds a point (three rows) and, for a universal joint, one relative rotation (one more row).
// Dense: frame Jacobians of the cut joints, one LU over all limbs. Structured: only the columns of each limb,
// from the world Jacobian that Pinocchio has computed, 3x3 inverses.

#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody.hpp>

#include <Eigen/Dense>
#include <chrono>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace pin = pinocchio;
using Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

struct Cut {
  pin::JointIndex tip, hub;
  pin::FrameIndex tip_frame, hub_frame;
  Vector3d tip_point, hub_point, tip_axis, hub_axis;
  bool rotation;  // the axes stay perpendicular
};

struct Case {
  pin::Model model;
  std::unique_ptr<pin::Data> data;
  std::vector<Cut> cuts;
  int drive_in_limb = 0;  // which of the limb's three coordinates is driven
  virtual ~Case() = default;
  virtual void evaluate(const VectorXd &q, const VectorXd &v, const VectorXd &a, bool structured, double *u) {
    (void)structured;
    Eigen::Map<VectorXd>(u, model.nv) = pin::rnea(model, *data, q, v, a);
  }
  virtual int drives() const { return model.nv; }
};

// LIMBS limbs of three coordinates around a platform of HUB freedoms; ROTATIONS of the cut joints are universal.
template <int LIMBS, int HUB, int ROTATIONS> struct Closed : Case {
  static constexpr int N = 3 * LIMBS, NV = HUB + N;
  using Jacobian = Eigen::Matrix<double, 6, NV>;
  using LimbRates = Eigen::Matrix<double, N, HUB>;  // rates of the limbs per rate of the platform
  Jacobian tip, hub;

  int drives() const override { return LIMBS; }

  void evaluate(const VectorXd &q, const VectorXd &v, const VectorXd &a, bool structured, double *u) override {
    const VectorXd &tau = pin::rnea(model, *data, q, v, a);
    pin::computeJointJacobians(model, *data, q);
    LimbRates rates;
    Eigen::Matrix<double, 1, HUB> lock = Eigen::Matrix<double, 1, HUB>::Zero();
    if (structured) {
      limb_by_limb(rates, lock);
    } else {
      dense(rates, lock);
    }
    Eigen::Matrix<double, LIMBS, HUB> driven;
    for (int k = 0; k < LIMBS; ++k) {
      driven.row(k) = rates.row(3 * k + drive_in_limb);
    }
    const Eigen::Matrix<double, HUB, 1> wanted =
        tau.template head<HUB>() + rates.transpose() * tau.template tail<N>();
    Eigen::Map<Eigen::Matrix<double, LIMBS, 1>> result(u);
    if constexpr (ROTATIONS == 1) {
      // Only motions that the rotation constraint admits do work: two directions across `lock`.
      Vector3d c = lock.transpose();
      int smallest;
      c.cwiseAbs().minCoeff(&smallest);
      Eigen::Matrix<double, 3, 2> free;
      free.col(0) = c.cross(Vector3d::Unit(smallest)).normalized();
      free.col(1) = c.cross(free.col(0)).normalized();
      const Eigen::Matrix<double, LIMBS, 2> columns = driven * free;
      const Eigen::Matrix2d normal = columns.transpose() * columns;
      result = columns * (normal.inverse() * (free.transpose() * wanted));
    } else if constexpr (LIMBS == HUB) {
      result = driven.transpose().partialPivLu().solve(wanted);
    } else {
      const Eigen::Matrix<double, HUB, HUB> normal = driven.transpose() * driven;
      result = driven * normal.llt().solve(wanted);
    }
  }

  void dense(LimbRates &rates, Eigen::Matrix<double, 1, HUB> &lock) {
    Eigen::Matrix<double, N, N> left;
    LimbRates right;
    pin::updateFramePlacements(model, *data);
    Eigen::Matrix<double, 1, NV> row;
    for (int k = 0; k < LIMBS; ++k) {
      const Cut &cut = cuts[static_cast<size_t>(k)];
      tip.setZero();
      hub.setZero();
      pin::getFrameJacobian(model, *data, cut.tip_frame, pin::LOCAL_WORLD_ALIGNED, tip);
      pin::getFrameJacobian(model, *data, cut.hub_frame, pin::LOCAL_WORLD_ALIGNED, hub);
      left.template middleRows<3>(3 * k) = tip.template topRightCorner<3, N>();
      right.template middleRows<3>(3 * k) = hub.template topLeftCorner<3, HUB>();
      if (cut.rotation) {
        row = couple(cut).transpose() * (hub - tip).template bottomRows<3>();
      }
    }
    rates = left.partialPivLu().solve(right);
    if constexpr (ROTATIONS == 1) {
      lock = row.template head<HUB>() + row.template tail<N>() * rates;
    }
  }

  void limb_by_limb(LimbRates &rates, Eigen::Matrix<double, 1, HUB> &lock) {
    const auto &J = data->J;
    for (int k = 0; k < LIMBS; ++k) {
      const Cut &cut = cuts[static_cast<size_t>(k)];
      const Vector3d p = data->oMi[cut.tip].act(cut.tip_point);
      Matrix3d left;
      for (int i = 0; i < 3; ++i) {
        const auto column = J.col(HUB + 3 * k + i);
        left.col(i) = column.template head<3>() + column.template tail<3>().cross(p);
      }
      Eigen::Matrix<double, 3, HUB> right;
      for (int i = 0; i < HUB; ++i) {
        const auto column = J.col(i);
        right.col(i) = column.template head<3>() + column.template tail<3>().cross(p);
      }
      rates.template middleRows<3>(3 * k) = left.inverse() * right;
      if (cut.rotation) {
        const Vector3d n = couple(cut);
        lock = n.transpose() * J.template bottomLeftCorner<3, HUB>();
        lock -= (n.transpose() * J.template block<3, 3>(3, HUB + 3 * k)) * rates.template middleRows<3>(3 * k);
      }
    }
  }

  Vector3d couple(const Cut &cut) const {
    const Vector3d at_tip = data->oMi[cut.tip].rotation() * cut.tip_axis;
    return at_tip.cross(data->oMi[cut.hub].rotation() * cut.hub_axis);
  }
};

static std::unique_ptr<Case> make(int limbs, int hub, int rotations) {
  if (limbs == 0) return std::make_unique<Case>();
  if (limbs == 4 && hub == 3 && rotations == 1) return std::make_unique<Closed<4, 3, 1>>();
#ifndef WITHOUT_HEXAPODS  // a third of the time to compile
  if (limbs == 6 && hub == 6 && rotations == 0) return std::make_unique<Closed<6, 6, 0>>();
#endif
  return nullptr;
}

static Matrix3d matrix(std::istream &in) {
  Matrix3d m;
  for (int i = 0; i < 9; ++i) in >> m(i / 3, i % 3);
  return m;
}

static Vector3d vector(std::istream &in) {
  Vector3d x;
  in >> x[0] >> x[1] >> x[2];
  return x;
}

extern "C" {

// The case that a text file describes (written by pinocchio_tree.py), or NULL.
void *pinocchio_open(const char *path) {
  std::ifstream in(path);
  int joints = 0, limbs = 0, hub = 0, rotations = 0, drive = 0;
  in >> joints >> limbs >> hub >> rotations >> drive;
  auto made = make(limbs, hub, rotations);
  if (!made) return nullptr;
  made->drive_in_limb = drive;
  pin::Model &model = made->model;
  for (int k = 0; k < joints; ++k) {
    std::string kind;
    pin::JointIndex parent;
    in >> kind >> parent;
    const Matrix3d turn = matrix(in);
    const pin::SE3 placement(turn, vector(in));
    double mass;
    in >> mass;
    const Vector3d centre = vector(in);
    const pin::Inertia inertia(mass, centre, matrix(in));
    const std::string name = "joint" + std::to_string(k + 1);
    pin::JointIndex index = 0;
    if (kind == "R") index = model.addJoint(parent, pin::JointModelRZ(), placement, name);
    if (kind == "P") index = model.addJoint(parent, pin::JointModelPZ(), placement, name);
    if (kind == "S") index = model.addJoint(parent, pin::JointModelSpherical(), placement, name);
    if (kind == "free") index = model.addJoint(parent, pin::JointModelFreeFlyer(), placement, name);
    model.appendBodyToJoint(index, inertia, pin::SE3::Identity());
  }
  for (int k = 0; k < limbs; ++k) {
    Cut cut;
    int rotation = 0;
    in >> cut.tip >> cut.hub >> rotation;
    cut.rotation = rotation != 0;
    cut.tip_point = vector(in);
    cut.hub_point = vector(in);
    cut.tip_axis = vector(in);
    cut.hub_axis = vector(in);
    const auto frame = [&](const char *side, pin::JointIndex joint, const Vector3d &point) {
      const pin::SE3 place(Matrix3d::Identity(), point);
      return model.addFrame(pin::Frame(side + std::to_string(k), joint, 0, place, pin::OP_FRAME));
    };
    cut.tip_frame = frame("tip", cut.tip, cut.tip_point);
    cut.hub_frame = frame("hub", cut.hub, cut.hub_point);
    made->cuts.push_back(cut);
  }
  if (!in) return nullptr;
  made->data = std::make_unique<pin::Data>(model);
  return made.release();
}

// Nanoseconds per call, as time_single of loops.c; states as Pinocchio wants them.
double pinocchio_time(void *opaque, int structured, size_t rounds, size_t count, const double *q, const double *v,
                      const double *a, double *u) {
  Case &made = *static_cast<Case *>(opaque);
  const auto nq = made.model.nq, nv = made.model.nv;
  const size_t nu = static_cast<size_t>(made.drives());
  std::vector<VectorXd> qs, vs, as;
  for (size_t k = 0; k < count; ++k) {
    qs.push_back(Eigen::Map<const VectorXd>(q + k * static_cast<size_t>(nq), nq));
    vs.push_back(Eigen::Map<const VectorXd>(v + k * static_cast<size_t>(nv), nv));
    as.push_back(Eigen::Map<const VectorXd>(a + k * static_cast<size_t>(nv), nv));
  }
  const auto start = std::chrono::steady_clock::now();
  for (size_t round = 0; round < rounds; ++round) {
    for (size_t k = 0; k < count; ++k) {
      made.evaluate(qs[k], vs[k], as[k], structured != 0, u + k * nu);
      asm volatile("" : : "r"(u) : "memory");
    }
  }
  const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
  return took.count() / static_cast<double>(rounds * count);
}

void pinocchio_close(void *opaque) { delete static_cast<Case *>(opaque); }
}
