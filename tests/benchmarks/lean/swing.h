/* One UPS limb of forward dynamics from its own coordinates, for any REAL: double, or a vector of limbs.

   Local axes as in limb.h, A the base point's X. The limb's rates are rows of the platform's angular velocity w:
   first angle wX - ratio wW, second angle turn wy, slider -reach wy, in the axes X, y = (0, c, s), W = (0, -s, c).
   Its own equations are diagonal: with I1, I2 the inertias of both bodies about the first and the second axis, it adds
   I1 t t' + (I2 turn^2 + M2 reach^2) y y' to the platform's inertia, t = X - ratio W. */
typedef struct {
    REAL c, s, across, along;
    REAL ratio, turn, reach;     /* the rows */
    REAL wy, wW;                 /* the platform's angular velocity */
    REAL first, second, third;   /* accelerations of the coordinates that rates alone make */
    REAL XX, XY, XZ, YY, YZ, ZZ; /* what it adds to the inertia */
    REAL X, Y, Z;                /* and to the moment, local axes */
} NAME(swing);

/* s, c and sine, cosine of the angles; lean: sine of the leg's lean at rest, towards X */
static inline __attribute__((always_inline)) NAME(swing) NAME(swung)(
    REAL s, REAL c, REAL sine, REAL cosine, REAL slider, REAL v1, REAL v2, REAL v3, REAL u, REAL wY, REAL wZ, REAL A,
    REAL lean)
{
    NAME(swing) limb;
    const REAL along = lean * cosine + LEG_COSINE * sine, across = LEG_COSINE * cosine - lean * sine;
    const REAL length = slider + LEG_OFFSET, arm = slider + (LEG_OFFSET - E2), height = length * across;
    const REAL over_height = 1.0 / height, over = over_height * across;
    const REAL turn = 1.0 + A * along * over, reach = A * across;
    const REAL ratio = (A + length * along) * over_height;
    const REAL wy = c * wY + s * wZ, wW = c * wZ - s * wY;
    const REAL v1W = v1 * wW, slope = 1.0 + ratio * ratio;
    const REAL first = wy * (ratio * v1 - slope * wW);
    const REAL second = turn * v1W + A * over * (across * v2 - along * over * v3) * wy;
    const REAL third = A * along * v2 * wy - reach * v1W;
    /* momenta: first angle, second angle, slider */
    const REAL swept = M2 * arm, weight = G * (M1 * E1 + swept), both = M1 * E1 * E1 + swept * arm;
    const REAL I2 = JY + both, difference = (JX - JZ) + both, square = across * across;
    const REAL I1 = JZ + square * difference, mixed = across * along * difference;
    const REAL b1 = 2.0 * v1 * (square * swept * v3 - mixed * v2) - weight * s * across;
    const REAL b2 = 2.0 * swept * v3 * v2 + mixed * v1 * v1 - weight * c * along;
    const REAL b3 = (M2 * G) * c * across - swept * (square * v1 * v1 + v2 * v2);
    const REAL moment = I1 * first + b1, t = moment * ratio;
    const REAL y = turn * (I2 * second + b2) - reach * (M2 * third + b3 - u);
    const REAL d = I2 * turn * turn + M2 * reach * reach, part = I1 * ratio, most = part * ratio, k = most - d;
    const REAL sk = s * k;
    limb.c = c;
    limb.s = s;
    limb.across = across;
    limb.along = along;
    limb.ratio = ratio;
    limb.turn = turn;
    limb.reach = reach;
    limb.wy = wy;
    limb.wW = wW;
    limb.first = first;
    limb.second = second;
    limb.third = third;
    limb.XX = I1;
    limb.XY = part * s;
    limb.XZ = -part * c;
    limb.YY = d + s * sk;
    limb.YZ = -c * sk;
    limb.ZZ = most - s * sk;
    limb.X = moment;
    limb.Y = t * s + y * c;
    limb.Z = y * s - t * c;
    return limb;
}

/* Accelerations of the limb's coordinates from those of the platform. */
static inline __attribute__((always_inline)) void NAME(follow)(
    const NAME(swing) *limb, REAL aX, REAL aY, REAL aZ, REAL *restrict out)
{
    const REAL ay = limb->c * aY + limb->s * aZ, aW = limb->c * aZ - limb->s * aY;
    out[0] = aX - limb->ratio * aW + limb->first;
    out[1] = limb->turn * ay + limb->second;
    out[2] = limb->third - limb->reach * ay;
}
