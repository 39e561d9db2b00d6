/* The reduced model's arithmetic, put behind the sizes NX, NU, NV, NQ, NY and the functions `configuration`, `value`,
   `slopes` and `bends` of a mechanism. Matrices by columns; statuses are those of the mechanism's functions. */

/* x_dot; with slope (NX x NV) and hessian (NV x NV, of lam . x_dot) where they are wanted. */
static int motion(
    const double *x, const double *u, const double *lam, double *x_dot, double *slope, double *hessian)
{
    double q[NQ];
    double by[NY * NV];
    int status = configuration(x, q);
    if (status > 0) {
        return status;
    }
    if (x_dot != NULL) {
        status = value(q, x + NY, u, x_dot + NY);
        if (status > 0) {
            return status;
        }
        for (int k = 0; k < NY; ++k) {
            x_dot[k] = x[NY + k];
        }
    }
    if (slope != NULL) {
        status = slopes(q, x + NY, u, by);
        if (status > 0) {
            return status;
        }
        for (int j = 0; j < NV; ++j) {
            for (int i = 0; i < NY; ++i) {
                slope[j * NX + i] = j == NY + i ? 1.0 : 0.0;
                slope[j * NX + NY + i] = by[j * NY + i];
            }
        }
    }
    return hessian != NULL ? bends(q, x + NY, u, lam + NY, hessian) : 0;
}

static int ode(const double *x, const double *u, double *x_dot)
{
    return motion(x, u, NULL, x_dot, NULL, NULL);
}

static int ode_slopes(const double *x, const double *u, double *slope)
{
    return motion(x, u, NULL, NULL, slope, NULL);
}

static int adjoint_slopes(const double *x, const double *u, const double *lam, double *slope, double *hessian)
{
    return motion(x, u, lam, NULL, slope, hessian);
}

/* slope^T lam. */
static void pulled_back(const double *slope, const double *lam, double *adj, int count)
{
    for (int j = 0; j < count; ++j) {
        adj[j] = 0.0;
        for (int i = 0; i < NX; ++i) {
            adj[j] += slope[j * NX + i] * lam[i];
        }
    }
}

static int adjoint(const double *x, const double *u, const double *lam, double *adj_x, double *adj_u)
{
    double slope[NX * NV];
    const int status = ode_slopes(x, u, slope);
    if (status == 0) {
        pulled_back(slope, lam, adj_x, NX);
        pulled_back(slope + NX * NX, lam, adj_u, NU);
    }
    return status;
}

/* change (NX x NV) of x_dot where x changes by sens (NX x NV) and u by the unit matrix in the last NU columns. */
static void carried(const double *slope, const double *sens, double *change)
{
    for (int j = 0; j < NV; ++j) {
        for (int i = 0; i < NX; ++i) {
            double total = j < NX ? 0.0 : slope[j * NX + i];
            for (int k = 0; k < NX; ++k) {
                total += slope[k * NX + i] * sens[j * NX + k];
            }
            change[j * NX + i] = total;
        }
    }
}

/* total += T^T hessian T with T = (sens; 0 1), both (NV x NV). */
static void add_pulled_back(const double *hessian, const double *sens, double *total)
{
    double half[NV * NV];
    for (int j = 0; j < NV; ++j) {
        for (int i = 0; i < NV; ++i) {
            double sum = j < NX ? 0.0 : hessian[j * NV + i];
            for (int k = 0; k < NX; ++k) {
                sum += hessian[k * NV + i] * sens[j * NX + k];
            }
            half[j * NV + i] = sum;
        }
    }
    for (int j = 0; j < NV; ++j) {
        for (int i = 0; i < NV; ++i) {
            double sum = i < NX ? 0.0 : half[j * NV + i];
            for (int k = 0; k < NX; ++k) {
                sum += sens[i * NX + k] * half[j * NV + k];
            }
            total[j * NV + i] += sum;
        }
    }
}

/* The functions that acados asks for, explicit ordinary differential equation. */
static int expl_ode_fun(const double *x, const double *u, const double *p, double *x_dot)
{
    (void)p;
    return ode(x, u, x_dot);
}

static int expl_vde_forw(const double *x, const double *sx, const double *su, const double *u, const double *p,
    double *x_dot, double *vde_x, double *vde_u)
{
    double slope[NX * NV];
    double sens[NX * NV];
    double change[NX * NV];
    const int status = motion(x, u, NULL, x_dot, slope, NULL);
    (void)p;
    if (status > 0) {
        return status;
    }
    for (int k = 0; k < NX * NV; ++k) {
        sens[k] = k < NX * NX ? sx[k] : su[k - NX * NX];
    }
    carried(slope, sens, change);
    for (int k = 0; k < NX * NX; ++k) {
        vde_x[k] = change[k];
    }
    for (int k = 0; k < NX * NU; ++k) {
        vde_u[k] = change[NX * NX + k];
    }
    return 0;
}

static int expl_vde_adj(const double *x, const double *lam, const double *u, const double *p, double *adj)
{
    (void)p;
    return adjoint(x, u, lam, adj, adj + NX);
}

static int expl_ode_hess(const double *x, const double *sx, const double *su, const double *lam, const double *u,
    const double *p, double *adj, double *lower)
{
    double slope[NX * NV];
    double hessian[NV * NV];
    double sens[NX * NV];
    double total[NV * NV];
    const int status = adjoint_slopes(x, u, lam, slope, hessian);
    int at = 0;
    (void)p;
    if (status > 0) {
        return status;
    }
    pulled_back(slope, lam, adj, NV);
    for (int k = 0; k < NX * NV; ++k) {
        sens[k] = k < NX * NX ? sx[k] : su[k - NX * NX];
    }
    for (int k = 0; k < NV * NV; ++k) {
        total[k] = 0.0;
    }
    add_pulled_back(hessian, sens, total);
    for (int j = 0; j < NV; ++j) {
        for (int i = j; i < NV; ++i) {
            lower[at++] = total[j * NV + i];
        }
    }
    return 0;
}

/* A Runge-Kutta step of order 4 and length p[0], its slope (NX x NV) and the Hessian of lam . phi by (x, u). */
static int step(
    const double *x, const double *u, const double *p, const double *lam, double *phi, double *jac, double *hess)
{
    static const double part[4] = {0.0, 0.5, 0.5, 1.0};
    static const double weight[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    const double h = p[0];
    double at[4][NX];
    double rate[4][NX];
    double slope[4][NX * NV];
    double sens[4][NX * NV];
    double change[4][NX * NV];
    for (int s = 0; s < 4; ++s) {
        for (int k = 0; k < NX; ++k) {
            at[s][k] = x[k] + (s > 0 ? h * part[s] * rate[s - 1][k] : 0.0);
        }
        const int status = motion(at[s], u, NULL, rate[s], jac != NULL ? slope[s] : NULL, NULL);
        if (status > 0) {
            return status;
        }
        if (jac != NULL) {
            for (int k = 0; k < NX * NV; ++k) {
                sens[s][k] = (k % NX == k / NX ? 1.0 : 0.0) + (s > 0 ? h * part[s] * change[s - 1][k] : 0.0);
            }
            carried(slope[s], sens[s], change[s]);
        }
    }
    for (int k = 0; k < NX; ++k) {
        phi[k] = x[k];
        for (int s = 0; s < 4; ++s) {
            phi[k] += h * weight[s] * rate[s][k];
        }
    }
    for (int k = 0; jac != NULL && k < NX * NV; ++k) {
        jac[k] = k % NX == k / NX ? 1.0 : 0.0;
        for (int s = 0; s < 4; ++s) {
            jac[k] += h * weight[s] * change[s][k];
        }
    }
    if (hess == NULL) {
        return 0;
    }
    for (int k = 0; k < NV * NV; ++k) {
        hess[k] = 0.0;
    }
    double later[NX];
    for (int k = 0; k < NX; ++k) {
        later[k] = 0.0;
    }
    for (int s = 3; s >= 0; --s) {
        double own[NX];
        double bent[NV * NV];
        for (int k = 0; k < NX; ++k) {
            own[k] = h * weight[s] * lam[k] + (s < 3 ? h * part[s + 1] * later[k] : 0.0);
        }
        const int status = motion(at[s], u, own, NULL, NULL, bent);
        if (status > 0) {
            return status;
        }
        add_pulled_back(bent, sens[s], hess);
        pulled_back(slope[s], own, later, NX);
    }
    return 0;
}

static int disc_dyn_fun(const double *x, const double *u, const double *p, double *phi)
{
    return step(x, u, p, NULL, phi, NULL, NULL);
}

/* Rows (u, x) of the transposed slope, as acados orders them. */
static void in_order_of_acados(const double *jac, double *by_ux)
{
    for (int j = 0; j < NX; ++j) {
        for (int i = 0; i < NV; ++i) {
            by_ux[j * NV + (i < NX ? NU + i : i - NX)] = jac[i * NX + j];
        }
    }
}

static int disc_dyn_fun_jac(const double *x, const double *u, const double *p, double *phi, double *by_ux)
{
    double jac[NX * NV];
    const int status = step(x, u, p, NULL, phi, jac, NULL);
    if (status == 0) {
        in_order_of_acados(jac, by_ux);
    }
    return status;
}

static int disc_dyn_fun_jac_hess(
    const double *x, const double *u, const double *lam, const double *p, double *phi, double *by_ux, double *bent)
{
    double jac[NX * NV];
    double hess[NV * NV];
    const int status = step(x, u, p, lam, phi, jac, hess);
    if (status > 0) {
        return status;
    }
    in_order_of_acados(jac, by_ux);
    for (int j = 0; j < NV; ++j) {
        for (int i = 0; i < NV; ++i) {
            bent[(j < NX ? NU + j : j - NX) * NV + (i < NX ? NU + i : i - NX)] = hess[j * NV + i];
        }
    }
    return 0;
}
