/* One UPS limb of inverse dynamics, for any REAL: double, or a vector with a limb in each lane.

   Local axes: X along the first axis of the universal joint at (0, 0, 0), Z upwards. d is the vector to the tip, v and
   a are the tip's velocity and acceleration. Leg axes: x = X cos - W sin, y, z = s along the leg; W = z x X turned.
   The leg turns with the universal joint; with m1, m2 the masses at e1 from the base and e2 from the tip, and Jx, Jy,
   Jz the sums of both bodies' principal inertias, momenta about the two axes of the joint give the force across the
   leg, the upper body the force along it but for the drive. */
typedef struct {
    REAL cosine, sine;            /* of the first angle: y = (0, cosine, sine), W = (0, -sine, cosine) */
    REAL across, along;           /* s = along X + across W */
    REAL slope, reciprocal;       /* along / across, 1 / length */
    REAL fX, fY, fZ;              /* force on the tip but for the drive's, local axes */
    /* for the wrenches of its joints, in leg axes: the tip's force, what each body takes, moments about the base */
    REAL fx, fy, fz, length, lower_x, lower_y, lower_z, upper_x, upper_y, moment_x, moment_y, mz;
} NAME(leg);

/* From axes, angular velocity w and acceleration b, accelerations per length k, and the tip's acceleration a. */
static inline __attribute__((always_inline)) NAME(leg) NAME(forces)(
    REAL c, REAL s, REAL across, REAL along, REAL slope, REAL length, REAL over_length, REAL wx, REAL wy, REAL wz,
    REAL bx, REAL by, REAL bz, REAL kx, REAL ky, REAL kz, REAL ax, REAL ay, REAL az)
{
    const REAL turn = wy * wz;
    const REAL gx = -G * along * c, gy = G * s, gz = G * across * c;
    /* moments about the joint */
    const REAL lower_x = E1 * kx + gx, lower_y = E1 * ky + gy;
    const REAL upper_x = ax + gx - E2 * kx, upper_y = ay + gy - E2 * ky, upper_z = az + gz - E2 * kz;
    const REAL arm = M2 * (length - E2);
    const REAL mx = JX * bx + (JZ - JY) * turn - (M1 * E1) * lower_y - arm * upper_y;
    const REAL my = JY * by + (JX - JZ) * (wz * wx) + (M1 * E1) * lower_x + arm * upper_x;
    const REAL mz = JZ * bz + (JY - JX) * (wx * wy);
    const REAL fx = my * over_length, fy = -(mx + slope * mz) * over_length, fz = M2 * upper_z;
    const REAL fW = across * fz - along * fx;
    NAME(leg) leg;
    leg.cosine = c;
    leg.sine = s;
    leg.across = across;
    leg.along = along;
    leg.slope = slope;
    leg.reciprocal = over_length;
    leg.fx = fx;
    leg.fy = fy;
    leg.fz = fz;
    leg.length = length;
    leg.lower_x = M1 * lower_x;
    leg.lower_y = M1 * lower_y;
    leg.lower_z = M1 * (E1 * kz + gz);
    leg.upper_x = M2 * upper_x;
    leg.upper_y = M2 * upper_y;
    leg.moment_x = 0.5 * (JX * bx + (JZ - JY) * turn) - arm * upper_y;
    leg.moment_y = 0.5 * (JY * by + (JX - JZ) * (wz * wx)) + arm * upper_x;
    leg.mz = mz;
    leg.fX = across * fx + along * fz;
    leg.fY = c * fy - s * fW;
    leg.fZ = s * fy + c * fW;
    return leg;
}

static inline __attribute__((always_inline)) NAME(leg) NAME(limb)(
    REAL dX, REAL dY, REAL dZ, REAL vX, REAL vY, REAL vZ, REAL aX, REAL aY, REAL aZ)
{
    const REAL square = dY * dY + dZ * dZ;
    const REAL height = ROOT(square);
    const REAL length = ROOT(square + dX * dX);
    const REAL both = 1.0 / (height * length);
    const REAL over_height = both * length, over_length = both * height;
    const REAL c = dZ * over_height, s = -dY * over_height;
    const REAL across = height * over_length, along = dX * over_length, slope = dX * over_height;
    /* tip in leg axes */
    const REAL vW = c * vZ - s * vY, aW = c * aZ - s * aY;
    const REAL vx = across * vX - along * vW, vy = c * vY + s * vZ, vz = along * vX + across * vW;
    const REAL ax = across * aX - along * aW, ay = c * aY + s * aZ, az = along * aX + across * aW;
    /* turning: k is the acceleration per length along the leg */
    const REAL wx = -vy * over_length, wy = vx * over_length, wz = slope * wx;
    const REAL twice = 2.0 * vz;
    const REAL kx = (ax - twice * wy) * over_length, ky = (ay + twice * wx) * over_length;
    const REAL kz = -(wx * wx + wy * wy);
    const REAL turn = wy * wz;
    const REAL bx = turn - ky, by = kx - wx * wz;
    const REAL bz = slope * bx + wx * wy * (1.0 + slope * slope);
    return NAME(forces)(c, s, across, along, slope, length, over_length, wx, wy, wz, bx, by, bz, kx, ky, kz,
                        ax, ay, az);
}

/* The same from the leg's own coordinates, rates v and accelerations a: two angles, given by s, c and sine, cosine, and
   the slider. lean: sine of its lean at rest, towards X. */
static inline __attribute__((always_inline)) NAME(leg) NAME(own)(
    REAL s, REAL c, REAL sine, REAL cosine, REAL slider, REAL v1, REAL v2, REAL v3, REAL a1, REAL a2, REAL a3,
    REAL lean)
{
    const REAL along = lean * cosine + LEG_COSINE * sine, across = LEG_COSINE * cosine - lean * sine;
    const REAL length = slider + LEG_OFFSET, over_height = 1.0 / (length * across);
    const REAL over_length = over_height * across, slope = along * length * over_height;
    const REAL wx = across * v1, wz = along * v1, v12 = v1 * v2, twice = 2.0 * v3;
    const REAL bx = across * a1 - along * v12, bz = along * a1 + across * v12;
    const REAL kx = a2 + wx * wz, ky = v2 * wz - bx, kz = -(wx * wx + v2 * v2);
    return NAME(forces)(c, s, across, along, slope, length, over_length, wx, v2, wz, bx, a2, bz, kx, ky, kz,
                        length * kx + twice * v2, length * ky - twice * wx, a3 + length * kz);
}

/* Wrenches (force, moment about O) of a leg's joints in local axes, both bodies having the same inertia: base on lower,
   lower on upper without the drive, upper on the platform. u: the drive; kx, ky, ny, nz: what the platform's couple adds
   to the force and the moment on the platform, in leg axes; A: the base point's X. */
typedef struct {
    REAL base[6], slider[6], tip[6];
} NAME(wrenches);

static inline __attribute__((always_inline)) void NAME(local)(
    const NAME(leg) *leg, REAL x, REAL y, REAL z, REAL *restrict out)
{
    const REAL W = leg->across * z - leg->along * x;
    out[0] = leg->across * x + leg->along * z;
    out[1] = leg->cosine * y - leg->sine * W;
    out[2] = leg->sine * y + leg->cosine * W;
}

static inline __attribute__((always_inline)) NAME(wrenches) NAME(joints)(
    const NAME(leg) *leg, REAL u, REAL kx, REAL ky, REAL ny, REAL nz, REAL CX, REAL CY, REAL CZ, REAL A)
{
    NAME(wrenches) out;
    const REAL fx = kx - leg->fx, fy = ky - leg->fy, fz = u - leg->fz, Z = leg->mz - nz;
    const REAL px = leg->upper_x + fx, py = leg->upper_y + fy;
    NAME(local)(leg, fx, fy, fz, out.tip);
    NAME(local)(leg, 0.0 * u, -ny, -nz, out.tip + 3);
    out.tip[3] += CY * out.tip[2] - CZ * out.tip[1];
    out.tip[4] += CZ * out.tip[0] - CX * out.tip[2];
    out.tip[5] += CX * out.tip[1] - CY * out.tip[0];
    NAME(local)(leg, px, py, 0.0 * u, out.slider);
    NAME(local)(leg, leg->moment_x - leg->length * fy, leg->moment_y + leg->length * fx - ny, 0.5 * leg->mz - nz,
                out.slider + 3);
    NAME(local)(leg, px + leg->lower_x, py + leg->lower_y, u + leg->lower_z, out.base);
    NAME(local)(leg, -leg->slope * Z, 0.0 * u, Z, out.base + 3);
    out.slider[4] -= A * out.slider[2];
    out.slider[5] += A * out.slider[1];
    out.base[4] -= A * out.base[2];
    out.base[5] += A * out.base[1];
    return out;
}
