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
} NAME(leg);

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
    leg.fX = across * fx + along * fz;
    leg.fY = c * fy - s * fW;
    leg.fZ = s * fy + c * fW;
    return leg;
}
