// The interface of kinematics in ros2_control (its branches for Jazzy and Rolling), for tests without ROS.
#ifndef STUB_KINEMATICS_INTERFACE_HPP
#define STUB_KINEMATICS_INTERFACE_HPP
#include <memory>
#include <string>
#if __has_include(<eigen3/Eigen/Core>)
#pragma GCC system_header
#include <eigen3/Eigen/Core>
#include <eigen3/Eigen/Geometry>
#else
#include <vector>
namespace Eigen {  // as much of Eigen as is used
using Index = std::ptrdiff_t;
constexpr int Dynamic = -1;
template <typename Scalar, int Rows, int Columns>
class Matrix {
public:
    Matrix() : rows_(Rows > 0 ? Rows : 0), columns_(Columns > 0 ? Columns : 0) { entries_.resize(count()); }
    explicit Matrix(Index size) : Matrix() { resize(size); }
    Scalar &operator()(Index k) { return entries_.at(static_cast<std::size_t>(k)); }
    const Scalar &operator()(Index k) const { return entries_.at(static_cast<std::size_t>(k)); }
    Scalar &operator()(Index i, Index j) { return entries_.at(static_cast<std::size_t>(i + j * rows_)); }
    Index size() const { return rows_ * columns_; }
    Index rows() const { return rows_; }
    Index cols() const { return columns_; }
    void resize(Index size) { resize(size, 1); }
    void resize(Index rows, Index columns)
    {
        rows_ = rows;
        columns_ = columns;
        entries_.resize(count());
    }

private:
    std::size_t count() const { return static_cast<std::size_t>(rows_ * columns_); }
    Index rows_, columns_;
    std::vector<Scalar> entries_;
};
using VectorXd = Matrix<double, Dynamic, 1>;
class Isometry3d {
public:
    double &operator()(Index i, Index j) { return entries_[i][j]; }
    void setIdentity()
    {
        for (Index i = 0; i < 4; ++i) {
            for (Index j = 0; j < 4; ++j) {
                entries_[i][j] = i == j ? 1.0 : 0.0;
            }
        }
    }

private:
    double entries_[4][4] = {};
};
}  // namespace Eigen
#endif
namespace rclcpp::node_interfaces {
class NodeParametersInterface {};
}  // namespace rclcpp::node_interfaces
namespace kinematics_interface {
class KinematicsInterface {
public:
    virtual ~KinematicsInterface() = default;
    virtual bool initialize(const std::string &robot_description,
                            std::shared_ptr<rclcpp::node_interfaces::NodeParametersInterface> parameters_interface,
                            const std::string &param_namespace) = 0;
    virtual bool convert_cartesian_deltas_to_joint_deltas(const Eigen::VectorXd &joint_pos,
                                                          const Eigen::Matrix<double, 6, 1> &delta_x,
                                                          const std::string &link_name, Eigen::VectorXd &delta_theta) = 0;
    virtual bool convert_joint_deltas_to_cartesian_deltas(const Eigen::VectorXd &joint_pos,
                                                          const Eigen::VectorXd &delta_theta,
                                                          const std::string &link_name,
                                                          Eigen::Matrix<double, 6, 1> &delta_x) = 0;
    virtual bool calculate_link_transform(const Eigen::VectorXd &joint_pos, const std::string &link_name,
                                          Eigen::Isometry3d &transform) = 0;
    virtual bool calculate_jacobian(const Eigen::VectorXd &joint_pos, const std::string &link_name,
                                    Eigen::Matrix<double, 6, Eigen::Dynamic> &jacobian) = 0;
    virtual bool calculate_jacobian_inverse(const Eigen::VectorXd &joint_pos, const std::string &link_name,
                                            Eigen::Matrix<double, Eigen::Dynamic, 6> &jacobian_inverse) = 0;
    virtual bool calculate_frame_difference(Eigen::Matrix<double, 7, 1> &x_a, Eigen::Matrix<double, 7, 1> &x_b, double dt,
                                            Eigen::Matrix<double, 6, 1> &delta_x) = 0;
};
}  // namespace kinematics_interface
#endif
