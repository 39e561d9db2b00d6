/*
 * four_bar: functions of many states.
 * Generated with four_bar.h, which says of what; do not edit.
 */
#include "four_bar_support.h"

#include <string.h>

/* Batch functions take 8 states at once; FOUR_BAR_STATE_BY_STATE or FOUR_BAR_SCALAR: one by one. */
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__)) && !defined(FOUR_BAR_SCALAR) && \
    !defined(FOUR_BAR_STATE_BY_STATE)
#if defined(__AVX512F__)
#define FOUR_BAR_WIDE 8
#elif defined(__AVX__)
#define FOUR_BAR_WIDE 4
#else
#define FOUR_BAR_WIDE 2
#endif
typedef double four_bar_wide __attribute__((vector_size(FOUR_BAR_WIDE * 8)));
typedef long long four_bar_wide_mask __attribute__((vector_size(FOUR_BAR_WIDE * 8)));
typedef double four_bar_wide_there
    __attribute__((vector_size(FOUR_BAR_WIDE * 8), aligned(8), may_alias));
#define FOUR_BAR_ZERO ((four_bar_wide){0.0})
static inline four_bar_wide four_bar_wide_sqrt(four_bar_wide x)
{
    four_bar_wide root = x;
    for (int k = 0; k < FOUR_BAR_WIDE; ++k) {
        root[k] = sqrt(x[k]);
    }
    return root;
}
static inline four_bar_wide four_bar_wide_select(four_bar_wide c, four_bar_wide a, four_bar_wide b)
{
    const four_bar_wide_mask other = (four_bar_wide_mask)(c == FOUR_BAR_ZERO);
    return (four_bar_wide)(((four_bar_wide_mask)a & ~other) | ((four_bar_wide_mask)b & other));
}
#endif
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__)) && !defined(FOUR_BAR_SCALAR) && \
    !defined(FOUR_BAR_STATE_BY_STATE)
#define FOUR_BAR_ROOM 312
#define FOUR_BAR_BLOCK(block) block
#else
#define FOUR_BAR_ROOM 39
#define FOUR_BAR_BLOCK(block) NULL
#endif

/* A function of one state for the batches: its arrays, and what calls it for one state, and for eight side by side. */
typedef struct {
    size_t inputs, outputs;
    size_t size[6]; /* entries of every array */
    int (*called)(const double *const *in, double *const *out);
    void (*block)(size_t stride, const double *const *in, double *const *out, double *total);
} four_bar_batched;

/* Asks for the entries of the next states: they lie too far apart for the processor to foresee them. Of
   arrays that a cache holds it would only take time. */
FOUR_BAR_UNUSED static inline void four_bar_prefetch(size_t size, size_t stride, const double *array)
{
#if defined(__GNUC__)
    for (size_t k = 0; k < size; ++k) {
        __builtin_prefetch(array + k * stride);
    }
#else
    (void)size;
    (void)stride;
    (void)array;
#endif
}

/* `some` states from `first` on as a block; a stride of 0 means one state after the other. The last one
   fills the lanes that are left. */
FOUR_BAR_UNUSED static inline void four_bar_gather(
    size_t size, size_t first, size_t some, size_t stride, const double *restrict array,
    double *restrict block)
{
    if (stride == 0) {
        for (size_t lane = 0; lane < 8; ++lane) {
            const double *state = array + (first + (lane < some ? lane : some - 1)) * size;
            for (size_t k = 0; k < size; ++k) {
                block[k * 8 + lane] = state[k];
            }
        }
        return;
    }
    for (size_t k = 0; k < size; ++k) {
        const double *entry = array + k * stride + first;
        for (size_t lane = 0; lane < 8; ++lane) {
            block[k * 8 + lane] = entry[lane < some ? lane : some - 1];
        }
    }
}

FOUR_BAR_UNUSED static inline void four_bar_scatter(
    size_t size, size_t first, size_t some, size_t stride, const double *restrict block,
    double *restrict array)
{
    if (stride == 0) {
        for (size_t lane = 0; lane < some; ++lane) {
            double *state = array + (first + lane) * size;
            for (size_t k = 0; k < size; ++k) {
                state[k] = block[k * 8 + lane];
            }
        }
        return;
    }
    for (size_t k = 0; k < size; ++k) {
        double *entry = array + k * stride + first;
        for (size_t lane = 0; lane < some; ++lane) {
            entry[lane] = block[k * 8 + lane];
        }
    }
}

/* Zeros in the states of a block. */
FOUR_BAR_UNUSED static inline void four_bar_zero_block(double *array, size_t size, size_t stride)
{
    for (size_t k = 0; k < size; ++k) {
        for (size_t lane = 0; lane < 8; ++lane) {
            array[k * stride + lane] = 0.0;
        }
    }
}

/* State `index`: where it is, or copied to `work` if its entries lie apart. */
FOUR_BAR_UNUSED static inline int four_bar_one(
    const four_bar_batched *function, size_t index, size_t stride,
    const double *const *in, double *const *out, double *work)
{
    const double *read[6] = {NULL};
    double *written[6] = {NULL};
    for (size_t n = 0; n < function->inputs; ++n) {
        const size_t size = function->size[n];
        if (size == 0 || stride == 0) {
            read[n] = size == 0 ? in[n] : in[n] + index * size;
            continue;
        }
        for (size_t k = 0; k < size; ++k) {
            work[k] = in[n][k * stride + index];
        }
        read[n] = work;
        work += size;
    }
    for (size_t n = 0; n < function->outputs; ++n) {
        const size_t size = function->size[function->inputs + n];
        written[n] = stride != 0 ? work : size == 0 ? out[n] : out[n] + index * size;
        work += stride != 0 ? size : 0;
    }
    const int outcome = function->called(read, written);
    for (size_t n = 0; n < function->outputs && stride != 0; ++n) {
        for (size_t k = 0; k < function->size[function->inputs + n]; ++k) {
            out[n][k * stride + index] = written[n][k];
        }
    }
    return outcome;
}

/* Whether all states are good, `some` of them with a status: the sum of their sums is finite if each is. */
FOUR_BAR_UNUSED static inline int four_bar_good(const double *total, size_t some, int *status)
{
    const double first_half = (total[0] + total[1]) + (total[2] + total[3]);
    if (!isfinite(first_half + ((total[4] + total[5]) + (total[6] + total[7])))) {
        return 0;
    }
    for (size_t lane = 0; status != NULL && lane < some; ++lane) {
        status[lane] = 0;
    }
    return 1;
}

/* Up to eight states from `first` on; a stride of 0 means one state after the other; `beyond`: the next ones
   are asked for. */
FOUR_BAR_UNUSED static inline int four_bar_some(
    const four_bar_batched *function, size_t first, size_t some, size_t stride, int beyond,
    const double *const *in, double *const *out, int *status, double *work)
{
    int worst = 0, together = 0;
    double total[8] = {0.0};
    if (some > 2 && function->block != NULL) {
        const double *read[6] = {NULL};
        double *written[6] = {NULL}, *place = work;
        const int there = some == 8 && stride != 0, ahead = beyond && there && first + 2 * 8 <= stride;
        const size_t *size = function->size, *sized = size + function->inputs;
        for (size_t n = 0; n < function->inputs; ++n) {
            if (size[n] == 0) {
                read[n] = in[n];
            } else if (there) {
                read[n] = in[n] + first;
            } else {
                four_bar_gather(size[n], first, some, stride, in[n], place);
                read[n] = place;
                place += size[n] * 8;
            }
            if (ahead && size[n] != 0) {
                four_bar_prefetch(size[n], stride, read[n] + 8);
            }
        }
        for (size_t n = 0; n < function->outputs; ++n) {
            written[n] = !there ? place : sized[n] == 0 ? out[n] : out[n] + first;
            place += there ? 0 : sized[n] * 8;
            if (ahead && sized[n] != 0) {
                four_bar_prefetch(sized[n], stride, written[n] + 8);
            }
        }
        function->block(there ? stride : 8, read, written, total);
        for (size_t n = 0; n < function->outputs && !there; ++n) {
            four_bar_scatter(sized[n], first, some, stride, written[n], out[n]);
        }
        together = 1;
    }
    if (together && four_bar_good(total, some, status == NULL ? NULL : status + first)) {
        return 0;
    }
    for (size_t lane = 0; lane < some; ++lane) {
        int outcome = 0;
        if (!together || !isfinite(total[lane])) {
            outcome = four_bar_one(function, first + lane, stride, in, out, work);
        }
        if (status != NULL) {
            status[first + lane] = outcome;
        }
        worst = outcome > worst ? outcome : worst;
    }
    return worst;
}

/* All states of a function, block by block, each in memory of its own on the stack. */
FOUR_BAR_UNUSED static inline int four_bar_states(
    const four_bar_batched *function, size_t count, size_t stride,
    const double *const *in, double *const *out, int *status)
{
    int worst = 0;
    size_t entries = 0;
    if (count == 8 && stride != 0 && function->block != NULL) { /* one block, where it is */
        double total[8] = {0.0};
        function->block(stride, in, out, total);
        if (four_bar_good(total, count, status)) {
            return 0;
        }
    }
    for (size_t n = 0; n < function->inputs + function->outputs; ++n) {
        entries += function->size[n];
    }
    const size_t blocks = count / 8 + (count % 8 != 0);
    const int beyond = stride * entries > 4194304 / sizeof(double);
#if defined(_OPENMP) && _OPENMP >= 201107
#pragma omp parallel for schedule(static) reduction(max : worst) if (count >= 1024)
#endif
    for (size_t number = 0; number < blocks; ++number) {
        const size_t first = number * 8;
        const size_t some = count - first < 8 ? count - first : 8;
        double work[FOUR_BAR_ROOM];
        const int outcome = four_bar_some(function, first, some, stride, beyond, in, out, status, work);
        worst = outcome > worst ? outcome : worst;
    }
    return worst;
}

/* Arguments that come in brackets, without them. */
#define FOUR_BAR_ALL(...) __VA_ARGS__

/* A block of a function: what comes before its states (zeros, sines of angles), and the call of some of its states. */
#define FOUR_BAR_SIDE_BY_SIDE(function, before, call) \
static void function##_block(size_t stride, const double *const *in, double *const *out, double *total) \
{ \
    before \
    for (size_t lane = 0; lane < 8; lane += FOUR_BAR_WIDE) { \
        function##_wide call; \
    } \
}

#if defined(__GNUC__) && defined(__GLIBC__) && defined(__x86_64__) && defined(__AVX512F__) && !defined(FOUR_BAR_SCALAR)
typedef double four_bar_lanes8 __attribute__((vector_size(64)));
four_bar_lanes8 _ZGVeN8v_sin(four_bar_lanes8);
four_bar_lanes8 _ZGVeN8v_cos(four_bar_lanes8);
FOUR_BAR_UNUSED static inline FOUR_BAR_INLINE void four_bar_sincos_block(size_t sines, size_t cosines, const double
    *angle, double *sine, double *cosine)
{
    for (size_t k = 0; k < sines || k < cosines; k += 8) {
        four_bar_lanes8 all, found;
        memcpy(&all, angle + k, sizeof(all));
        if (k < sines) {
            found = _ZGVeN8v_sin(all);
            memcpy(sine + k, &found, sizeof(found));
        }
        if (k < cosines) {
            found = _ZGVeN8v_cos(all);
            memcpy(cosine + k, &found, sizeof(found));
        }
    }
}
#else
FOUR_BAR_UNUSED static inline FOUR_BAR_INLINE void four_bar_sincos_block(size_t sines, size_t cosines, const double
    *angle, double *sine, double *cosine)
{
    for (size_t k = 0; k < sines || k < cosines; k += 4) {
        four_bar_sincos(k < sines ? 4 : 0, k < cosines ? 4 : 0, angle + k, sine + k, cosine + k);
    }
}
#endif

/* Of angles, which a function gives for one state, so many sines and cosines of eight: once for all who call it. */
#define FOUR_BAR_SINES(angles, SIZE, given, inputs) \
__attribute__((noinline)) static void angles##_of_eight(size_t stride, FOUR_BAR_ALL given, size_t sines, size_t \
    cosines, \
    double *restrict sine, double *restrict cosine) \
{ \
    double angle[SIZE]; \
    for (size_t lane = 0; lane < 8; ++lane) { \
        angles(stride, 8, FOUR_BAR_ALL inputs, angle + lane); \
    } \
    four_bar_sincos_block(sines, cosines, angle, sine, cosine); \
}

/* Both batch functions of a function: its block; how many inputs, outputs, and entries of each; their declared
   arguments; inputs and outputs by name; those of a call for one state. */
#define FOUR_BAR_BATCH(function, block, table, given, read, written, state) \
static int function##_called(const double *const *in, double *const *out) \
{ \
    return function state; \
} \
static const four_bar_batched function##_batched = {FOUR_BAR_ALL table, function##_called, block}; \
int function##_batch(size_t count, FOUR_BAR_ALL given, int *restrict status) \
{ \
    const double *const in[] = {FOUR_BAR_ALL read}; \
    double *const out[] = {FOUR_BAR_ALL written}; \
    return four_bar_states(&function##_batched, count, 0, in, out, status); \
} \
int function##_batch_soa(size_t count, size_t stride, FOUR_BAR_ALL given, int *restrict status) \
{ \
    const double *const in[] = {FOUR_BAR_ALL read}; \
    double *const out[] = {FOUR_BAR_ALL written}; \
    if (stride == 0 && count > 0) { \
        return 2; \
    } \
    return four_bar_states(&function##_batched, count, stride, in, out, status); \
}

#undef BODY
#undef REAL
#undef READ
#undef SINES
#undef WRITE
#undef CONSTANT
#undef SQRT
#undef ABS
#undef LESS
#undef SELECT
#undef FOURS
#undef FOUR
#undef SUM_OF_FOUR
#undef SMALL
#undef OR
#undef FINITE_UNLESS
#undef FINITE
#undef UNCHECKED
#undef NOT_BELOW
#undef NOT_ABOVE
#undef RESULT

#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__)) && !defined(FOUR_BAR_SCALAR) && \
    !defined(FOUR_BAR_STATE_BY_STATE)
#define FOUR_BAR_VECTORS
/* ... and here as many states as a vector holds: entry k of an argument lies at k * stride. */
#define BODY(function) __attribute__((noinline)) static void function##_wide
#define REAL four_bar_wide
#define READ(array, k) (*(const four_bar_wide_there *)&(array)[(k) * stride])
#define SINES(array, k) (*(const four_bar_wide_there *)&(array)[(k) * 8])
#define WRITE(array, k, x) (*(four_bar_wide_there *)&(array)[(k) * stride] = (x))
#define CONSTANT(x) ((x) - FOUR_BAR_ZERO)
#define SQRT(x) four_bar_wide_sqrt(x)
#define ABS(x) four_bar_wide_abs((x) - FOUR_BAR_ZERO)
#define LESS(a, b) four_bar_wide_less((a) - FOUR_BAR_ZERO, (b) - FOUR_BAR_ZERO)
#define SELECT(condition, a, b) four_bar_wide_select((condition) - FOUR_BAR_ZERO, (a) - FOUR_BAR_ZERO, (b) - \
    FOUR_BAR_ZERO)
#define FOURS four_bar_wide
#define FOUR(array, k) \
    ((READ(array, k) + READ(array, (k) + 1)) + (READ(array, (k) + 2) + READ(array, (k) + 3)))
#define SUM_OF_FOUR(x) (x)
#define SMALL(pivot, limit) ((four_bar_wide_mask)((pivot) <= (limit)) & (four_bar_wide_mask)((pivot) >= -(limit)))
#define OR |
/* All bits set are a NaN. */
#define FINITE_UNLESS(small, sum) \
    (void)stride, *(four_bar_wide_there *)total = (four_bar_wide)((four_bar_wide_mask)(sum) | (small))
#define FINITE(sum) (void)stride, *(four_bar_wide_there *)total = (sum)
#define UNCHECKED() (void)stride, *(four_bar_wide_there *)total = FOUR_BAR_ZERO
#define NOT_BELOW(x, low, status) checked0 = (four_bar_wide)((four_bar_wide_mask)checked0 | \
    ~(four_bar_wide_mask)((x) >= (low)))
#define NOT_ABOVE(x, high, status) checked0 = (four_bar_wide)((four_bar_wide_mask)checked0 | \
    ~(four_bar_wide_mask)((x) <= (high)))
#define RESULT(checked, array, k, x) \
    { const REAL result_ = (x); WRITE(array, k, result_); checked = checked + result_; }
#include "four_bar_kinematics.c"
#include "four_bar_loops.c"
#include "four_bar_momentum.c"
#include "four_bar_inverse_dynamics.c"
#include "four_bar_reactions.c"
#include "four_bar_forward_dynamics.c"
#include "four_bar_margins.c"
#undef BODY
#undef REAL
#undef READ
#undef SINES
#undef WRITE
#undef CONSTANT
#undef SQRT
#undef ABS
#undef LESS
#undef SELECT
#undef FOURS
#undef FOUR
#undef SUM_OF_FOUR
#undef SMALL
#undef OR
#undef FINITE_UNLESS
#undef FINITE
#undef UNCHECKED
#undef NOT_BELOW
#undef NOT_ABOVE
#undef RESULT

FOUR_BAR_SINES(four_bar_angles0, 24, (const double *restrict q), (q + lane))
FOUR_BAR_SINES(four_bar_angles2, 8, (const double *restrict q), (q + lane))
FOUR_BAR_SINES(four_bar_angles4, 16, (const double *restrict q), (q + lane))
FOUR_BAR_SINES(four_bar_angles7, 8, (const double *restrict q), (q + lane))
FOUR_BAR_SINES(four_bar_angles10, 8, (const double *restrict pose), (pose + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_body_poses,
    const double *restrict q = in[0]; double *restrict poses = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, poses + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_body_twists,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict twists = out[0];
    double sine[8]; double cosine[8];
    four_bar_angles2_of_eight(stride, q, 8, 8, sine, cosine);,
    (stride, q + lane, v + lane, twists + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_body_twist_rates,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict a = in[2];
        double *restrict twist_rates = out[0];
    double sine[8]; double cosine[8];
    four_bar_angles2_of_eight(stride, q, 8, 8, sine, cosine);,
    (stride, q + lane, v + lane, a + lane, twist_rates + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_forward_kinematics,
    const double *restrict q = in[0]; double *restrict positions = out[0];
    double sine[16]; double cosine[16];
    four_bar_angles4_of_eight(stride, q, 16, 16, sine, cosine);,
    (stride, q + lane, positions + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_point_motion,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict a = in[2];
        double *restrict positions = out[0]; double *restrict velocities = out[1]; double *restrict
        accelerations = out[2];
    double sine[16]; double cosine[16];
    four_bar_angles4_of_eight(stride, q, 16, 16, sine, cosine);,
    (stride, q + lane, v + lane, a + lane, positions + lane, velocities + lane, accelerations + lane, sine +
        lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_joint_screws,
    const double *restrict q = in[0]; double *restrict screws = out[0];
    double sine[16]; double cosine[16];
    four_bar_angles4_of_eight(stride, q, 16, 16, sine, cosine);,
    (stride, q + lane, screws + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_joint_points,
    const double *restrict q = in[0]; double *restrict points = out[0];
    double sine[16]; double cosine[16];
    four_bar_angles4_of_eight(stride, q, 16, 16, sine, cosine);,
    (stride, q + lane, points + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_platform_jacobian,
    const double *restrict q = in[0]; double *restrict jacobian = out[0];
    four_bar_zero_block(jacobian, 13, stride);,
    (stride, q + lane, jacobian + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_joint_displacements,
    const double *restrict q = in[0]; double *restrict displacements = out[0];,
    (stride, q + lane, displacements + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_joint_rates,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict rates = out[0];,
    (stride, q + lane, v + lane, rates + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_drive_rates,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict rates = out[0];,
    (stride, q + lane, v + lane, rates + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_closure,
    const double *restrict q = in[0]; double *restrict residual_ = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, residual_ + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_closure_jacobian,
    const double *restrict q = in[0]; double *restrict jacobian = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, jacobian + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_closure_bias,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict bias = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, v + lane, bias + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_velocity,
    const double *restrict q = in[0]; const double *restrict y_dot = in[1]; double *restrict v = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, y_dot + lane, v + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_null_space,
    const double *restrict q = in[0]; double *restrict null_space = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, null_space + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_acceleration,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict y_ddot = in[2];
        double *restrict a = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, v + lane, y_ddot + lane, a + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_momentum_screws,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict momenta = out[0];
        double *restrict total_ = out[1];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, v + lane, momenta + lane, total_ + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_momentum_rates,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict a = in[2];
        double *restrict momentum_rates = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, v + lane, a + lane, momentum_rates + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_energy,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict energy = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 16, 24, sine, cosine);,
    (stride, q + lane, v + lane, energy + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_mass_matrix,
    const double *restrict q = in[0]; double *restrict mass_matrix = out[0];
    double sine[8]; double cosine[8];
    four_bar_angles7_of_eight(stride, q, 0, 8, sine, cosine);,
    (stride, q + lane, mass_matrix + lane, cosine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_bias,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict bias = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 16, sine, cosine);,
    (stride, q + lane, v + lane, bias + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_inverse_dynamics,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict a = in[2];
        double *restrict u = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, v + lane, a + lane, u + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_inverse_dynamics_independent,
    const double *restrict q = in[0]; const double *restrict y_dot = in[1]; const double *restrict y_ddot =
        in[2]; double *restrict u = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, y_dot + lane, y_ddot + lane, u + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_joint_reactions,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict a = in[2];
        double *restrict u = out[0]; double *restrict reactions = out[1];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, v + lane, a + lane, u + lane, reactions + lane, sine + lane, cosine + lane, total +
        lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_forward_dynamics,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict u = in[2];
        double *restrict a = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, v + lane, u + lane, a + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_forward_dynamics_independent,
    const double *restrict q = in[0]; const double *restrict y_dot = in[1]; const double *restrict u = in[2];
        double *restrict y_ddot = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, y_dot + lane, u + lane, y_ddot + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_forward_dynamics_reactions,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict u = in[2];
        double *restrict a = out[0]; double *restrict reactions = out[1];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, v + lane, u + lane, a + lane, reactions + lane, sine + lane, cosine + lane, total +
        lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_close_position,
    const double *restrict q = in[0]; double *restrict q_next = out[0]; double *restrict residual_ = out[1];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, q_next + lane, residual_ + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_close_velocity,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict v_next = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, v + lane, v_next + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_inverse_velocity,
    const double *restrict pose = in[0]; const double *restrict rate = in[1]; double *restrict v = out[0];
    double sine[8]; double cosine[8];
    four_bar_angles10_of_eight(stride, pose, 8, 8, sine, cosine);,
    (stride, pose + lane, rate + lane, v + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_inverse_dynamics_platform,
    const double *restrict pose = in[0]; const double *restrict rate = in[1]; const double *restrict
        acceleration = in[2]; double *restrict u = out[0];
    double sine[8]; double cosine[8];
    four_bar_angles10_of_eight(stride, pose, 8, 8, sine, cosine);,
    (stride, pose + lane, rate + lane, acceleration + lane, u + lane, sine + lane, cosine + lane, total +
        lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_limb_margins,
    const double *restrict q = in[0]; double *restrict margins = out[0];
    double sine[8]; double cosine[8];
    four_bar_angles7_of_eight(stride, q, 8, 0, sine, cosine);,
    (stride, q + lane, margins + lane, sine + lane, sine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_constraint_margin,
    const double *restrict q = in[0]; double *restrict margins = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, margins + lane, sine + lane, cosine + lane, total + lane))

FOUR_BAR_SIDE_BY_SIDE(four_bar_actuation_margins,
    const double *restrict q = in[0]; double *restrict margins = out[0];
    double sine[24]; double cosine[24];
    four_bar_angles0_of_eight(stride, q, 24, 24, sine, cosine);,
    (stride, q + lane, margins + lane, sine + lane, cosine + lane, total + lane))
#endif

FOUR_BAR_BATCH(four_bar_body_poses, FOUR_BAR_BLOCK(four_bar_body_poses_block), (1, 1, {3, 36}),
    (const double *restrict q, double *restrict poses), (q), (poses), (in[0], out[0]))

FOUR_BAR_BATCH(four_bar_body_twists, FOUR_BAR_BLOCK(four_bar_body_twists_block), (2, 1, {3, 3, 18}),
    (const double *restrict q, const double *restrict v, double *restrict twists), (q, v), (twists),
    (in[0], in[1], out[0]))

FOUR_BAR_BATCH(four_bar_body_twist_rates, FOUR_BAR_BLOCK(four_bar_body_twist_rates_block),
    (3, 1, {3, 3, 3, 18}),
    (const double *restrict q, const double *restrict v, const double *restrict a, double *restrict
    twist_rates),
    (q, v, a), (twist_rates), (in[0], in[1], in[2], out[0]))

FOUR_BAR_BATCH(four_bar_forward_kinematics, FOUR_BAR_BLOCK(four_bar_forward_kinematics_block), (1, 1, {3, 3}),
    (const double *restrict q, double *restrict positions), (q), (positions), (in[0], out[0]))

FOUR_BAR_BATCH(four_bar_point_motion, FOUR_BAR_BLOCK(four_bar_point_motion_block), (3, 3, {3, 3, 3, 3, 3, 3}),
    (const double *restrict q, const double *restrict v, const double *restrict a, double *restrict positions,
    double *restrict velocities, double *restrict accelerations),
    (q, v, a), (positions, velocities, accelerations), (in[0], in[1], in[2], out[0], out[1], out[2]))

FOUR_BAR_BATCH(four_bar_joint_screws, FOUR_BAR_BLOCK(four_bar_joint_screws_block), (1, 1, {3, 24}),
    (const double *restrict q, double *restrict screws), (q), (screws), (in[0], out[0]))

FOUR_BAR_BATCH(four_bar_joint_points, FOUR_BAR_BLOCK(four_bar_joint_points_block), (1, 1, {3, 12}),
    (const double *restrict q, double *restrict points), (q), (points), (in[0], out[0]))

FOUR_BAR_BATCH(four_bar_platform_jacobian, FOUR_BAR_BLOCK(four_bar_platform_jacobian_block), (1, 1, {3, 18}),
    (const double *restrict q, double *restrict jacobian), (q), (jacobian), (in[0], out[0]))

FOUR_BAR_BATCH(four_bar_joint_displacements, FOUR_BAR_BLOCK(four_bar_joint_displacements_block),
    (1, 1, {3, 4}), (const double *restrict q, double *restrict displacements), (q), (displacements),
    (in[0], out[0]))

FOUR_BAR_BATCH(four_bar_joint_rates, FOUR_BAR_BLOCK(four_bar_joint_rates_block), (2, 1, {3, 3, 4}),
    (const double *restrict q, const double *restrict v, double *restrict rates), (q, v), (rates),
    (in[0], in[1], out[0]))

FOUR_BAR_BATCH(four_bar_drive_rates, FOUR_BAR_BLOCK(four_bar_drive_rates_block), (2, 1, {3, 3, 1}),
    (const double *restrict q, const double *restrict v, double *restrict rates), (q, v), (rates),
    (in[0], in[1], out[0]))

FOUR_BAR_BATCH(four_bar_closure, FOUR_BAR_BLOCK(four_bar_closure_block), (1, 1, {3, 5}),
    (const double *restrict q, double *restrict residual_), (q), (residual_), (in[0], out[0]))

FOUR_BAR_BATCH(four_bar_closure_jacobian, FOUR_BAR_BLOCK(four_bar_closure_jacobian_block), (1, 1, {3, 15}),
    (const double *restrict q, double *restrict jacobian), (q), (jacobian), (in[0], out[0]))

FOUR_BAR_BATCH(four_bar_closure_bias, FOUR_BAR_BLOCK(four_bar_closure_bias_block), (2, 1, {3, 3, 5}),
    (const double *restrict q, const double *restrict v, double *restrict bias), (q, v), (bias),
    (in[0], in[1], out[0]))

FOUR_BAR_BATCH(four_bar_velocity, FOUR_BAR_BLOCK(four_bar_velocity_block), (2, 1, {3, 1, 3}),
    (const double *restrict q, const double *restrict y_dot, double *restrict v), (q, y_dot), (v),
    (in[0], in[1], out[0]))

FOUR_BAR_BATCH(four_bar_null_space, FOUR_BAR_BLOCK(four_bar_null_space_block), (1, 1, {3, 3}),
    (const double *restrict q, double *restrict null_space), (q), (null_space), (in[0], out[0]))

FOUR_BAR_BATCH(four_bar_acceleration, FOUR_BAR_BLOCK(four_bar_acceleration_block), (3, 1, {3, 3, 1, 3}),
    (const double *restrict q, const double *restrict v, const double *restrict y_ddot, double *restrict a),
    (q, v, y_ddot), (a), (in[0], in[1], in[2], out[0]))

FOUR_BAR_BATCH(four_bar_momentum_screws, FOUR_BAR_BLOCK(four_bar_momentum_screws_block),
    (2, 2, {3, 3, 18, 6}),
    (const double *restrict q, const double *restrict v, double *restrict momenta, double *restrict total_),
    (q, v), (momenta, total_), (in[0], in[1], out[0], out[1]))

FOUR_BAR_BATCH(four_bar_momentum_rates, FOUR_BAR_BLOCK(four_bar_momentum_rates_block), (3, 1, {3, 3, 3, 18}),
    (const double *restrict q, const double *restrict v, const double *restrict a, double *restrict
    momentum_rates),
    (q, v, a), (momentum_rates), (in[0], in[1], in[2], out[0]))

FOUR_BAR_BATCH(four_bar_energy, FOUR_BAR_BLOCK(four_bar_energy_block), (2, 1, {3, 3, 2}),
    (const double *restrict q, const double *restrict v, double *restrict energy), (q, v), (energy),
    (in[0], in[1], out[0]))

FOUR_BAR_BATCH(four_bar_mass_matrix, FOUR_BAR_BLOCK(four_bar_mass_matrix_block), (1, 1, {3, 9}),
    (const double *restrict q, double *restrict mass_matrix), (q), (mass_matrix), (in[0], out[0]))

FOUR_BAR_BATCH(four_bar_bias, FOUR_BAR_BLOCK(four_bar_bias_block), (2, 1, {3, 3, 3}),
    (const double *restrict q, const double *restrict v, double *restrict bias), (q, v), (bias),
    (in[0], in[1], out[0]))

FOUR_BAR_BATCH(four_bar_inverse_dynamics, FOUR_BAR_BLOCK(four_bar_inverse_dynamics_block),
    (3, 1, {3, 3, 3, 1}),
    (const double *restrict q, const double *restrict v, const double *restrict a, double *restrict u),
    (q, v, a), (u), (in[0], in[1], in[2], out[0]))

FOUR_BAR_BATCH(four_bar_inverse_dynamics_independent,
    FOUR_BAR_BLOCK(four_bar_inverse_dynamics_independent_block), (3, 1, {3, 1, 1, 1}),
    (const double *restrict q, const double *restrict y_dot, const double *restrict y_ddot, double *restrict
    u),
    (q, y_dot, y_ddot), (u), (in[0], in[1], in[2], out[0]))

FOUR_BAR_BATCH(four_bar_joint_reactions, FOUR_BAR_BLOCK(four_bar_joint_reactions_block),
    (3, 2, {3, 3, 3, 1, 24}),
    (const double *restrict q, const double *restrict v, const double *restrict a, double *restrict u, double
    *restrict reactions),
    (q, v, a), (u, reactions), (in[0], in[1], in[2], out[0], out[1]))

FOUR_BAR_BATCH(four_bar_forward_dynamics, FOUR_BAR_BLOCK(four_bar_forward_dynamics_block),
    (3, 1, {3, 3, 1, 3}),
    (const double *restrict q, const double *restrict v, const double *restrict u, double *restrict a),
    (q, v, u), (a), (in[0], in[1], in[2], out[0]))

FOUR_BAR_BATCH(four_bar_forward_dynamics_independent,
    FOUR_BAR_BLOCK(four_bar_forward_dynamics_independent_block), (3, 1, {3, 1, 1, 1}),
    (const double *restrict q, const double *restrict y_dot, const double *restrict u, double *restrict
    y_ddot),
    (q, y_dot, u), (y_ddot), (in[0], in[1], in[2], out[0]))

FOUR_BAR_BATCH(four_bar_forward_dynamics_reactions, FOUR_BAR_BLOCK(four_bar_forward_dynamics_reactions_block),
    (3, 2, {3, 3, 1, 3, 24}),
    (const double *restrict q, const double *restrict v, const double *restrict u, double *restrict a, double
    *restrict reactions),
    (q, v, u), (a, reactions), (in[0], in[1], in[2], out[0], out[1]))

FOUR_BAR_BATCH(four_bar_close_position, FOUR_BAR_BLOCK(four_bar_close_position_block), (1, 2, {3, 3, 1}),
    (const double *restrict q, double *restrict q_next, double *restrict residual_), (q), (q_next, residual_),
    (in[0], out[0], out[1]))

FOUR_BAR_BATCH(four_bar_close_velocity, FOUR_BAR_BLOCK(four_bar_close_velocity_block), (2, 1, {3, 3, 3}),
    (const double *restrict q, const double *restrict v, double *restrict v_next), (q, v), (v_next),
    (in[0], in[1], out[0]))

FOUR_BAR_BATCH(four_bar_inverse_kinematics, NULL, (1, 1, {1, 3}),
    (const double *restrict pose, double *restrict q), (pose), (q), (in[0], out[0]))

FOUR_BAR_BATCH(four_bar_drive_positions, NULL, (1, 1, {1, 1}),
    (const double *restrict pose, double *restrict positions), (pose), (positions), (in[0], out[0]))

FOUR_BAR_BATCH(four_bar_inverse_velocity, FOUR_BAR_BLOCK(four_bar_inverse_velocity_block), (2, 1, {1, 1, 3}),
    (const double *restrict pose, const double *restrict rate, double *restrict v), (pose, rate), (v),
    (in[0], in[1], out[0]))

FOUR_BAR_BATCH(four_bar_inverse_dynamics_platform, FOUR_BAR_BLOCK(four_bar_inverse_dynamics_platform_block),
    (3, 1, {1, 1, 1, 1}),
    (const double *restrict pose, const double *restrict rate, const double *restrict acceleration, double
    *restrict u),
    (pose, rate, acceleration), (u), (in[0], in[1], in[2], out[0]))

FOUR_BAR_BATCH(four_bar_assemble, NULL, (2, 1, {1, 3, 3}),
    (const double *restrict y, const double *restrict guess, double *restrict q), (y, guess), (q),
    (in[0], in[1], out[0]))

FOUR_BAR_BATCH(four_bar_limb_margins, FOUR_BAR_BLOCK(four_bar_limb_margins_block), (1, 1, {3, 1}),
    (const double *restrict q, double *restrict margins), (q), (margins), (in[0], out[0]))

FOUR_BAR_BATCH(four_bar_constraint_margin, FOUR_BAR_BLOCK(four_bar_constraint_margin_block), (1, 1, {3, 1}),
    (const double *restrict q, double *restrict margins), (q), (margins), (in[0], out[0]))

FOUR_BAR_BATCH(four_bar_actuation_margins, FOUR_BAR_BLOCK(four_bar_actuation_margins_block), (1, 1, {3, 1}),
    (const double *restrict q, double *restrict margins), (q), (margins), (in[0], out[0]))
