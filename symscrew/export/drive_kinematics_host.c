/* ---- For a program on this machine: the state is the caller's, drives in m and rad. ---- */

int host_forward(double *q, const double *tool, const double *joint, double *world)
{
    DriveState state = {.tolerance = 1e-6};
    memcpy(state.q, q, sizeof state.q);
    memcpy(state.tool, tool, sizeof state.tool);
    const int status = drive_forward(&state, joint, world);
    memcpy(q, state.q, sizeof state.q);
    return status;
}

int host_inverse(double *q, const double *tool, const double *world, double *joint)
{
    DriveState state = {.tolerance = 1e-6};
    memcpy(state.q, q, sizeof state.q);
    memcpy(state.tool, tool, sizeof state.tool);
    const int status = drive_inverse(&state, world, joint);
    memcpy(q, state.q, sizeof state.q);
    return status;
}

int host_jacobian(const double *q, const double *tool, double *jacobian, double *margin)
{
    DriveState state = {.tolerance = 1e-6};
    double world[6], at[3];
    memcpy(state.q, q, sizeof state.q);
    memcpy(state.tool, tool, sizeof state.tool);
    *margin = drive_margin(&state);
    const int status = tool_axes(&state, q, world, at);
    return status != FOLLOW_OK ? status : tool_jacobian(q, world, at, jacobian);
}

int host_mode(const double *q)
{
    return mode_at(q);
}
