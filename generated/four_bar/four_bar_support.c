/*
 * four_bar: texts of statuses, and what several functions call.
 * Generated with four_bar.h, which says of what; do not edit.
 */
#include "four_bar_support.h"

const char *four_bar_status_text(int status)
{
    switch (status) {
    case -2: return "success where the loops lose rank: by the rank-revealing path, with the freedoms that open there";
    case -1: return "success near a small pivot: by the rank-revealing path, at full rank";
    case 0: return "success";
    case 1: return "near-singular: a pivot of the elimination fell below its threshold; all outputs are NaN";
    case 2: return "not finite: an input was NaN or infinite, or an output overflowed; all outputs are NaN";
    case 3: return "not converged: the loops could not be closed from this guess; all outputs are NaN";
    case 4: return "other branch: the loops close only on another assembly branch than the guess; all outputs are NaN";
    case 5: return "no rotation: the length of a quaternion differs from 1 by more than rounding; all outputs are NaN";
    case 6: return "not on the mechanism: its loops do not close where, or as, the inputs say; all outputs are NaN";
    case 11: return "out of reach: limb A does not get there; all outputs are NaN";
    default: return "unknown status";
    }
}

/* Makes the columns of a (rows x columns) orthogonal by rotations from the right, collected in v. */
void four_bar_orthogonalise(int rows, int columns, double *a, double *v)
{
    double total = 0.0;
    for (int k = 0; k < rows * columns; ++k) {
        total += a[k] * a[k];
    }
    for (int j = 0; j < columns; ++j) {
        for (int i = 0; i < columns; ++i) {
            v[i + j * columns] = i == j ? 1.0 : 0.0;
        }
    }
    int turned = 1;
    for (int sweep = 0; sweep < 40 && turned != 0; ++sweep) {
        turned = 0;
        for (int i = 0; i + 1 < columns; ++i) {
            for (int j = i + 1; j < columns; ++j) {
                double *x = a + i * rows, *y = a + j * rows;
                double xx = 0.0, yy = 0.0, xy = 0.0;
                for (int k = 0; k < rows; ++k) {
                    xx += x[k] * x[k];
                    yy += y[k] * y[k];
                    xy += x[k] * y[k];
                }
                const double least = xx < yy ? xx : yy;
                if (least <= 1.0e-30 * total || fabs(xy) <= 1.0e-15 * sqrt(xx * yy)) {
                    continue;
                }
                turned = 1;
                const double ratio = (yy - xx) / (2.0 * xy);
                const double tangent = (ratio < 0.0 ? -1.0 : 1.0) / (fabs(ratio) + sqrt(1.0 + ratio * ratio));
                const double cosine = 1.0 / sqrt(1.0 + tangent * tangent), sine = cosine * tangent;
                for (int k = 0; k < rows; ++k) {
                    const double old = x[k];
                    x[k] = cosine * old - sine * y[k];
                    y[k] = sine * old + cosine * y[k];
                }
                x = v + i * columns;
                y = v + j * columns;
                for (int k = 0; k < columns; ++k) {
                    const double old = x[k];
                    x[k] = cosine * old - sine * y[k];
                    y[k] = sine * old + cosine * y[k];
                }
            }
        }
    }
}

double four_bar_dot(int size, const double *x, const double *y)
{
    double sum = 0.0;
    for (int k = 0; k < size; ++k) {
        sum += x[k] * y[k];
    }
    return sum;
}

/* Solves a positive definite system in place; 1 if a pivot is lost. */
int four_bar_cholesky(int size, double *matrix, double *right)
{
    double largest = 0.0;
    for (int j = 0; j < size; ++j) {
        largest = matrix[j + j * size] > largest ? matrix[j + j * size] : largest;
    }
    for (int j = 0; j < size; ++j) {
        for (int i = j; i < size; ++i) {
            double sum = matrix[i + j * size];
            for (int k = 0; k < j; ++k) {
                sum -= matrix[i + k * size] * matrix[j + k * size];
            }
            if (i == j && !(sum > 1.0e-14 * largest)) {
                return 1;
            }
            matrix[i + j * size] = i == j ? sqrt(sum) : sum / matrix[j + j * size];
        }
        for (int k = 0; k < j; ++k) {
            right[j] -= matrix[j + k * size] * right[k];
        }
        right[j] /= matrix[j + j * size];
    }
    for (int j = size - 1; j >= 0; --j) {
        for (int i = j + 1; i < size; ++i) {
            right[j] -= matrix[i + j * size] * right[i];
        }
        right[j] /= matrix[j + j * size];
    }
    return 0;
}

/* Accelerations a and multipliers from mass a = force + jacobian^T multipliers, jacobian a + bias = 0, all
   without units; v takes the null space. Returns the rank of the jacobian, or -1 if no acceleration is unique. */
int four_bar_constrained(int n, int m, const double *mass, const double *force, double *jacobian,
                             const double *bias, double *v, double *work, double *a, double *multipliers)
{
    double *sizes = work, *reduced = work + n, *right = reduced + n * n, *moved = right + n;
    double largest = 1.0; /* unit screws: one is their size */
    int rank = 0, free_count = 0;
    four_bar_orthogonalise(m, n, jacobian, v);
    for (int j = 0; j < n; ++j) {
        sizes[j] = four_bar_dot(m, jacobian + j * m, jacobian + j * m);
        largest = sizes[j] > largest ? sizes[j] : largest;
        a[j] = 0.0;
    }
    for (int j = 0; j < n; ++j) {
        if (sizes[j] > 1.0e-09 * 1.0e-09 * largest) {
            const double part = four_bar_dot(m, jacobian + j * m, bias) / sizes[j];
            for (int k = 0; k < n; ++k) {
                a[k] -= part * v[k + j * n];
            }
            ++rank;
        } else {
            sizes[j] = 0.0;
        }
    }
    const int count = n - rank;
    for (int k = 0; k < n; ++k) {
        moved[k] = force[k] - four_bar_dot(n, mass + k * n, a);
    }
    for (int j = 0; j < n; ++j) {
        if (sizes[j] > 0.0) {
            continue;
        }
        int other = 0;
        for (int i = 0; i < n; ++i) {
            if (sizes[i] > 0.0) {
                continue;
            }
            double sum = 0.0;
            for (int k = 0; k < n; ++k) {
                sum += v[k + i * n] * four_bar_dot(n, mass + k * n, v + j * n);
            }
            reduced[other + free_count * count] = sum;
            ++other;
        }
        right[free_count] = four_bar_dot(n, v + j * n, moved);
        ++free_count;
    }
    if (four_bar_cholesky(count, reduced, right) != 0) {
        return -1;
    }
    free_count = 0;
    for (int j = 0; j < n; ++j) {
        if (sizes[j] > 0.0) {
            continue;
        }
        for (int k = 0; k < n; ++k) {
            a[k] += right[free_count] * v[k + j * n];
        }
        ++free_count;
    }
    for (int k = 0; k < n; ++k) {
        moved[k] = four_bar_dot(n, mass + k * n, a) - force[k];
    }
    for (int i = 0; i < m; ++i) {
        multipliers[i] = 0.0;
    }
    for (int j = 0; j < n; ++j) {
        if (sizes[j] > 0.0) {
            const double part = four_bar_dot(n, v + j * n, moved) / sizes[j];
            for (int i = 0; i < m; ++i) {
                multipliers[i] += part * jacobian[i + j * m];
            }
        }
    }
    return rank;
}

/* A unit vector of multipliers that is in equilibrium by itself: orthogonal to the columns of the jacobian that
   count and to the `found` earlier ones. */
void four_bar_internal_load(int n, int m, const double *jacobian, int found, double *loads)
{
    double *load = loads + found * m, best = -1.0, largest = 1.0;
    for (int j = 0; j < n; ++j) {
        const double size = four_bar_dot(m, jacobian + j * m, jacobian + j * m);
        largest = size > largest ? size : largest;
    }
    for (int pick = 0, chosen = -1; pick <= m; ++pick) {
        const int start = pick < m ? pick : chosen;
        for (int i = 0; i < m; ++i) {
            load[i] = i == start ? 1.0 : 0.0;
        }
        for (int again = 0; again < 2; ++again) {
            for (int j = 0; j < n + found; ++j) {
                const double *column = j < n ? jacobian + j * m : loads + (j - n) * m;
                const double size = four_bar_dot(m, column, column);
                if (j >= n || size > 1.0e-09 * 1.0e-09 * largest) {
                    const double part = four_bar_dot(m, column, load) / size;
                    for (int i = 0; i < m; ++i) {
                        load[i] -= part * column[i];
                    }
                }
            }
        }
        const double size = four_bar_dot(m, load, load);
        if (pick < m && size > best) {
            best = size;
            chosen = pick;
        }
    }
    const double factor = 1.0 / sqrt(four_bar_dot(m, load, load));
    for (int i = 0; i < m; ++i) {
        load[i] *= factor;
    }
}

#if defined(FOUR_BAR_INTERFACE)
/* For loaders: type, then name and entries of every array of every function. */
extern const char *const four_bar_interface[];
const char *const four_bar_interface[] = {
    "double",
    "acceleration(q 3, v 3, y_ddot 1) -> (a 3)",
    "actuation_margins(q 3) -> (margins 1)",
    "assemble(y 1, guess 3) -> (q 3)",
    "bias(q 3, v 3) -> (bias 3)",
    "body_poses(q 3) -> (poses 36)",
    "body_twist_rates(q 3, v 3, a 3) -> (twist_rates 18)",
    "body_twists(q 3, v 3) -> (twists 18)",
    "close_position(q 3) -> (q_next 3, residual 1)",
    "close_velocity(q 3, v 3) -> (v_next 3)",
    "closure(q 3) -> (residual 5)",
    "closure_bias(q 3, v 3) -> (bias 5)",
    "closure_jacobian(q 3) -> (jacobian 15)",
    "constraint_margin(q 3) -> (margins 1)",
    "drive_positions(pose 1) -> (positions 1)",
    "drive_rates(q 3, v 3) -> (rates 1)",
    "energy(q 3, v 3) -> (energy 2)",
    "forward_dynamics(q 3, v 3, u 1) -> (a 3)",
    "forward_dynamics_independent(q 3, y_dot 1, u 1) -> (y_ddot 1)",
    "forward_dynamics_reactions(q 3, v 3, u 1) -> (a 3, reactions 24)",
    "forward_kinematics(q 3) -> (positions 3)",
    "inverse_dynamics(q 3, v 3, a 3) -> (u 1)",
    "inverse_dynamics_independent(q 3, y_dot 1, y_ddot 1) -> (u 1)",
    "inverse_dynamics_platform(pose 1, rate 1, acceleration 1) -> (u 1)",
    "inverse_kinematics(pose 1) -> (q 3)",
    "inverse_velocity(pose 1, rate 1) -> (v 3)",
    "joint_displacements(q 3) -> (displacements 4)",
    "joint_points(q 3) -> (points 12)",
    "joint_rates(q 3, v 3) -> (rates 4)",
    "joint_reactions(q 3, v 3, a 3) -> (u 1, reactions 24)",
    "joint_screws(q 3) -> (screws 24)",
    "limb_margins(q 3) -> (margins 1)",
    "mass_matrix(q 3) -> (mass_matrix 9)",
    "momentum_rates(q 3, v 3, a 3) -> (momentum_rates 18)",
    "momentum_screws(q 3, v 3) -> (momenta 18, total 6)",
    "null_space(q 3) -> (null_space 3)",
    "platform_jacobian(q 3) -> (jacobian 18)",
    "point_motion(q 3, v 3, a 3) -> (positions 3, velocities 3, accelerations 3)",
    "velocity(q 3, y_dot 1) -> (v 3)",
    NULL
};
#endif
