/* ---- LinuxCNC: pins, units, and what the motion controller calls. ---- */

static struct haldata {
    hal_float_t *units; /* machine units of length in a metre: 1000 for mm, 39.37007874015748 for inches */
    hal_float_t *tool_x, *tool_y, *tool_z; /* tool frame: offset in the platform's axes, machine units */
    hal_float_t *tolerance; /* of drives that the others determine, machine units or degrees */
    hal_float_t *margin; /* the smallest margin to a singularity, 0 there */
    hal_float_t *jacobian[N_FREE * N_FREE]; /* of the commanded axes by the chosen joints, by columns, SI units */
    hal_s32_t *status; /* of the last call: 0, or why it failed */
    hal_s32_t *mode; /* +1 or -1: the sign of the branch that is followed; 0 where there is none */
    hal_u32_t *iterations, *refused; /* configurations computed by the last call; forward calls that failed */
    hal_bit_t *reset; /* true: back to the reference configuration at the next call */
} *haldata;

static DriveState state;
static int comp_id;

static double world_unit(int axis)
{
    return axis < 3 ? *haldata->units : 180.0 / PI;
}

static double joint_unit(int joint)
{
    return joint_sliding[joint] ? *haldata->units : 180.0 / PI;
}

/* What the pins say before a call. */
static void taken(void)
{
    if (*haldata->reset) {
        drive_home(&state);
    }
    state.tool[0] = *haldata->tool_x / *haldata->units;
    state.tool[1] = *haldata->tool_y / *haldata->units;
    state.tool[2] = *haldata->tool_z / *haldata->units;
    state.tolerance = *haldata->tolerance / *haldata->units;
}

/* What the pins say after it. */
static int told(int status)
{
    double world[6], at[3], jacobian[6 * N_FREE];
    *haldata->status = status;
    *haldata->iterations = (hal_u32_t)state.iterations;
    *haldata->margin = drive_margin(&state);
    *haldata->mode = mode_at(state.q);
    if (tool_axes(&state, state.q, world, at) == FOLLOW_OK && tool_jacobian(state.q, world, at, jacobian) == FOLLOW_OK) {
        for (int j = 0; j < N_FREE; ++j) {
            for (int i = 0; i < N_FREE; ++i) {
                *haldata->jacobian[i + j * N_FREE] = jacobian[commanded[i] + 6 * j];
            }
        }
    }
    return status == FOLLOW_OK ? 0 : -1;
}

int kinematicsForward(const double *joint, EmcPose *pos, const KINEMATICS_FORWARD_FLAGS *fflags,
                      KINEMATICS_INVERSE_FLAGS *iflags)
{
    double drive[N_JOINTS], world[6];
    (void)fflags;
    (void)iflags;
    taken();
    for (int k = 0; k < N_JOINTS; ++k) {
        drive[k] = joint[k] / joint_unit(k);
    }
    const int status = drive_forward(&state, drive, world);
    if (status == FOLLOW_OK) {
        pos->tran.x = world[0] * world_unit(0);
        pos->tran.y = world[1] * world_unit(1);
        pos->tran.z = world[2] * world_unit(2);
        pos->a = world[3] * world_unit(3);
        pos->b = world[4] * world_unit(4);
        pos->c = world[5] * world_unit(5);
    } else {
        ++*haldata->refused;
    }
    return told(status);
}

int kinematicsInverse(const EmcPose *pos, double *joint, const KINEMATICS_INVERSE_FLAGS *iflags,
                      KINEMATICS_FORWARD_FLAGS *fflags)
{
    double drive[N_JOINTS];
    (void)fflags;
    (void)iflags;
    taken();
    const double world[6] = {
        pos->tran.x / world_unit(0), pos->tran.y / world_unit(1), pos->tran.z / world_unit(2),
        pos->a / world_unit(3), pos->b / world_unit(4), pos->c / world_unit(5)};
    const int status = drive_inverse(&state, world, drive);
    for (int k = 0; k < N_JOINTS && status == FOLLOW_OK; ++k) {
        joint[k] = drive[k] * joint_unit(k);
    }
    return told(status);
}

/* Where the machine is led to from its place by these joints; the place stays what it is. */
static const DriveState *led(const double *joint, double *world)
{
    static DriveState probe; /* too large for the stack of a controller */
    double drive[N_JOINTS];
    taken();
    probe = state;
    for (int k = 0; k < N_JOINTS; ++k) {
        drive[k] = joint[k] / joint_unit(k);
    }
    return drive_forward(&probe, drive, world) == FOLLOW_OK ? &probe : NULL;
}

/* d joint / d pose in machine units, rows of joints, columns x y z a b c u v w: what newer sources ask for. Columns of axes
   that are not commanded are zero. */
int kinematicsJacobian(const double *joint, const EmcPose *pos, double jac[EMCMOT_MAX_JOINTS][EMCMOT_MAX_AXIS],
                       const KINEMATICS_INVERSE_FLAGS *iflags);
int kinematicsJacobian(const double *joint, const EmcPose *pos, double jac[EMCMOT_MAX_JOINTS][EMCMOT_MAX_AXIS],
                       const KINEMATICS_INVERSE_FLAGS *iflags)
{
    double world[6], at[3], forward[6 * N_FREE], null[N_V * N_FREE], square[N_FREE * N_FREE], right[N_FREE];
    const DriveState *const now = led(joint, world);
    (void)pos;
    (void)iflags;
    if (now == NULL || tool_axes(now, now->q, world, at) != FOLLOW_OK ||
        tool_jacobian(now->q, world, at, forward) != FOLLOW_OK || NULL_SPACE(now->q, null) > 0) {
        return -1;
    }
    for (int k = 0; k < EMCMOT_MAX_JOINTS; ++k) {
        for (int a = 0; a < EMCMOT_MAX_AXIS; ++a) {
            jac[k][a] = 0.0;
        }
    }
    for (int c = 0; c < N_FREE; ++c) {
        for (int i = 0; i < N_FREE; ++i) {
            const double unit = commanded[i] < 3 ? PER_LENGTH : 1.0;
            right[i] = i == c ? unit : 0.0;
            for (int j = 0; j < N_FREE; ++j) {
                square[i + j * N_FREE] = forward[commanded[i] + 6 * j] * unit * chosen_unit[j];
            }
        }
        if (follow_solve(square, right) != 0) {
            return -1;
        }
        for (int k = 0; k < N_JOINTS; ++k) {
            double rate = 0.0;
            for (int j = 0; j < N_FREE; ++j) {
                rate += null[joint_rate[k] + j * N_V] * right[j] * chosen_unit[j];
            }
            jac[k][commanded[c]] = rate * joint_unit(k) / world_unit(commanded[c]);
        }
    }
    return 0;
}

/* The platform's axes, which are those of the ground at the reference. */
int kinematicsToolFrame(const double *joint, PmRotationMatrix *rot, const KINEMATICS_FORWARD_FLAGS *fflags);
int kinematicsToolFrame(const double *joint, PmRotationMatrix *rot, const KINEMATICS_FORWARD_FLAGS *fflags)
{
    double world[6], poses[N_POSES];
    const DriveState *const now = led(joint, world);
    (void)fflags;
    if (now == NULL || BODY_POSES(now->q, poses) > 0) {
        return -1;
    }
    const double *r = poses + PLATFORM;
    rot->x = (PmCartesian){r[0], r[1], r[2]};
    rot->y = (PmCartesian){r[3], r[4], r[5]};
    rot->z = (PmCartesian){r[6], r[7], r[8]};
    return 0;
}

/* The work stands still. */
int kinematicsWorkFrame(const double *joint, PmRotationMatrix *rot, const KINEMATICS_FORWARD_FLAGS *fflags);
int kinematicsWorkFrame(const double *joint, PmRotationMatrix *rot, const KINEMATICS_FORWARD_FLAGS *fflags)
{
    (void)joint;
    (void)fflags;
    rot->x = (PmCartesian){1.0, 0.0, 0.0};
    rot->y = (PmCartesian){0.0, 1.0, 0.0};
    rot->z = (PmCartesian){0.0, 0.0, 1.0};
    return 0;
}

KINEMATICS_TYPE kinematicsType(void)
{
    return KINEMATICS_BOTH;
}

KINS_NOT_SWITCHABLE
EXPORT_SYMBOL(kinematicsType);
EXPORT_SYMBOL(kinematicsForward);
EXPORT_SYMBOL(kinematicsInverse);
EXPORT_SYMBOL(kinematicsJacobian);
EXPORT_SYMBOL(kinematicsToolFrame);
EXPORT_SYMBOL(kinematicsWorkFrame);
MODULE_LICENSE("GPL");

int rtapi_app_main(void)
{
    int res;
    comp_id = hal_init("KINS");
    if (comp_id < 0) {
        return comp_id;
    }
    haldata = hal_malloc(sizeof *haldata);
    res = haldata == NULL ? -1 : 0;
    res = res ? res : hal_pin_float_newf(HAL_IN, &haldata->units, comp_id, "KINS.units-per-metre");
    res = res ? res : hal_pin_float_newf(HAL_IN, &haldata->tool_x, comp_id, "KINS.tool-offset.x");
    res = res ? res : hal_pin_float_newf(HAL_IN, &haldata->tool_y, comp_id, "KINS.tool-offset.y");
    res = res ? res : hal_pin_float_newf(HAL_IN, &haldata->tool_z, comp_id, "KINS.tool-offset.z");
    res = res ? res : hal_pin_float_newf(HAL_IN, &haldata->tolerance, comp_id, "KINS.tolerance");
    res = res ? res : hal_pin_float_newf(HAL_OUT, &haldata->margin, comp_id, "KINS.margin");
    for (int j = 0; j < N_FREE * N_FREE; ++j) {
        res = res ? res : hal_pin_float_newf(HAL_OUT, &haldata->jacobian[j], comp_id, "KINS.jacobian.%d-%d",
                                             j % N_FREE, j / N_FREE);
    }
    res = res ? res : hal_pin_s32_newf(HAL_OUT, &haldata->status, comp_id, "KINS.status");
    res = res ? res : hal_pin_s32_newf(HAL_OUT, &haldata->mode, comp_id, "KINS.mode");
    res = res ? res : hal_pin_u32_newf(HAL_OUT, &haldata->iterations, comp_id, "KINS.last-iterations");
    res = res ? res : hal_pin_u32_newf(HAL_OUT, &haldata->refused, comp_id, "KINS.refused");
    res = res ? res : hal_pin_bit_newf(HAL_IN, &haldata->reset, comp_id, "KINS.reset");
    if (res) {
        hal_exit(comp_id);
        return res;
    }
    *haldata->units = 1000.0;
    *haldata->tolerance = 0.1; /* mm: rounding of encoders, not of the mechanism */
    drive_home(&state);
    hal_ready(comp_id);
    return 0;
}

void rtapi_app_exit(void)
{
    hal_exit(comp_id);
}
