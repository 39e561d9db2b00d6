// A transmission driven by handles: reads "a|j" and values of one side, prints the other side's.
#include <cstdio>
#include <cstring>
#include <memory>

#include "transmission_interface/transmission_loader.hpp"

std::unique_ptr<transmission_interface::TransmissionLoader> make_plugin();

int main(int argc, char **argv)
{
    using namespace transmission_interface;
    const auto plugin = make_plugin()->load({});
    const std::size_t joints = plugin->num_joints(), actuators = plugin->num_actuators();
    std::vector<double> joint(3 * joints), actuator(3 * actuators);
    std::vector<JointHandle> joint_handles;
    std::vector<ActuatorHandle> actuator_handles;
    const char *const kinds[] = {"position", "velocity", "effort"};
    for (std::size_t kind = 0; kind < 3; ++kind) {
        for (std::size_t k = 0; k < joints; ++k) {
            joint_handles.emplace_back("j" + std::to_string(k), kinds[kind], &joint[kind * joints + k]);
        }
        for (std::size_t k = 0; k < actuators; ++k) {
            actuator_handles.emplace_back("a" + std::to_string(k), kinds[kind], &actuator[kind * actuators + k]);
        }
    }
    if (argc > 1 && std::strcmp(argv[1], "few") == 0) {
        joint_handles.erase(joint_handles.begin());
    }
    try {
        plugin->configure(joint_handles, actuator_handles);
    } catch (const std::exception &error) {
        std::printf("%s\n", error.what());
        return 3;
    }
    char side = 0;
    while (std::scanf(" %c", &side) == 1) {
        std::vector<double> &given = side == 'a' ? actuator : joint;
        for (double &value : given) {
            if (std::scanf("%lf", &value) != 1) {
                return 2;
            }
        }
        side == 'a' ? plugin->actuator_to_joint() : plugin->joint_to_actuator();
        for (const double value : side == 'a' ? joint : actuator) {
            std::printf("%.17g ", value);
        }
        std::printf("\n");
    }
    return 0;
}
