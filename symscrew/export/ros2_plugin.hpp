#ifndef @GUARD@_KINEMATICS_PLUGIN_HPP
#define @GUARD@_KINEMATICS_PLUGIN_HPP

#include <array>
#include <cstddef>
#include <memory>
#include <string>

#include "@FILE@_kinematics.hpp"
#include "kinematics_interface/kinematics_interface.hpp"

namespace @SPACE@ {

/* The mechanism for controllers of ros2_control that ask `kinematics_interface`: its joints are the drives, in their order.
   The only link that it knows is the platform, "@PLATFORM@", with the tool as the origin and the axes of the ground at the
   reference. Twists are (v ; omega) in axes of the ground. It follows the mode of the last joints that it was asked about,
   and gives false where no proved steps lead from there, as where anything else fails: nothing is written then. */
class KinematicsPlugin : public kinematics_interface::KinematicsInterface {
public:
    using Vector = Eigen::VectorXd;
    using Twist = Eigen::Matrix<double, 6, 1>;
    using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;
    using Inverse = Eigen::Matrix<double, Eigen::Dynamic, 6>;

    /* What the mechanism is stands in the code: description and parameters are not read. */
    bool initialize(const std::string &, std::shared_ptr<rclcpp::node_interfaces::NodeParametersInterface>,
                    const std::string &) override
    {
        machine_.home();
        initialized_ = true;
        return true;
    }

    bool convert_cartesian_deltas_to_joint_deltas(const Vector &joints, const Twist &twist, const std::string &link,
                                                  Vector &deltas) override
    {
        Kinematics::Drives found{};
        std::array<double, 6> wanted{};
        for (std::size_t i = 0; i < 6; ++i) {
            wanted[i] = twist(index(i));
        }
        if (!moved(joints, link) || machine_.drives_of_twist(wanted, found) != 0) {
            return false;
        }
        deltas.resize(index(Kinematics::drives));
        for (std::size_t k = 0; k < Kinematics::drives; ++k) {
            deltas(index(k)) = found[k];
        }
        return true;
    }

    bool convert_joint_deltas_to_cartesian_deltas(const Vector &joints, const Vector &deltas, const std::string &link,
                                                  Twist &twist) override
    {
        Kinematics::Twists twists{};
        if (deltas.size() != index(Kinematics::drives) || !moved(joints, link) || machine_.twists(twists) != 0) {
            return false;
        }
        for (std::size_t i = 0; i < 6; ++i) {
            double sum = 0.0;
            for (std::size_t j = 0; j < Kinematics::freedoms; ++j) {
                sum += twists[i + 6 * j] * deltas(index(Kinematics::chosen[j]));
            }
            twist(index(i)) = sum;
        }
        return true;
    }

    bool calculate_link_transform(const Vector &joints, const std::string &link, Eigen::Isometry3d &transform) override
    {
        Kinematics::Frame frame{};
        if (!moved(joints, link) || machine_.frame(frame) != 0) {
            return false;
        }
        transform.setIdentity();
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 4; ++j) {
                transform(index(i), index(j)) = frame[i + 3 * j];
            }
        }
        return true;
    }

    /* By the drives that the tool follows from; columns of others are zero. */
    bool calculate_jacobian(const Vector &joints, const std::string &link, Jacobian &jacobian) override
    {
        Kinematics::Twists twists{};
        if (!moved(joints, link) || machine_.twists(twists) != 0) {
            return false;
        }
        jacobian.resize(6, index(Kinematics::drives));
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t k = 0; k < Kinematics::drives; ++k) {
                jacobian(index(i), index(k)) = 0.0;
            }
            for (std::size_t j = 0; j < Kinematics::freedoms; ++j) {
                jacobian(index(i), index(Kinematics::chosen[j])) = twists[i + 6 * j];
            }
        }
        return true;
    }

    /* Drives by twists, of all drives; newer interfaces ask for it. */
    virtual bool calculate_jacobian_inverse(const Vector &joints, const std::string &link, Inverse &inverse)
    {
        if (!moved(joints, link)) {
            return false;
        }
        std::array<Kinematics::Drives, 6> columns{};
        for (std::size_t i = 0; i < 6; ++i) {
            std::array<double, 6> unit{};
            unit[i] = 1.0;
            if (machine_.drives_of_twist(unit, columns[i]) != 0) {
                return false;
            }
        }
        inverse.resize(index(Kinematics::drives), 6);
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t k = 0; k < Kinematics::drives; ++k) {
                inverse(index(k), index(i)) = columns[i][k];
            }
        }
        return true;
    }

    /* The twist that leads from one pose to another, (place ; quaternion x, y, z, w) each, in the time dt [s]. */
    virtual bool calculate_frame_difference(Eigen::Matrix<double, 7, 1> &from, Eigen::Matrix<double, 7, 1> &to, double dt,
                                            Twist &twist)
    {
        if (!initialized_ || !(dt > 0.0)) {
            return false;
        }
        std::array<double, 3> turn{};
        const double w = from(6) * to(6) + from(3) * to(3) + from(4) * to(4) + from(5) * to(5);
        double size = 0.0;
        for (Eigen::Index i = 0; i < 3; ++i) {
            const Eigen::Index j = (i + 1) % 3, k = (i + 2) % 3;
            double part = from(6) * to(3 + i) - to(6) * from(3 + i);
            part -= to(3 + j) * from(3 + k) - to(3 + k) * from(3 + j);
            turn[std::size_t(i)] = part;
            size += part * part;
        }
        size = std::sqrt(size);
        const double angle = 2.0 * std::atan2(w < 0.0 ? -size : size, std::fabs(w)); /* the shorter way */
        for (Eigen::Index i = 0; i < 3; ++i) {
            twist(i) = (to(i) - from(i)) / dt;
            twist(3 + i) = size > 0.0 ? turn[std::size_t(i)] * angle / (size * dt) : 0.0;
        }
        return true;
    }

    Kinematics &kinematics() noexcept { return machine_; }

private:
    static Eigen::Index index(std::size_t k) { return static_cast<Eigen::Index>(k); }

    /* Whether the machine could be led to these joints. */
    bool moved(const Vector &joints, const std::string &link)
    {
        Kinematics::Drives drive{};
        Kinematics::Pose pose{};
        if (!initialized_ || link != "@PLATFORM@" || joints.size() != index(Kinematics::drives)) {
            return false;
        }
        for (std::size_t k = 0; k < Kinematics::drives; ++k) {
            drive[k] = joints(index(k));
        }
        return machine_.forward(drive, pose) == 0;
    }

    Kinematics machine_;
    bool initialized_ = false;
};

} /* namespace @SPACE@ */

#endif
