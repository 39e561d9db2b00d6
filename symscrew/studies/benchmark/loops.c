/* Loops that call a function many times, so that what is timed is the function and not Python. */
#define _POSIX_C_SOURCE 200809L
#include <stddef.h>
#include <string.h>
#include <time.h>

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* A generated function of up to eight arrays over `count` states, `rounds` times; nanoseconds per state. */
typedef int (*plain)(double *, double *, double *, double *, double *, double *, double *, double *);

double time_single(plain function, size_t rounds, size_t count, const size_t *size, double *const *at)
{
    plain volatile hidden = function; /* so that nothing is hoisted out of the loop */
    const plain call = hidden;
    const double start = seconds();
    for (size_t round = 0; round < rounds; ++round) {
        for (size_t k = 0; k < count; ++k) {
            (void)call(at[0] + k * size[0], at[1] + k * size[1], at[2] + k * size[2], at[3] + k * size[3],
                       at[4] + k * size[4], at[5] + k * size[5], at[6] + k * size[6], at[7] + k * size[7]);
            __asm__ volatile("" : : : "memory");
        }
    }
    return (seconds() - start) * 1e9 / (double)(rounds * count);
}

/* A generated function of many states, called for eight that lie side by side; nanoseconds per eight. */
typedef int (*batch)(size_t, size_t, double *, double *, double *, double *, double *, double *, double *, double *,
                     double *);

double time_block(batch function, size_t rounds, size_t count, const size_t *size, double *const *at)
{
    batch volatile hidden = function;
    const batch call = hidden;
    const double start = seconds();
    for (size_t round = 0; round < rounds; ++round) {
        for (size_t k = 0; k < count; ++k) {
            (void)call(8, 8, at[0] + k * size[0], at[1] + k * size[1], at[2] + k * size[2], at[3] + k * size[3],
                       at[4] + k * size[4], at[5] + k * size[5], at[6] + k * size[6], at[7] + k * size[7], NULL);
            __asm__ volatile("" : : : "memory");
        }
    }
    return (seconds() - start) * 1e9 / (double)(rounds * count);
}

/* MuJoCo: positions, velocities and a third array are copied into its data, then `function(model, data)` runs. */
typedef void (*engine)(void *, void *);

double time_engine(engine function, void *model, void *data, size_t rounds, size_t count, const size_t *size,
                   double *const *given, double *const *inside, double *result)
{
    const double start = seconds();
    for (size_t round = 0; round < rounds; ++round) {
        for (size_t k = 0; k < count; ++k) {
            for (size_t i = 0; i < 3; ++i) {
                memcpy(inside[i], given[i] + k * size[i], size[i] * sizeof(double));
            }
            function(model, data);
            memcpy(result + k * size[3], inside[3], size[3] * sizeof(double));
        }
    }
    return (seconds() - start) * 1e9 / (double)(rounds * count);
}
