/* The branch near a singular configuration in extended precision, for a loop in double precision.
 *
 * At a distance d from where the closure loses rank (without units), the coordinates across the branch are known to
 * rounding by d, rates to rounding by d^2 and accelerations to rounding by d^3: 1e-11 at the edge of ZONE in double
 * precision, whatever the tolerance. Here everything is of the type `double` that this file is compiled with; what
 * comes in and goes out is Rounded, for along the branch the state is known to rounding itself. */
#if NR && FREE
static Chart chart; /* of the step that goes on */

/* Anchors the chart near (q, v): its base. `modes` are those of the contacts, if there are any. */
int precise_anchor(const Rounded *q, const Rounded *v, const int *modes, Rounded *base)
{
    double here[NQ1], rate[NV1];
#if CONTACTS
    memcpy(contact_mode, modes, sizeof contact_mode);
#else
    (void)modes;
#endif
    for (int k = 0; k < NQ; ++k) {
        here[k] = q[k];
    }
    for (int k = 0; k < NV; ++k) {
        rate[k] = v[k];
    }
    const int outcome = anchored(here, rate, &chart);
    for (int k = 0; k < NQ; ++k) {
        base[k] = (Rounded)chart.base[k];
    }
    return outcome;
}

/* branch_state of that chart at y = (local coordinates, rates, states): q, v and, if dv is not NULL, slopes. */
int precise_state(Rounded t, const Rounded *y, Rounded *q, Rounded *v, Rounded *dv, Rounded *dx, Rounded *smallest)
{
    double z[NV1], rate[NV1], x[NX1] = {0.0}, q_out[NQ1], v_out[NV1], a[NV1], x_dot[NX1], pivot = 0.0;
    for (int k = 0; k < NV; ++k) {
        z[k] = y[k];
        rate[k] = y[NV + k];
    }
    for (int k = 0; k < NX; ++k) {
        x[k] = y[2 * NV + k];
    }
    const int outcome = branch_state(&chart, t, z, rate, x, q_out, v_out, dv == NULL ? NULL : a, x_dot, &pivot, NULL);
    if (outcome != 0) {
        return outcome;
    }
    for (int k = 0; k < NQ; ++k) {
        q[k] = (Rounded)q_out[k];
    }
    for (int k = 0; k < NV; ++k) {
        v[k] = (Rounded)v_out[k];
        if (dv != NULL) {
            dv[k] = (Rounded)a[k];
        }
    }
    for (int k = 0; k < NX && dv != NULL; ++k) {
        dx[k] = (Rounded)x_dot[k];
    }
    *smallest = (Rounded)pivot;
    return 0;
}
#endif

/* Of the type that this file computes with: 1e-16 where a compiler has no longer one. */
Rounded precise_rounding(void)
{
    const double one = 1.0;
    volatile double part = 1.0, sum = 2.0;
    while (sum > one) {
        part *= 0.5;
        sum = one + part;
    }
    return (Rounded)part;
}
