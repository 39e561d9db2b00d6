#ifndef @GUARD@_KINEMATICS_HPP
#define @GUARD@_KINEMATICS_HPP

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

extern "C" {
int @FOLLOW@_forward(double *q, const double *tool, const double *joint, double *world);
int @FOLLOW@_inverse(double *q, const double *tool, const double *world, double *joint);
int @FOLLOW@_jacobian(const double *q, const double *tool, double *jacobian, double *margin);
int @FOLLOW@_joint_rates(const double *q, double *rates);
int @FOLLOW@_twists(const double *q, const double *tool, double *twists, double *frame);
int @FOLLOW@_mode(const double *q);
void @FOLLOW@_home(double *q);
}

namespace @SPACE@ {

/* Between drives and the tool, from the last configuration; nothing is allocated, nothing throws. Units are m and rad.
   A call that fails gives a status above 0 and changes nothing; statuses are those of docs/how_to/linuxcnc.md. */
class Kinematics {
public:
    static constexpr std::size_t drives = @DRIVES@, freedoms = @FREEDOMS@, coordinates = @COORDINATES@;
    static constexpr std::array<std::size_t, freedoms> axes{@AXES@};     /* of X, Y, Z, A, B, C: those that are commanded */
    static constexpr double per_length = @PER_LENGTH@; /* one over the characteristic length [1/m] */
    static constexpr std::array<std::size_t, freedoms> chosen{@CHOSEN@}; /* drives that the tool follows from */
    using Drives = std::array<double, drives>;
    using Axes = std::array<double, freedoms>;
    using Twists = std::array<double, 6 * freedoms>;
    using Frame = std::array<double, 12>;
    using Pose = std::array<double, 6>; /* X, Y, Z, A, B, C: R = Rz(C) Ry(B) Rx(A) */

    Kinematics() noexcept { home(); }

    /* Back to the reference configuration. */
    void home() noexcept { @FOLLOW@_home(q_.data()); }
    void tool(const std::array<double, 3> &offset) noexcept { tool_ = offset; }
    const std::array<double, coordinates> &configuration() const noexcept { return q_; }
    int mode() const noexcept { return @FOLLOW@_mode(q_.data()); }

    int forward(const Drives &drive, Pose &pose) noexcept
    {
        Pose found{};
        const int status = @FOLLOW@_forward(q_.data(), tool_.data(), drive.data(), found.data());
        if (status == 0) {
            pose = pose_ = found;
        }
        return status;
    }

    int inverse(const Pose &pose, Drives &drive) noexcept
    {
        Drives found{};
        const int status = @FOLLOW@_inverse(q_.data(), tool_.data(), pose.data(), found.data());
        if (status == 0) {
            drive = found;
            pose_ = pose;
        }
        return status;
    }

    /* The pose with the commanded axes put in: the others stay those of the last one. */
    Pose with(const Axes &commanded) const noexcept
    {
        Pose pose = pose_;
        for (std::size_t i = 0; i < freedoms; ++i) {
            pose[axes[i]] = commanded[i];
        }
        return pose;
    }

    Axes of(const Pose &pose) const noexcept
    {
        Axes found{};
        for (std::size_t i = 0; i < freedoms; ++i) {
            found[i] = pose[axes[i]];
        }
        return found;
    }

    /* Rates of the commanded axes from those of the drives, of which the chosen ones are read. */
    int axis_rates(const Drives &drive_rates, Axes &rates) const noexcept
    {
        Square jacobian{};
        const int status = square(jacobian);
        for (std::size_t i = 0; i < freedoms && status == 0; ++i) {
            rates[i] = 0.0;
            for (std::size_t j = 0; j < freedoms; ++j) {
                rates[i] += jacobian[i][j] * drive_rates[chosen[j]];
            }
        }
        return status;
    }

    /* Rates of all drives from those of the commanded axes. */
    int drive_rates(const Axes &rates, Drives &drive_rates) const noexcept
    {
        Square jacobian{};
        Axes own = rates;
        std::array<double, drives * freedoms> every{};
        int status = square(jacobian);
        status = status != 0 ? status : @FOLLOW@_joint_rates(q_.data(), every.data());
        if (status != 0 || !solve(jacobian, own)) {
            return status != 0 ? status : singular;
        }
        for (std::size_t k = 0; k < drives; ++k) {
            drive_rates[k] = 0.0;
            for (std::size_t j = 0; j < freedoms; ++j) {
                drive_rates[k] += every[k + j * drives] * own[j];
            }
        }
        return 0;
    }

    /* Efforts of the chosen drives that do the work of efforts along the commanded axes; those of the others are 0. */
    int drive_efforts(const Axes &efforts, Drives &drive_efforts) const noexcept
    {
        Square jacobian{};
        const int status = square(jacobian);
        if (status != 0) {
            return status;
        }
        drive_efforts = Drives{};
        for (std::size_t j = 0; j < freedoms; ++j) {
            for (std::size_t i = 0; i < freedoms; ++i) {
                drive_efforts[chosen[j]] += jacobian[i][j] * efforts[i];
            }
        }
        return 0;
    }

    /* Efforts along the commanded axes that do the work of the efforts of all drives. */
    int axis_efforts(const Drives &drive_efforts, Axes &efforts) const noexcept
    {
        Square jacobian{}, turned{};
        std::array<double, drives * freedoms> every{};
        Axes own{};
        int status = square(jacobian);
        status = status != 0 ? status : @FOLLOW@_joint_rates(q_.data(), every.data());
        for (std::size_t j = 0; j < freedoms; ++j) {
            for (std::size_t k = 0; k < drives; ++k) {
                own[j] += every[k + j * drives] * drive_efforts[k];
            }
            for (std::size_t i = 0; i < freedoms; ++i) {
                turned[j][i] = jacobian[i][j];
            }
        }
        if (status != 0 || !solve(turned, own)) {
            return status != 0 ? status : singular;
        }
        efforts = own;
        return 0;
    }

    /* Velocity of the tool and angular velocity by the chosen drives, (6 x freedoms) by columns. */
    int twists(Twists &found) const noexcept
    {
        Frame place{};
        return @FOLLOW@_twists(q_.data(), tool_.data(), found.data(), place.data());
    }

    /* Where the tool is: rotation by columns, place. */
    int frame(Frame &found) const noexcept
    {
        Twists by_drives{};
        return @FOLLOW@_twists(q_.data(), tool_.data(), by_drives.data(), found.data());
    }

    /* Rates of all drives whose twist is nearest to the given one (v ; omega), lengths by the characteristic length. */
    int drives_of_twist(const std::array<double, 6> &twist, Drives &drive_rates) const noexcept
    {
        Twists every{};
        Square square{};
        Axes own{};
        int status = twists(every);
        for (std::size_t i = 0; i < freedoms; ++i) {
            for (std::size_t k = 0; k < 6; ++k) {
                const double weight = k < 3 ? per_length * per_length : 1.0;
                own[i] += weight * every[k + 6 * i] * twist[k];
                for (std::size_t j = 0; j < freedoms; ++j) {
                    square[i][j] += weight * every[k + 6 * i] * every[k + 6 * j];
                }
            }
        }
        std::array<double, drives * freedoms> rates{};
        status = status != 0 ? status : @FOLLOW@_joint_rates(q_.data(), rates.data());
        if (status != 0 || !solve(square, own)) {
            return status != 0 ? status : singular;
        }
        for (std::size_t k = 0; k < drives; ++k) {
            drive_rates[k] = 0.0;
            for (std::size_t j = 0; j < freedoms; ++j) {
                drive_rates[k] += rates[k + j * drives] * own[j];
            }
        }
        return 0;
    }

    /* The smallest margin to a singularity, 0 there. */
    double margin() const noexcept
    {
        std::array<double, 6 * freedoms> found{};
        double least = 0.0;
        (void)@FOLLOW@_jacobian(q_.data(), tool_.data(), found.data(), &least);
        return least;
    }

private:
    using Square = std::array<std::array<double, freedoms>, freedoms>;
    static constexpr int singular = 100;

    /* Rates of the commanded axes by the chosen drives. */
    int square(Square &jacobian) const noexcept
    {
        std::array<double, 6 * freedoms> found{};
        double margin = 0.0;
        const int status = @FOLLOW@_jacobian(q_.data(), tool_.data(), found.data(), &margin);
        for (std::size_t i = 0; i < freedoms; ++i) {
            for (std::size_t j = 0; j < freedoms; ++j) {
                jacobian[i][j] = found[axes[i] + 6 * j];
            }
        }
        return status;
    }

    /* Solves a x = b in place; false where a pivot is lost. */
    static bool solve(Square &a, Axes &b) noexcept
    {
        for (std::size_t j = 0; j < freedoms; ++j) {
            std::size_t best = j;
            for (std::size_t i = j + 1; i < freedoms; ++i) {
                best = std::fabs(a[i][j]) > std::fabs(a[best][j]) ? i : best;
            }
            if (!(std::fabs(a[best][j]) > 1e-9)) {
                return false;
            }
            std::swap(a[j], a[best]);
            std::swap(b[j], b[best]);
            for (std::size_t i = j + 1; i < freedoms; ++i) {
                const double factor = a[i][j] / a[j][j];
                for (std::size_t k = j; k < freedoms; ++k) {
                    a[i][k] -= factor * a[j][k];
                }
                b[i] -= factor * b[j];
            }
        }
        for (std::size_t j = freedoms; j-- > 0;) {
            for (std::size_t k = j + 1; k < freedoms; ++k) {
                b[j] -= a[j][k] * b[k];
            }
            b[j] /= a[j][j];
        }
        return true;
    }

    std::array<double, coordinates> q_{};
    std::array<double, 3> tool_{};
    Pose pose_{};
};

} /* namespace @SPACE@ */

#endif
