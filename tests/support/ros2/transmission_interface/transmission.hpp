// The interface of a transmission in ros2_control, for tests without ROS.
#ifndef STUB_TRANSMISSION_HPP
#define STUB_TRANSMISSION_HPP
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>
namespace transmission_interface {
class Handle {
public:
    Handle(std::string prefix, std::string interface, double *value)
        : prefix_(std::move(prefix)), interface_(std::move(interface)), value_(value)
    {
    }
    virtual ~Handle() = default;
    Handle(const Handle &) = default;
    Handle &operator=(const Handle &) = default;
    const std::string &get_interface_name() const { return interface_; }
    const std::string &get_prefix_name() const { return prefix_; }
    double get_value() const { return *value_; }
    bool set_value(double value)
    {
        *value_ = value;
        return true;
    }

private:
    std::string prefix_, interface_;
    double *value_;
};
class JointHandle : public Handle {
public:
    using Handle::Handle;
};
class ActuatorHandle : public Handle {
public:
    using Handle::Handle;
};
class Transmission {
public:
    virtual ~Transmission() = default;
    virtual void configure(const std::vector<JointHandle> &, const std::vector<ActuatorHandle> &) = 0;
    virtual void actuator_to_joint() = 0;
    virtual void joint_to_actuator() = 0;
    virtual std::size_t num_actuators() const = 0;
    virtual std::size_t num_joints() const = 0;
};
}  // namespace transmission_interface
#endif
