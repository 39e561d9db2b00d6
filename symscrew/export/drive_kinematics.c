/* ---- Kinematics between the drives and the tool, the same for every mechanism; see the table above. ---- */

enum { /* statuses of this part, beside those of the functions, 1 ... 6 and from 11 on */
    FOLLOW_OK = 0,
    FOLLOW_SINGULAR = 100, /* a step of Newton's iteration meets a singularity */
    FOLLOW_JUMP = 101, /* no proved steps lead there: the result may be on another mode */
    FOLLOW_INCONSISTENT = 102, /* more drives than freedoms, which do not agree */
    FOLLOW_NOT_CONVERGED = 103,
    FOLLOW_OTHER_MODE = 104 /* a pose beyond a singularity of the drives */
};

typedef struct {
    double q[N_Q]; /* the last configuration */
    double tool[3]; /* the tool in the platform's axes, beyond the point of the description */
    double tolerance; /* of drives that the others determine [m or rad] */
    long iterations; /* of the last call: configurations that were computed */
    CertificateWork proof;
} DriveState;

static int follow_finite(const double *x, int size)
{
    double sum = 0.0;
    for (int k = 0; k < size; ++k) {
        sum += x[k];
    }
    return isfinite(sum);
}

static void drive_home(DriveState *state)
{
    for (int k = 0; k < N_Q; ++k) {
        state->q[k] = reference_q[k];
    }
}

/* The configuration at `drive` (the chosen ones) on the mode of `from`: in steps that are halved until each is proved. */
static int follow_mode(DriveState *state, const double *drive, const double *from, double *q)
{
    double target[N_FREE], start[N_FREE], next[N_Q];
    double part = 1.0, done = 0.0;
    for (int k = 0; k < N_Q; ++k) {
        q[k] = from[k];
    }
    for (int j = 0; j < N_FREE; ++j) {
        start[j] = from[chosen_q[j]];
    }
    for (int count = 0; count < 4096 && done < 1.0; ++count) {
        const double until = done + part < 1.0 ? done + part : 1.0;
        for (int j = 0; j < N_FREE; ++j) {
            target[j] = until < 1.0 ? start[j] + (drive[j] - start[j]) * until : drive[j];
        }
        ++state->iterations;
        const int status = ASSEMBLE(target, q, next);
        if (status == 2 || status == 5) {
            return status;
        }
        if (status == 0 && mode_certified(&state->proof, q, next)) {
            for (int k = 0; k < N_Q; ++k) {
                q[k] = next[k];
            }
            done = until;
            part *= 2.0;
        } else {
            part *= 0.5;
            if (part < 1.0 / 1024.0) {
                return FOLLOW_JUMP;
            }
        }
    }
    return done < 1.0 ? FOLLOW_JUMP : FOLLOW_OK;
}

/* The tool's axes X, Y, Z [m] and A, B, C [rad] at q, the platform's rotation by columns and its displacement. */
static int tool_axes(const DriveState *state, const double *q, double *world, double *at)
{
    double poses[N_POSES];
    if (BODY_POSES(q, poses) > 0) {
        return FOLLOW_SINGULAR;
    }
    const double *r = poses + PLATFORM, *t = r + 9;
    for (int i = 0; i < 3; ++i) {
        at[i] = t[i];
        for (int j = 0; j < 3; ++j) {
            at[i] += r[i + 3 * j] * (tool_point[j] + state->tool[j]);
        }
        world[i] = at[i];
    }
    world[3] = atan2(r[5], r[8]);
    world[4] = atan2(-r[2], sqrt(r[0] * r[0] + r[1] * r[1]));
    world[5] = atan2(r[1], r[0]);
    return FOLLOW_OK;
}

/* Velocity of the tool at `at` and angular velocity of the platform by the chosen drives, (6 x N_FREE) by columns. */
static int tool_twists(const double *q, const double *at, double *twists)
{
    double null[N_V * N_FREE], screws[6 * N_V];
    if (NULL_SPACE(q, null) > 0 || PLATFORM_JACOBIAN(q, screws) > 0) {
        return FOLLOW_SINGULAR;
    }
    for (int j = 0; j < N_FREE; ++j) {
        double twist[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
        double *column = twists + 6 * j;
        for (int k = 0; k < N_V; ++k) {
            for (int i = 0; i < 6; ++i) {
                twist[i] += screws[i + 6 * k] * null[k + j * N_V];
            }
        }
        column[0] = twist[3] + twist[1] * at[2] - twist[2] * at[1];
        column[1] = twist[4] + twist[2] * at[0] - twist[0] * at[2];
        column[2] = twist[5] + twist[0] * at[1] - twist[1] * at[0];
        for (int i = 0; i < 3; ++i) {
            column[3 + i] = twist[i];
        }
    }
    return FOLLOW_OK;
}

/* Rates of all six axes by the chosen drives, (6 x N_FREE) by columns, at q, where the axes are `world`. */
static int tool_jacobian(const double *q, const double *world, const double *at, double *jacobian)
{
    const double sb = sin(world[4]), cb = cos(world[4]), sc = sin(world[5]), cc = cos(world[5]);
    if (tool_twists(q, at, jacobian) != FOLLOW_OK) {
        return FOLLOW_SINGULAR;
    }
    for (int j = 0; j < N_FREE; ++j) {
        double *column = jacobian + 6 * j;
        const double x = column[3], y = column[4], along = cc * x + sc * y;
        column[3] = along / cb;
        column[4] = cc * y - sc * x;
        column[5] += along * sb / cb;
    }
    return FOLLOW_OK;
}

/* Drives [m, rad] -> axes of the tool [m, rad], from the last configuration, which this one becomes. */
static int drive_forward(DriveState *state, const double *joint, double *world)
{
    double y[N_FREE], q[N_Q], at[3];
    state->iterations = 0;
    if (!follow_finite(joint, N_JOINTS)) {
        return 2;
    }
    for (int j = 0; j < N_FREE; ++j) {
        y[j] = joint[chosen_joint[j]];
    }
    int status = follow_mode(state, y, state->q, q);
    if (status == FOLLOW_OK) {
        status = tool_axes(state, q, world, at);
    }
    for (int k = 0; k < N_JOINTS && status == FOLLOW_OK; ++k) {
        if (fabs(q[driven_q[k]] - joint[k]) > state->tolerance) {
            status = FOLLOW_INCONSISTENT;
        }
    }
    for (int k = 0; k < N_Q && status == FOLLOW_OK; ++k) {
        state->q[k] = q[k];
    }
    return status;
}

/* The sign of the branch at q: of the determinant of the loops; 0 where it cannot be told. */
static int mode_at(const double *q)
{
    double y[N_FREE], next[N_Q], residual[1], change[1], orientation[1];
    for (int j = 0; j < N_FREE; ++j) {
        y[j] = q[chosen_q[j]];
    }
    if (ASSEMBLE_STEP(q, y, next, residual, change, orientation) > 0) {
        return 0;
    }
    return orientation[0] > 0.0 ? 1 : -1;
}

#if CLOSED_FORM
/* The configuration at a pose, in closed form. */
static int drive_backward(DriveState *state, const double *world, double *q)
{
    const double sa = sin(0.5 * world[3]), ca = cos(0.5 * world[3]), sb = sin(0.5 * world[4]);
    const double cb = cos(0.5 * world[4]), sc = sin(0.5 * world[5]), cc = cos(0.5 * world[5]);
    const double w = cc * cb * ca + sc * sb * sa, x = cc * cb * sa - sc * sb * ca;
    const double y = cc * sb * ca + sc * cb * sa, z = sc * cb * ca - cc * sb * sa;
    const double rotation[9] = {
        1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y),
        2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x),
        2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)};
    double place[3], pose[7];
    for (int i = 0; i < 3; ++i) {
        place[i] = world[i];
        for (int j = 0; j < 3; ++j) {
            place[i] += rotation[i + 3 * j] * (pose_centre[j] - tool_point[j] - state->tool[j]);
        }
    }
    const double entry[7] = {place[0], place[1], place[2], w, x, y, z};
    for (int k = 0; k < 7; ++k) {
        pose[k] = entry[pose_entry[k]];
    }
    const int status = INVERSE_KINEMATICS(pose, q);
    return status > 0 ? status : mode_at(q) * mode_at(state->q) > 0 ? FOLLOW_OK : FOLLOW_OTHER_MODE;
}
#else
/* Solves a x = b of N_FREE equations in place, rows of comparable size; 1 where a pivot is lost. */
static int follow_solve(double *a, double *b)
{
    for (int j = 0; j < N_FREE; ++j) {
        int best = j;
        for (int i = j + 1; i < N_FREE; ++i) {
            best = fabs(a[i + j * N_FREE]) > fabs(a[best + j * N_FREE]) ? i : best;
        }
        if (!(fabs(a[best + j * N_FREE]) > 1e-9)) {
            return 1;
        }
        for (int k = 0; k < N_FREE; ++k) {
            const double moved = a[j + k * N_FREE];
            a[j + k * N_FREE] = a[best + k * N_FREE];
            a[best + k * N_FREE] = moved;
        }
        const double right = b[j];
        b[j] = b[best];
        b[best] = right;
        for (int i = j + 1; i < N_FREE; ++i) {
            const double factor = a[i + j * N_FREE] / a[j + j * N_FREE];
            for (int k = j; k < N_FREE; ++k) {
                a[i + k * N_FREE] -= factor * a[j + k * N_FREE];
            }
            b[i] -= factor * b[j];
        }
    }
    for (int j = N_FREE - 1; j >= 0; --j) {
        for (int k = j + 1; k < N_FREE; ++k) {
            b[j] -= a[j + k * N_FREE] * b[k];
        }
        b[j] /= a[j + j * N_FREE];
    }
    return 0;
}

/* Newton's iteration from q to the commanded axes of `goal`; q is changed where it arrives on its mode only. */
static int follow_axes(DriveState *state, const double *goal, double *q)
{
    double own[N_Q], next[N_Q], world[6], at[3], jacobian[6 * N_FREE], square[N_FREE * N_FREE], right[N_FREE], y[N_FREE];
    for (int k = 0; k < N_Q; ++k) {
        own[k] = q[k];
    }
    for (int count = 0; count < 24; ++count) {
        double largest = 0.0;
        if (tool_axes(state, own, world, at) != FOLLOW_OK || tool_jacobian(own, world, at, jacobian) != FOLLOW_OK) {
            return FOLLOW_SINGULAR;
        }
        for (int i = 0; i < N_FREE; ++i) {
            const int axis = commanded[i];
            const double unit = axis < 3 ? PER_LENGTH : 1.0;
            right[i] = axis < 3 ? goal[axis] - world[axis] : remainder(goal[axis] - world[axis], 2.0 * PI);
            right[i] *= unit;
            largest = fabs(right[i]) > largest ? fabs(right[i]) : largest;
            for (int j = 0; j < N_FREE; ++j) {
                square[i + j * N_FREE] = jacobian[axis + 6 * j] * unit * chosen_unit[j];
            }
        }
        if (largest < 1e-13 || (count > 4 && largest < 1e-11)) { /* the last digits do not come closer */
            if (!mode_certified(&state->proof, q, own)) {
                return FOLLOW_JUMP;
            }
            for (int k = 0; k < N_Q; ++k) {
                q[k] = own[k];
            }
            return FOLLOW_OK;
        }
        if (follow_solve(square, right) != 0) {
            return FOLLOW_SINGULAR;
        }
        for (int j = 0; j < N_FREE; ++j) {
            y[j] = own[chosen_q[j]] + right[j] * chosen_unit[j];
        }
        ++state->iterations;
        const int status = ASSEMBLE(y, own, next);
        if (status != 0) {
            return status;
        }
        for (int k = 0; k < N_Q; ++k) {
            own[k] = next[k];
        }
    }
    return FOLLOW_NOT_CONVERGED;
}

/* The configuration at the commanded axes, by Newton's iteration along the straight way from the last one. */
static int drive_backward(DriveState *state, const double *world, double *q)
{
    double start[6], goal[6], at[3];
    double part = 1.0, done = 0.0;
    for (int k = 0; k < N_Q; ++k) {
        q[k] = state->q[k];
    }
    if (tool_axes(state, q, start, at) != FOLLOW_OK) {
        return FOLLOW_SINGULAR;
    }
    int status = FOLLOW_OK;
    for (int count = 0; count < 4096 && done < 1.0; ++count) {
        const double until = done + part < 1.0 ? done + part : 1.0;
        for (int i = 0; i < 6; ++i) {
            const double way = i < 3 ? world[i] - start[i] : remainder(world[i] - start[i], 2.0 * PI);
            goal[i] = start[i] + way * until;
        }
        status = follow_axes(state, goal, q);
        if (status == FOLLOW_OK) {
            done = until;
            part *= 2.0;
        } else {
            part *= 0.5;
            if (part < 1.0 / 1024.0) {
                return status;
            }
        }
    }
    return done < 1.0 ? status : FOLLOW_OK;
}
#endif

/* Axes of the tool [m, rad] -> drives [m, rad]. What is commanded counts, the other axes are not read where the way
   back is Newton's. */
static int drive_inverse(DriveState *state, const double *world, double *joint)
{
    double q[N_Q];
    state->iterations = 0;
    if (!follow_finite(world, 6)) {
        return 2;
    }
    const int status = drive_backward(state, world, q);
    if (status > 0) {
        return status;
    }
    for (int k = 0; k < N_JOINTS; ++k) {
        joint[k] = q[driven_q[k]];
    }
    if (mode_certified(&state->proof, state->q, q)) { /* a question about a far pose does not move where the machine is */
        for (int k = 0; k < N_Q; ++k) {
            state->q[k] = q[k];
        }
    }
    return FOLLOW_OK;
}

/* The smallest margin to a singularity at the last configuration: 0 there; without units. */
static double drive_margin(const DriveState *state)
{
    double margins[N_MARGINS], least = 1e300;
    (void)state;
    (void)margins;
    MARGINS
    return least;
}
