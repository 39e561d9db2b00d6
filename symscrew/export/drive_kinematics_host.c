/* ---- For a program on this machine: the state is the caller's, drives in m and rad. ---- */

int NAME_forward(double *q, const double *tool, const double *joint, double *world)
{
    DriveState state = {.tolerance = 1e-6};
    memcpy(state.q, q, sizeof state.q);
    memcpy(state.tool, tool, sizeof state.tool);
    const int status = drive_forward(&state, joint, world);
    memcpy(q, state.q, sizeof state.q);
    return status;
}

int NAME_inverse(double *q, const double *tool, const double *world, double *joint)
{
    DriveState state = {.tolerance = 1e-6};
    memcpy(state.q, q, sizeof state.q);
    memcpy(state.tool, tool, sizeof state.tool);
    const int status = drive_inverse(&state, world, joint);
    memcpy(q, state.q, sizeof state.q);
    return status;
}

int NAME_jacobian(const double *q, const double *tool, double *jacobian, double *margin)
{
    DriveState state = {.tolerance = 1e-6};
    double world[6], at[3];
    memcpy(state.q, q, sizeof state.q);
    memcpy(state.tool, tool, sizeof state.tool);
    *margin = drive_margin(&state);
    const int status = tool_axes(&state, q, world, at);
    return status != FOLLOW_OK ? status : tool_jacobian(q, world, at, jacobian);
}

/* Velocity of the tool, and of the platform's turning, by the chosen drives, (6 x N_FREE) by columns; rotation by columns
   and place of the tool. */
int NAME_twists(const double *q, const double *tool, double *twists, double *frame)
{
    DriveState state = {.tolerance = 1e-6};
    double world[6], poses[N_POSES];
    memcpy(state.tool, tool, sizeof state.tool);
    if (tool_axes(&state, q, world, frame + 9) != FOLLOW_OK || BODY_POSES(q, poses) > 0) {
        return FOLLOW_SINGULAR;
    }
    memcpy(frame, poses + PLATFORM, 9 * sizeof *frame);
    return tool_twists(q, frame + 9, twists);
}

int NAME_mode(const double *q)
{
    return mode_at(q);
}

/* Rates of all drives by the chosen ones, (N_JOINTS x N_FREE) by columns. */
int NAME_joint_rates(const double *q, double *rates)
{
    double null[N_V * N_FREE];
    if (NULL_SPACE(q, null) > 0) {
        return FOLLOW_SINGULAR;
    }
    for (int j = 0; j < N_FREE; ++j) {
        for (int k = 0; k < N_JOINTS; ++k) {
            rates[k + j * N_JOINTS] = null[driven_v[k] + j * N_V];
        }
    }
    return FOLLOW_OK;
}

void NAME_home(double *q)
{
    DriveState state = {.tolerance = 1e-6};
    drive_home(&state);
    memcpy(q, state.q, sizeof state.q);
}
