/* ---- Numbers along a straight motion, with bounds: x(t) is within r of m + c t for every t in [-1, 1]. Every sum and
   product adds UNIT times its terms for rounding and TINY for underflow; radii are sums and products of numbers that are
   not negative, rounded fewer than 2^12 times one after the other, so that they are right to one part in 2^40, which
   SLACK adds where a bound is used. It holds for any rounding mode. ---- */

#define UNIT 2.3e-16 /* above 2^-52: one unit in the last place */
#define TINY 1e-300
#define SLACK 1.000000000001 /* 1 + 2^-40 */

typedef struct {
    double m, c, r;
} Ball;

static inline Ball ball_of(double m)
{
    const Ball x = {m, 0.0, 0.0};
    return x;
}

static inline Ball ball_add(Ball a, Ball b)
{
    const double m = a.m + b.m, c = a.c + b.c;
    const Ball x = {m, c, a.r + b.r + UNIT * (fabs(m) + fabs(c))};
    return x;
}

static inline Ball ball_sub(Ball a, Ball b)
{
    const double m = a.m - b.m, c = a.c - b.c;
    const Ball x = {m, c, a.r + b.r + UNIT * (fabs(m) + fabs(c))};
    return x;
}

static inline Ball ball_mul(Ball a, Ball b)
{
    const double m = a.m * b.m, one = a.m * b.c, two = a.c * b.m, size = fabs(b.m) + fabs(b.c);
    const double rounding = UNIT * (fabs(m) + 2.0 * (fabs(one) + fabs(two))) + TINY;
    const Ball x = {
        m, one + two, (fabs(a.m) + fabs(a.c)) * b.r + a.r * (size + b.r) + fabs(a.c * b.c) + rounding};
    return x;
}

static inline Ball ball_times(double a, Ball b)
{
    const double m = a * b.m, c = a * b.c;
    const Ball x = {m, c, fabs(a) * b.r + UNIT * (fabs(m) + fabs(c)) + TINY};
    return x;
}

/* Doubles without bounds, for guesses. */
static inline double plain_of(double a)
{
    return a;
}

static inline double plain_add(double a, double b)
{
    return a + b;
}

static inline double plain_sub(double a, double b)
{
    return a - b;
}

static inline double plain_mul(double a, double b)
{
    return a * b;
}

static inline double plain_times(double a, double b)
{
    return a * b;
}

static inline double ball_size(Ball a)
{
    return fabs(a.m) + fabs(a.c) + a.r;
}
