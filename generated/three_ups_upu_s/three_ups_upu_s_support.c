/*
 * three_ups_upu_s: texts of statuses, and what several functions call.
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

const char *three_ups_upu_s_status_text(int status)
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
    default: return "unknown status";
    }
}

/* Makes the columns of a (rows x columns) orthogonal by rotations from the right, collected in v. */
void three_ups_upu_s_orthogonalise(int rows, int columns, double *a, double *v)
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

double three_ups_upu_s_dot(int size, const double *x, const double *y)
{
    double sum = 0.0;
    for (int k = 0; k < size; ++k) {
        sum += x[k] * y[k];
    }
    return sum;
}

/* Solves a positive definite system in place; 1 if a pivot is lost. */
int three_ups_upu_s_cholesky(int size, double *matrix, double *right)
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
int three_ups_upu_s_constrained(int n, int m, const double *mass, const double *force, double *jacobian,
                             const double *bias, double *v, double *work, double *a, double *multipliers)
{
    double *sizes = work, *reduced = work + n, *right = reduced + n * n, *moved = right + n;
    double largest = 1.0; /* unit screws: one is their size */
    int rank = 0, free_count = 0;
    three_ups_upu_s_orthogonalise(m, n, jacobian, v);
    for (int j = 0; j < n; ++j) {
        sizes[j] = three_ups_upu_s_dot(m, jacobian + j * m, jacobian + j * m);
        largest = sizes[j] > largest ? sizes[j] : largest;
        a[j] = 0.0;
    }
    for (int j = 0; j < n; ++j) {
        if (sizes[j] > 1.0e-09 * 1.0e-09 * largest) {
            const double part = three_ups_upu_s_dot(m, jacobian + j * m, bias) / sizes[j];
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
        moved[k] = force[k] - three_ups_upu_s_dot(n, mass + k * n, a);
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
                sum += v[k + i * n] * three_ups_upu_s_dot(n, mass + k * n, v + j * n);
            }
            reduced[other + free_count * count] = sum;
            ++other;
        }
        right[free_count] = three_ups_upu_s_dot(n, v + j * n, moved);
        ++free_count;
    }
    if (three_ups_upu_s_cholesky(count, reduced, right) != 0) {
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
        moved[k] = three_ups_upu_s_dot(n, mass + k * n, a) - force[k];
    }
    for (int i = 0; i < m; ++i) {
        multipliers[i] = 0.0;
    }
    for (int j = 0; j < n; ++j) {
        if (sizes[j] > 0.0) {
            const double part = three_ups_upu_s_dot(n, v + j * n, moved) / sizes[j];
            for (int i = 0; i < m; ++i) {
                multipliers[i] += part * jacobian[i + j * m];
            }
        }
    }
    return rank;
}

/* A unit vector of multipliers that is in equilibrium by itself: orthogonal to the columns of the jacobian that
   count and to the `found` earlier ones. */
void three_ups_upu_s_internal_load(int n, int m, const double *jacobian, int found, double *loads)
{
    double *load = loads + found * m, best = -1.0, largest = 1.0;
    for (int j = 0; j < n; ++j) {
        const double size = three_ups_upu_s_dot(m, jacobian + j * m, jacobian + j * m);
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
                const double size = three_ups_upu_s_dot(m, column, column);
                if (j >= n || size > 1.0e-09 * 1.0e-09 * largest) {
                    const double part = three_ups_upu_s_dot(m, column, load) / size;
                    for (int i = 0; i < m; ++i) {
                        load[i] -= part * column[i];
                    }
                }
            }
        }
        const double size = three_ups_upu_s_dot(m, load, load);
        if (pick < m && size > best) {
            best = size;
            chosen = pick;
        }
    }
    const double factor = 1.0 / sqrt(three_ups_upu_s_dot(m, load, load));
    for (int i = 0; i < m; ++i) {
        load[i] *= factor;
    }
}

#if defined(THREE_UPS_UPU_S_INTERFACE)
/* For loaders: type, then name and entries of every array of every function. */
extern const char *const three_ups_upu_s_interface[];
const char *const three_ups_upu_s_interface[] = {
    "double",
    "acceleration(q 16, v 15, y_ddot 2) -> (a 15)",
    "actuation_margins(q 16) -> (margins 6)",
    "assemble(y 2, guess 16) -> (q 16)",
    "bias(q 16, v 15) -> (bias 15)",
    "body_poses(q 16) -> (poses 108)",
    "body_twist_rates(q 16, v 15, a 15) -> (twist_rates 54)",
    "body_twists(q 16, v 15) -> (twists 54)",
    "close_position(q 16) -> (q_next 16, residual 1)",
    "close_velocity(q 16, v 15) -> (v_next 15)",
    "closure(q 16) -> (residual 13)",
    "closure_bias(q 16, v 15) -> (bias 13)",
    "closure_jacobian(q 16) -> (jacobian 195)",
    "constraint_margin(q 16) -> (margins 1)",
    "drive_positions(pose 4) -> (positions 4)",
    "drive_rates(q 16, v 15) -> (rates 4)",
    "energy(q 16, v 15) -> (energy 2)",
    "forward_dynamics(q 16, v 15, u 4) -> (a 15)",
    "forward_dynamics_independent(q 16, y_dot 2, u 4) -> (y_ddot 2)",
    "forward_dynamics_reactions(q 16, v 15, u 4) -> (a 15, reactions 78)",
    "forward_kinematics(q 16) -> (positions 30)",
    "inverse_dynamics(q 16, v 15, a 15) -> (u 4)",
    "inverse_dynamics_independent(q 16, y_dot 2, y_ddot 2) -> (u 4)",
    "inverse_dynamics_platform(pose 4, rate 3, acceleration 3) -> (u 4)",
    "inverse_dynamics_preload(q 16, v 15, a 15, weights 4, preload 4) -> (u 4)",
    "inverse_kinematics(pose 4) -> (q 16)",
    "inverse_velocity(pose 4, rate 3) -> (v 15)",
    "joint_displacements(q 16) -> (displacements 26)",
    "joint_points(q 16) -> (points 39)",
    "joint_rates(q 16, v 15) -> (rates 26)",
    "joint_reactions(q 16, v 15, a 15) -> (u 4, reactions 78)",
    "joint_screws(q 16) -> (screws 156)",
    "limb_margins(q 16) -> (margins 5)",
    "mass_matrix(q 16) -> (mass_matrix 225)",
    "momentum_rates(q 16, v 15, a 15) -> (momentum_rates 54)",
    "momentum_screws(q 16, v 15) -> (momenta 54, total 6)",
    "null_space(q 16) -> (null_space 30)",
    "platform_jacobian(q 16) -> (jacobian 90)",
    "point_motion(q 16, v 15, a 15) -> (positions 30, velocities 30, accelerations 30)",
    "velocity(q 16, y_dot 2) -> (v 15)",
    NULL
};
#endif
