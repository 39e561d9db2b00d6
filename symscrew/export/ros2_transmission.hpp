#ifndef @GUARD@_TRANSMISSION_HPP
#define @GUARD@_TRANSMISSION_HPP

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "@FILE@_kinematics.hpp"
#include "transmission_interface/transmission.hpp"

namespace @SPACE@ {

/* The mechanism as a transmission of ros2_control: its actuators are the drives, its joints the commanded axes of the
   tool. Names of handles in the order in which they first come are the drives, and the axes. What fails writes nothing;
   `status` says why. */
class Transmission : public transmission_interface::Transmission {
public:
    void configure(const std::vector<transmission_interface::JointHandle> &joint_handles,
                   const std::vector<transmission_interface::ActuatorHandle> &actuator_handles) override
    {
        joints_ = sorted<Kinematics::freedoms>(joint_handles, "joints");
        actuators_ = sorted<Kinematics::drives>(actuator_handles, "actuators");
    }

    void actuator_to_joint() override
    {
        Kinematics::Drives drive{};
        Kinematics::Axes axis{};
        Kinematics::Pose pose{};
        if (read(actuators_[position], drive)) {
            if ((status_ = kinematics_.forward(drive, pose)) != 0) {
                return;
            }
            write(joints_[position], kinematics_.of(pose));
        }
        if (read(actuators_[velocity], drive) && (status_ = kinematics_.axis_rates(drive, axis)) == 0) {
            write(joints_[velocity], axis);
        }
        if (read(actuators_[effort], drive) && (status_ = kinematics_.axis_efforts(drive, axis)) == 0) {
            write(joints_[effort], axis);
        }
    }

    void joint_to_actuator() override
    {
        Kinematics::Drives drive{};
        Kinematics::Axes axis{};
        if (read(joints_[position], axis)) {
            if ((status_ = kinematics_.inverse(kinematics_.with(axis), drive)) != 0) {
                return;
            }
            write(actuators_[position], drive);
        }
        if (read(joints_[velocity], axis) && (status_ = kinematics_.drive_rates(axis, drive)) == 0) {
            write(actuators_[velocity], drive);
        }
        if (read(joints_[effort], axis) && (status_ = kinematics_.drive_efforts(axis, drive)) == 0) {
            write(actuators_[effort], drive);
        }
    }

    std::size_t num_actuators() const override { return Kinematics::drives; }
    std::size_t num_joints() const override { return Kinematics::freedoms; }
    int status() const noexcept { return status_; }
    Kinematics &kinematics() noexcept { return kinematics_; }

private:
    enum Kind { position, velocity, effort };

    /* Handles by kind; all of a kind or none. */
    template <std::size_t Count, typename Handle>
    static std::array<std::vector<Handle>, 3> sorted(const std::vector<Handle> &handles, const std::string &what)
    {
        const std::array<std::string, 3> kinds{"position", "velocity", "effort"};
        std::array<std::vector<Handle>, 3> found;
        for (const Handle &handle : handles) {
            for (std::size_t k = 0; k < kinds.size(); ++k) {
                if (handle.get_interface_name() == kinds[k]) {
                    found[k].push_back(handle);
                }
            }
        }
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            if (!found[k].empty() && found[k].size() != Count) {
                throw std::invalid_argument("@MODEL@: expected " + std::to_string(Count) + " " + what + " with the interface " +
                                            kinds[k] + ", got " + std::to_string(found[k].size()));
            }
        }
        return found;
    }

    template <typename Handle, std::size_t Count>
    static bool read(const std::vector<Handle> &handles, std::array<double, Count> &values)
    {
        for (std::size_t k = 0; k < handles.size(); ++k) {
            values[k] = handles[k].get_value();
        }
        return !handles.empty();
    }

    template <typename Handle, std::size_t Count>
    static void write(std::vector<Handle> &handles, const std::array<double, Count> &values)
    {
        for (std::size_t k = 0; k < handles.size(); ++k) {
            handles[k].set_value(values[k]);
        }
    }

    Kinematics kinematics_;
    std::array<std::vector<transmission_interface::JointHandle>, 3> joints_;
    std::array<std::vector<transmission_interface::ActuatorHandle>, 3> actuators_;
    int status_ = 0;
};

} /* namespace @SPACE@ */

#endif
