// A kinematics plugin asked by numbers: LINK, then per line joints and a twist; prints what it answers, all of one state.
#include <cstdio>
#include <iostream>
#include <memory>

#include "kinematics_interface/kinematics_interface.hpp"

std::unique_ptr<kinematics_interface::KinematicsInterface> make_plugin();

static void print(double value)
{
    std::printf("%.17g ", value);
}

int main(int argc, char **argv)
{
    const auto plugin = make_plugin();
    const Eigen::Index count = std::atoi(argv[2]);
    Eigen::VectorXd joints(count), deltas(count);
    Eigen::Matrix<double, 6, 1> twist, back;
    Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian;
    Eigen::Matrix<double, Eigen::Dynamic, 6> inverse;
    Eigen::Isometry3d frame;
    bool good = argc == 3 && !plugin->calculate_link_transform(joints, argv[1], frame);
    good = good && plugin->initialize("", nullptr, "");
    double value = 0.0;
    while (good && std::cin >> value) {
        for (Eigen::Index k = 0; k < count + 6; ++k) {
            (k < count ? joints(k) : twist(k - count)) = value;
            if (k < count + 5 && !(std::cin >> value)) {
                return 2;
            }
        }
        const bool done = plugin->calculate_link_transform(joints, argv[1], frame) &&
                          plugin->calculate_jacobian(joints, argv[1], jacobian) &&
                          plugin->convert_cartesian_deltas_to_joint_deltas(joints, twist, argv[1], deltas) &&
                          plugin->convert_joint_deltas_to_cartesian_deltas(joints, deltas, argv[1], back) &&
                          plugin->calculate_jacobian_inverse(joints, argv[1], inverse);
        if (!done) {
            std::printf("0\n");
            continue;
        }
        print(1.0);
        for (Eigen::Index j = 0; j < 4; ++j) {
            for (Eigen::Index i = 0; i < 3; ++i) {
                print(frame(i, j));
            }
        }
        for (Eigen::Index k = 0; k < count; ++k) {
            print(deltas(k));
        }
        for (Eigen::Index i = 0; i < 6; ++i) {
            print(back(i));
        }
        for (Eigen::Index j = 0; j < count; ++j) {
            for (Eigen::Index i = 0; i < 6; ++i) {
                print(jacobian(i, j));
            }
        }
        for (Eigen::Index i = 0; i < 6; ++i) {
            double sum = 0.0;
            for (Eigen::Index j = 0; j < count; ++j) {
                sum += inverse(j, i) * jacobian(i, j);
            }
            print(sum);
        }
        std::printf("\n");
    }
    Eigen::Matrix<double, 7, 1> from, to;
    for (Eigen::Index k = 0; k < 7; ++k) {
        from(k) = k == 6 ? 1.0 : 0.0;
        to(k) = k == 0 ? 2.0 : k == 5 ? -0.6 : k == 6 ? -0.8 : 0.0;
    }
    good = good && plugin->calculate_frame_difference(from, to, 0.5, twist);
    for (Eigen::Index i = 0; i < 6; ++i) {
        print(twist(i));
    }
    std::printf("\n");
    return good ? 0 : 1;
}
