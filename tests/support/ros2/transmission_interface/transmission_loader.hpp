// For tests without ROS.
#include "transmission_interface/transmission.hpp"
namespace hardware_interface {
struct TransmissionInfo {};
}  // namespace hardware_interface
namespace transmission_interface {
class TransmissionLoader {
public:
    virtual ~TransmissionLoader() = default;
    virtual std::shared_ptr<Transmission> load(const hardware_interface::TransmissionInfo &) = 0;
};
}  // namespace transmission_interface
