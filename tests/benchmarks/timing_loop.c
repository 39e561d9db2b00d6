/* Time per call of a generated function of three inputs and OUTPUTS (1, 2 or 3) outputs, over many states. */
#include <stddef.h>
#include <time.h>

#ifndef OUTPUTS
#define OUTPUTS 1
#endif

#if OUTPUTS == 1
#define RESULTS double *
#define PLACES u + k * sizes[3]
#elif OUTPUTS == 2
#define RESULTS double *, double *
#define PLACES u + k * (sizes[3] + sizes[4]), u + k * (sizes[3] + sizes[4]) + sizes[3]
#else
#define RESULTS double *, double *, double *
#define ROW (u + k * (sizes[3] + sizes[4] + sizes[5]))
#define PLACES ROW, ROW + sizes[3], ROW + sizes[3] + sizes[4]
#endif

typedef int (*function)(const double *, const double *, const double *, RESULTS);

extern int FUNCTION(const double *, const double *, const double *, RESULTS);

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Nanoseconds per call, `rounds` times over `count` states with `sizes` entries per input and output; u holds
   all outputs of a state one after the other. */
double time_calls(
    size_t rounds, size_t count, const size_t *sizes, const double *q, const double *v, const double *a,
    double *u)
{
    function volatile hidden = FUNCTION; /* so that nothing is inlined or hoisted */
    const function call = hidden;
    const double start = seconds();
    for (size_t round = 0; round < rounds; ++round) {
        for (size_t k = 0; k < count; ++k) {
            (void)call(q + k * sizes[0], v + k * sizes[1], a + k * sizes[2], PLACES);
            __asm__ volatile("" : : "r"(u) : "memory");
        }
    }
    return (seconds() - start) * 1e9 / (double)(rounds * count);
}
