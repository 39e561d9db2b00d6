/* Drives, rates and Jacobian of the delta robot, by hand; see seed.c. No checks.

   The platform does not turn and the two rods of an arm stay parallel: only the arms' angles and the platform's position
   are read. A slender rod is a third of its mass at each end and a sixth between them; its tension acts along it, and
   the three equations of the platform give the three tensions. */
#define DELTA_ARM 0.3
#define DELTA_ROD_SQUARE 0.48999999999999999
#define DELTA_RADII (-0.15) /* of the platform less that of the base */
#define M_ARM 0.4
#define M_ROD 0.1
#define M_PLATFORM 0.5
#define ROOT3_2 0.86602540378443865

static const double delta_c[3] = {1.0, -0.5, -0.5}, delta_s[3] = {0.0, ROOT3_2, -ROOT3_2};

/* Platform at p with acceleration a; sines and cosines of the arms' angles, their rates and accelerations. */
static inline __attribute__((always_inline)) int delta_drives(
    const double *restrict p, const double *restrict a, lanes sine, lanes cosine, lanes rate, lanes gains,
    double *restrict u)
{
    const double g = 9.81, M = M_PLATFORM + 2.0 * M_ROD, ends = M_ROD / 3.0;
    double f[3] = {M * a[0], M * a[1], M * a[2] + (M_PLATFORM + 3.0 * M_ROD) * g}, n[3][3];
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
        const double ls = DELTA_ARM * sine[k], lc = DELTA_ARM * cosine[k], square = rate[k] * rate[k];
        const double gain = gains[k];
        const double out = DELTA_RADII - lc, knee = -ends * (gain * ls + square * lc);
        n[k][0] = p[0] + delta_c[k] * out;
        n[k][1] = p[1] + delta_s[k] * out;
        n[k][2] = p[2] + ls;
        f[0] += delta_c[k] * knee;
        f[1] += delta_s[k] * knee;
        f[2] += ends * (square * ls - gain * lc);
    }
    const double x[3] = {n[1][1] * n[2][2] - n[1][2] * n[2][1], n[1][2] * n[2][0] - n[1][0] * n[2][2],
                         n[1][0] * n[2][1] - n[1][1] * n[2][0]};
    const double over = 1.0 / (n[0][0] * x[0] + n[0][1] * x[1] + n[0][2] * x[2]);
    const double y[3] = {f[1] * n[0][2] - f[2] * n[0][1], f[2] * n[0][0] - f[0] * n[0][2],
                         f[0] * n[0][1] - f[1] * n[0][0]};
    const double tension[3] = {
        (f[0] * x[0] + f[1] * x[1] + f[2] * x[2]) * over, -(y[0] * n[2][0] + y[1] * n[2][1] + y[2] * n[2][2]) * over,
        (y[0] * n[1][0] + y[1] * n[1][1] + y[2] * n[1][2]) * over};
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
        const double ls = DELTA_ARM * sine[k], lc = DELTA_ARM * cosine[k];
        /* force of the rods on the knee, radial and upwards */
        const double fx = ends * (delta_c[k] * a[0] + delta_s[k] * a[1])
                          + tension[k] * (delta_c[k] * n[k][0] + delta_s[k] * n[k][1]);
        const double fz = ends * a[2] + tension[k] * n[k][2] + (0.5 * M_ARM + M_ROD) * g;
        u[k] = (M_ARM + 2.0 * M_ROD) / 3.0 * DELTA_ARM * DELTA_ARM * gains[k] - ls * fx - lc * fz;
    }
    return 0;
}

int lean_delta_drives(
    const double *restrict q, const double *restrict v, const double *restrict a, double *restrict u)
{
    const lanes angle = {q[0], q[5], q[10], q[10]}, rate = {v[0], v[5], v[10], v[10]};
    const lanes gain = {a[0], a[5], a[10], a[10]};
    return delta_drives(q + 15, a + 15, _ZGVdN4v_sin(angle), _ZGVdN4v_cos(angle), rate, gain, u);
}

/* Drives from the platform's motion: the arms' angles by the law of cosines, knees outwards, all arms in lanes. */
int lean_delta_platform(
    const double *restrict p, const double *restrict v, const double *restrict a, double *restrict u)
{
    const lanes c = {1.0, -0.5, -0.5, -0.5}, s = {0.0, ROOT3_2, -ROOT3_2, -ROOT3_2};
    const lanes x = c * p[0] + s * p[1] + DELTA_RADII, y = c * p[1] - s * p[0], z = p[2] + 0.0 * c;
    const lanes vx = c * v[0] + s * v[1], vy = c * v[1] - s * v[0], vz = v[2] + 0.0 * c;
    const lanes ax = c * a[0] + s * a[1], ay = c * a[1] - s * a[0], az = a[2] + 0.0 * c;
    const lanes both = x * x + z * z;
    const lanes k = (both + y * y + (DELTA_ARM * DELTA_ARM - DELTA_ROD_SQUARE)) * (0.5 / DELTA_ARM);
    const lanes root = roots(both - k * k), over = 1.0 / both;
    const lanes cosine = (x * k - z * root) * over, sine = (-z * k - x * root) * over;
    /* x sine + z cosine is -root */
    const lanes ls = DELTA_ARM * sine, lc = DELTA_ARM * cosine, nx = x - lc, nz = z + ls, lever = 1.0 / root;
    const lanes rate = (nx * vx + y * vy + nz * vz) * lever * (1.0 / DELTA_ARM);
    const lanes wx = vx + ls * rate, wz = vz + lc * rate;
    const lanes bend = wx * wx + vy * vy + wz * wz + rate * rate * (nx * lc - nz * ls);
    const lanes gain = (nx * ax + y * ay + nz * az + bend) * lever * (1.0 / DELTA_ARM);
    return delta_drives(p, a, sine, cosine, rate, gain, u);
}

/* Rates of the tree from the platform's velocity. */
int lean_delta_velocity(const double *restrict q, const double *restrict y, double *restrict v)
{
    const lanes angle = {q[0], q[5], q[10], q[10]}, sine = _ZGVdN4v_sin(angle), cosine = _ZGVdN4v_cos(angle);
    double nX[3], nY[3], nZ[3], square[3], arm[3], both[3];
    lanes height;
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
        const double ls = DELTA_ARM * sine[k], lc = DELTA_ARM * cosine[k];
        nX[k] = delta_c[k] * q[15] + delta_s[k] * q[16] + DELTA_RADII - lc;
        nY[k] = delta_c[k] * q[16] - delta_s[k] * q[15];
        nZ[k] = q[17] + ls;
        arm[k] = nX[k] * ls + nZ[k] * lc;
        square[k] = DELTA_ROD_SQUARE - nY[k] * nY[k];
        height[k] = square[k];
        both[k] = 1.0 / (arm[k] * square[k]);
    }
    height[3] = 1.0;
    height = roots(height);
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k) {
        const double ls = DELTA_ARM * sine[k], lc = DELTA_ARM * cosine[k], over = both[k] * arm[k];
        const double vX = delta_c[k] * y[0] + delta_s[k] * y[1], vY = delta_c[k] * y[1] - delta_s[k] * y[0];
        const double rate = -(nX[k] * vX + nY[k] * vY + nZ[k] * y[2]) * (both[k] * square[k]);
        const double turn = ((vX + ls * rate) * nZ[k] - (y[2] + lc * rate) * nX[k]) * over - rate;
        const double tilt = vY * height[k] * over;
        v[5 * k] = rate;
        v[5 * k + 1] = v[5 * k + 3] = turn;
        v[5 * k + 2] = v[5 * k + 4] = tilt;
    }
    v[15] = y[0];
    v[16] = y[1];
    v[17] = y[2];
    v[18] = v[19] = v[20] = 0.0;
    return 0;
}

/* Accelerations of the tree from the drives: the platform's by virtual work, all arms in lanes.

   An arm's rate is G.v and its acceleration G.a + b with v and a the platform's; its knee moves as D G.v, and the knee's
   acceleration is D (G.a + b) + E rate^2. The lanes of the fourth arm count nothing. */
int lean_delta_forward(
    const double *restrict q, const double *restrict v, const double *restrict u, double *restrict a)
{
    const double g = 9.81, M = M_PLATFORM + 2.0 * M_ROD, J = (M_ARM + 2.0 * M_ROD) / 3.0 * DELTA_ARM * DELTA_ARM;
    const lanes c = {1.0, -0.5, -0.5, 0.0}, s = {0.0, ROOT3_2, -ROOT3_2, 0.0}, one = {1.0, 1.0, 1.0, 0.0};
    const lanes angle = {q[0], q[5], q[10], q[10]}, rate = {v[0], v[5], v[10], v[10]}, drive = {u[0], u[1], u[2], u[2]};
    const lanes ls = DELTA_ARM * _ZGVdN4v_sin(angle), lc = DELTA_ARM * _ZGVdN4v_cos(angle), ends = M_ROD / 3.0 * one;
    const lanes nx = c * q[15] + s * q[16] + DELTA_RADII - lc, ny = c * q[16] - s * q[15], nz = q[17] + ls;
    const lanes vx = c * v[15] + s * v[16], vy = c * v[16] - s * v[15], turning = rate * rate;
    const lanes wx = vx + ls * rate, wz = v[17] + lc * rate, over = 1.0 / (nx * ls + nz * lc);
    const lanes b = -(wx * wx + vy * vy + wz * wz + turning * (nx * lc - nz * ls)) * over;
    const lanes gx = -(c * nx - s * ny) * over, gy = -(s * nx + c * ny) * over, gz = -nz * over * one;
    const lanes dx = -ls * c, dy = -ls * s, dz = -lc * one;
    const lanes jx = J * gx + ends * dx, jy = J * gy + ends * dy, jz = J * gz + ends * dz;
    const lanes left = drive - J * b + lc * ((0.5 * M_ARM + M_ROD) * g), knee = ends * b, bent = ends * turning;
    const lanes fx = gx * left - dx * knee + bent * lc * c, fy = gy * left - dy * knee + bent * lc * s;
    const lanes fz = gz * left - dz * knee - bent * ls;
    const lanes xx = gx * (jx + ends * dx), yy = gy * (jy + ends * dy), zz = gz * (jz + ends * dz);
    const lanes xy = gx * jy + ends * dx * gy, xz = gx * jz + ends * dx * gz, yz = gy * jz + ends * dy * gz;
#define TOTAL(x) ((x[0] + x[1]) + x[2])
    const double A = M + TOTAL(xx), B = M + TOTAL(yy), C = M + TOTAL(zz), D = TOTAL(xy), E = TOTAL(xz), F = TOTAL(yz);
    const double f[3] = {TOTAL(fx), TOTAL(fy), TOTAL(fz) - (M_PLATFORM + 3.0 * M_ROD) * g};
    const double i = B * C - F * F, j = E * F - D * C, k = D * F - E * B, share = 1.0 / (A * i + D * j + E * k);
    const double x = (i * f[0] + j * f[1] + k * f[2]) * share;
    const double y = (j * f[0] + (A * C - E * E) * f[1] + (D * E - A * F) * f[2]) * share;
    const double z = (k * f[0] + (D * E - A * F) * f[1] + (A * B - D * D) * f[2]) * share;
    const lanes gain = gx * x + gy * y + gz * z + b;
    /* the rods turn by psi in their arm's plane and are tilted against it */
    const lanes square = DELTA_ROD_SQUARE - ny * ny, inverse = 1.0 / square, height = roots(square) * inverse;
    const lanes psi = (wx * nz - wz * nx) * inverse;
    const lanes ax = c * x + s * y + ls * gain + lc * turning, az = z + lc * gain - ls * turning;
    const lanes turn = (ax * nz - az * nx + 2.0 * psi * ny * vy) * inverse - gain;
    const lanes tilt = (c * y - s * x + ny * vy * vy * inverse) * height;
#pragma GCC unroll 3
    for (int m = 0; m < 3; ++m) {
        a[5 * m] = gain[m];
        a[5 * m + 1] = a[5 * m + 3] = turn[m];
        a[5 * m + 2] = a[5 * m + 4] = tilt[m];
    }
    a[15] = x;
    a[16] = y;
    a[17] = z;
    a[18] = a[19] = a[20] = 0.0;
    return 0;
}

/* Twists at O of the platform per rate of the tree: its velocity, and turning about its point. */
int lean_delta_jacobian(const double *restrict q, double *restrict jacobian)
{
    platform at;
    turned(q + 18, &at);
    for (int k = 0; k < 126; ++k) {
        jacobian[k] = 0.0;
    }
    jacobian[93] = jacobian[100] = jacobian[107] = 1.0;
#define COLUMN(k, e)                                                                                               \
    jacobian[k] = at.e[0];                                                                                         \
    jacobian[k + 1] = at.e[1];                                                                                     \
    jacobian[k + 2] = at.e[2];                                                                                     \
    jacobian[k + 3] = q[16] * at.e[2] - q[17] * at.e[1];                                                           \
    jacobian[k + 4] = q[17] * at.e[0] - q[15] * at.e[2];                                                           \
    jacobian[k + 5] = q[15] * at.e[1] - q[16] * at.e[0];
    COLUMN(108, X)
    COLUMN(114, Y)
    COLUMN(120, Z)
    return 0;
}
