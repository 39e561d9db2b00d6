/* ---- Complex numbers in lanes: a path in each. ---- */

#if defined(__GNUC__)
#if defined(__AVX512F__)
#define LANES 8
#elif defined(__AVX__)
#define LANES 4
#else
#define LANES 2
#endif
typedef double Wide __attribute__((vector_size(LANES * 8)));
typedef long long Mask __attribute__((vector_size(LANES * 8)));
#define CHOOSE(mask, a, b) ((Wide)(((mask) & (Mask)(a)) | (~(mask) & (Mask)(b))))
#define ABOVE(a, b) ((Mask)((a) > (b)))
#else
#define LANES 1
typedef double Wide;
typedef int Mask;
#define CHOOSE(mask, a, b) ((mask) ? (a) : (b))
#define ABOVE(a, b) ((a) > (b))
#endif

typedef struct {
    Wide re, im;
} Lanes;

static inline Wide wide(double a)
{
    Wide x = {0};
    for (int k = 0; k < LANES; ++k) {
        ((double *)&x)[k] = a;
    }
    return x;
}

static inline Lanes lanes_of(double a)
{
    const Lanes x = {wide(a), wide(0.0)};
    return x;
}

static inline Lanes lanes_add(Lanes a, Lanes b)
{
    const Lanes x = {a.re + b.re, a.im + b.im};
    return x;
}

static inline Lanes lanes_sub(Lanes a, Lanes b)
{
    const Lanes x = {a.re - b.re, a.im - b.im};
    return x;
}

static inline Lanes lanes_mul(Lanes a, Lanes b)
{
    const Lanes x = {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    return x;
}

static inline Lanes lanes_times(double a, Lanes b)
{
    const Lanes x = {a * b.re, a * b.im};
    return x;
}

static inline Wide lanes_square(Lanes a)
{
    return a.re * a.re + a.im * a.im;
}
