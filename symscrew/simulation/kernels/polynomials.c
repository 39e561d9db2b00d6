/* Zeros within a step. Positions and rates of a step are polynomials of time; what is no
 * polynomial (forces, states near singular configurations) is taken through SAMPLES of it. A polynomial that is positive
 * at all of its Bernstein coefficients is so throughout, so halving the interval finds the first root, however short the
 * excursion behind it is (Farouki, CAGD 29, 2012, 379, section 3). */
#if CONTACTS || SWITCHES
#define SAMPLES 9
#define DEGREE (SAMPLES - 1)
typedef struct {
    double c[SAMPLES]; /* of powers of the part of the step, 0 to 1 */
} Polynomial;

/* The dense output of y[i]. */
static Polynomial dense_polynomial(const Step *s, int i)
{
    Polynomial p = {{0.0}};
    for (int j = 6; j >= 0; --j) {
        double next[SAMPLES] = {0.0};
        p.c[0] += s->dense[j][i];
        for (int k = 0; k < DEGREE; ++k) {
            if (j % 2 == 0) {
                next[k + 1] += p.c[k];
            } else {
                next[k] += p.c[k];
                next[k + 1] -= p.c[k];
            }
        }
        memcpy(p.c, next, sizeof next);
    }
    p.c[0] += s->start[i];
    return p;
}

static double sample_place(int i)
{
    return 0.5 * (1.0 - cos(3.14159265358979323846 * i / DEGREE)); /* Chebyshev's, both ends among them */
}

/* Through values at the sample places, by divided differences. */
static Polynomial through(const double *values)
{
    double d[SAMPLES];
    Polynomial p = {{0.0}};
    memcpy(d, values, sizeof d);
    for (int j = 1; j < SAMPLES; ++j) {
        for (int i = DEGREE; i >= j; --i) {
            d[i] = (d[i] - d[i - 1]) / (sample_place(i) - sample_place(i - j));
        }
    }
    for (int j = DEGREE; j >= 0; --j) {
        for (int k = DEGREE; k > 0; --k) {
            p.c[k] = p.c[k - 1] - sample_place(j) * p.c[k];
        }
        p.c[0] = d[j] - sample_place(j) * p.c[0];
    }
    return p;
}

/* The first place in [left, right] where the polynomial with Bernstein coefficients b there is not positive; 2: none. */
static double first_below(const double *b, double left, double right)
{
    double one[SAMPLES], other[SAMPLES], work[SAMPLES];
    int positive = 1;
    if (!(b[0] > 0.0)) {
        return left;
    }
    for (int i = 1; i < SAMPLES; ++i) {
        positive &= b[i] > 0.0;
    }
    if (positive) {
        return 2.0;
    }
    const double middle = 0.5 * (left + right);
    if (!(middle > left && middle < right)) {
        return right;
    }
    memcpy(work, b, sizeof work);
    for (int j = 0; j < SAMPLES; ++j) {
        one[j] = work[0];
        other[DEGREE - j] = work[DEGREE - j];
        for (int i = 0; i < DEGREE - j; ++i) {
            work[i] = 0.5 * (work[i] + work[i + 1]);
        }
    }
    const double found = first_below(one, left, middle);
    return found <= 1.0 ? found : first_below(other, middle, right);
}

/* The first place where a polynomial in powers is not positive; 2: none. */
static double first_end(const double *c)
{
    double b[SAMPLES];
    for (int i = 0; i < SAMPLES; ++i) { /* powers to Bernstein: b_i = sum of binom(i, k) / binom(n, k) c_k */
        double ratio = 1.0;
        b[i] = 0.0;
        for (int k = 0; k <= i; ++k) {
            b[i] += ratio * c[k];
            ratio *= (double)(i - k) / (DEGREE - k);
        }
    }
    return first_below(b, 0.0, 1.0);
}
#endif
