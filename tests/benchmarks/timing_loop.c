/* Time per call of a generated function of three inputs and one output, over many states. */
#include <stddef.h>
#include <time.h>

typedef int (*function)(const double *, const double *, const double *, double *);

extern int FUNCTION(const double *, const double *, const double *, double *);

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Nanoseconds per call, `rounds` times over `count` states with `sizes` entries per input and output. */
double time_calls(
    size_t rounds, size_t count, const size_t *sizes, const double *q, const double *v, const double *a,
    double *u)
{
    function volatile hidden = FUNCTION; /* so that nothing is inlined or hoisted */
    const function call = hidden;
    const double start = seconds();
    for (size_t round = 0; round < rounds; ++round) {
        for (size_t k = 0; k < count; ++k) {
            (void)call(q + k * sizes[0], v + k * sizes[1], a + k * sizes[2], u + k * sizes[3]);
            __asm__ volatile("" : : "r"(u) : "memory");
        }
    }
    return (seconds() - start) * 1e9 / (double)(rounds * count);
}
