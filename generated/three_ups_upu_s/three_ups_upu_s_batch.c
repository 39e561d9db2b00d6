/*
 * three_ups_upu_s: functions of many states.
 * Generated with three_ups_upu_s.h, which says of what; do not edit.
 */
#include "three_ups_upu_s_support.h"

#include <string.h>

/* Batch functions take 8 states at once; THREE_UPS_UPU_S_STATE_BY_STATE or THREE_UPS_UPU_S_SCALAR: one by one. */
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__)) && !defined(THREE_UPS_UPU_S_SCALAR) && \
    !defined(THREE_UPS_UPU_S_STATE_BY_STATE)
#if defined(__AVX512F__)
#define THREE_UPS_UPU_S_WIDE 8
#elif defined(__AVX__)
#define THREE_UPS_UPU_S_WIDE 4
#else
#define THREE_UPS_UPU_S_WIDE 2
#endif
typedef double three_ups_upu_s_wide __attribute__((vector_size(THREE_UPS_UPU_S_WIDE * 8)));
typedef long long three_ups_upu_s_wide_mask __attribute__((vector_size(THREE_UPS_UPU_S_WIDE * 8)));
typedef double three_ups_upu_s_wide_there
    __attribute__((vector_size(THREE_UPS_UPU_S_WIDE * 8), aligned(8), may_alias));
#define THREE_UPS_UPU_S_ZERO ((three_ups_upu_s_wide){0.0})
static inline three_ups_upu_s_wide three_ups_upu_s_wide_sqrt(three_ups_upu_s_wide x)
{
    three_ups_upu_s_wide root = x;
    for (int k = 0; k < THREE_UPS_UPU_S_WIDE; ++k) {
        root[k] = sqrt(x[k]);
    }
    return root;
}
typedef three_ups_upu_s_wide three_ups_upu_s_wide_each4[4];
#endif
#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__)) && !defined(THREE_UPS_UPU_S_SCALAR) && \
    !defined(THREE_UPS_UPU_S_STATE_BY_STATE)
#define THREE_UPS_UPU_S_ROOM 1928
#define THREE_UPS_UPU_S_BLOCK(block) block
#else
#define THREE_UPS_UPU_S_ROOM 241
#define THREE_UPS_UPU_S_BLOCK(block) NULL
#endif

/* A function of one state for the batches: its arrays, and what calls it for one state, and for eight side by side. */
typedef struct {
    size_t inputs, outputs;
    size_t size[6]; /* entries of every array */
    int (*called)(const double *const *in, double *const *out);
    void (*block)(size_t stride, const double *const *in, double *const *out, double *total);
} three_ups_upu_s_batched;

/* Asks for the entries of the next states: they lie too far apart for the processor to foresee them. Of
   arrays that a cache holds it would only take time. */
THREE_UPS_UPU_S_UNUSED static inline void three_ups_upu_s_prefetch(size_t size, size_t stride, const double *array)
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
THREE_UPS_UPU_S_UNUSED static inline void three_ups_upu_s_gather(
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

THREE_UPS_UPU_S_UNUSED static inline void three_ups_upu_s_scatter(
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
THREE_UPS_UPU_S_UNUSED static inline void three_ups_upu_s_zero_block(double *array, size_t size, size_t stride)
{
    for (size_t k = 0; k < size; ++k) {
        for (size_t lane = 0; lane < 8; ++lane) {
            array[k * stride + lane] = 0.0;
        }
    }
}

/* State `index`: where it is, or copied to `work` if its entries lie apart. */
THREE_UPS_UPU_S_UNUSED static inline int three_ups_upu_s_one(
    const three_ups_upu_s_batched *function, size_t index, size_t stride,
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
THREE_UPS_UPU_S_UNUSED static inline int three_ups_upu_s_good(const double *total, size_t some, int *status)
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
THREE_UPS_UPU_S_UNUSED static inline int three_ups_upu_s_some(
    const three_ups_upu_s_batched *function, size_t first, size_t some, size_t stride, int beyond,
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
                three_ups_upu_s_gather(size[n], first, some, stride, in[n], place);
                read[n] = place;
                place += size[n] * 8;
            }
            if (ahead && size[n] != 0) {
                three_ups_upu_s_prefetch(size[n], stride, read[n] + 8);
            }
        }
        for (size_t n = 0; n < function->outputs; ++n) {
            written[n] = !there ? place : sized[n] == 0 ? out[n] : out[n] + first;
            place += there ? 0 : sized[n] * 8;
            if (ahead && sized[n] != 0) {
                three_ups_upu_s_prefetch(sized[n], stride, written[n] + 8);
            }
        }
        function->block(there ? stride : 8, read, written, total);
        for (size_t n = 0; n < function->outputs && !there; ++n) {
            three_ups_upu_s_scatter(sized[n], first, some, stride, written[n], out[n]);
        }
        together = 1;
    }
    if (together && three_ups_upu_s_good(total, some, status == NULL ? NULL : status + first)) {
        return 0;
    }
    for (size_t lane = 0; lane < some; ++lane) {
        int outcome = 0;
        if (!together || !isfinite(total[lane])) {
            outcome = three_ups_upu_s_one(function, first + lane, stride, in, out, work);
        }
        if (status != NULL) {
            status[first + lane] = outcome;
        }
        worst = outcome > worst ? outcome : worst;
    }
    return worst;
}

/* All states of a function, block by block, each in memory of its own on the stack. */
THREE_UPS_UPU_S_UNUSED static inline int three_ups_upu_s_states(
    const three_ups_upu_s_batched *function, size_t count, size_t stride,
    const double *const *in, double *const *out, int *status)
{
    int worst = 0;
    size_t entries = 0;
    if (count == 8 && stride != 0 && function->block != NULL) { /* one block, where it is */
        double total[8] = {0.0};
        function->block(stride, in, out, total);
        if (three_ups_upu_s_good(total, count, status)) {
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
        double work[THREE_UPS_UPU_S_ROOM];
        const int outcome = three_ups_upu_s_some(function, first, some, stride, beyond, in, out, status, work);
        worst = outcome > worst ? outcome : worst;
    }
    return worst;
}

/* Arguments that come in brackets, without them. */
#define THREE_UPS_UPU_S_ALL(...) __VA_ARGS__

/* A block of a function: what comes before its states (zeros, sines of angles), and the call of some of its states. */
#define THREE_UPS_UPU_S_SIDE_BY_SIDE(function, before, call) \
static void function##_block(size_t stride, const double *const *in, double *const *out, double *total) \
{ \
    before \
    for (size_t lane = 0; lane < 8; lane += THREE_UPS_UPU_S_WIDE) { \
        function##_wide call; \
    } \
}

#if defined(__GNUC__) && defined(__GLIBC__) && defined(__x86_64__) && defined(__AVX512F__) && \
    !defined(THREE_UPS_UPU_S_SCALAR)
typedef double three_ups_upu_s_lanes8 __attribute__((vector_size(64)));
three_ups_upu_s_lanes8 _ZGVeN8v_sin(three_ups_upu_s_lanes8);
three_ups_upu_s_lanes8 _ZGVeN8v_cos(three_ups_upu_s_lanes8);
THREE_UPS_UPU_S_UNUSED static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_sincos_block(size_t sines, size_t
    cosines, const double *angle, double *sine, double *cosine)
{
    for (size_t k = 0; k < sines || k < cosines; k += 8) {
        three_ups_upu_s_lanes8 all, found;
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
THREE_UPS_UPU_S_UNUSED static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_sincos_block(size_t sines, size_t
    cosines, const double *angle, double *sine, double *cosine)
{
    for (size_t k = 0; k < sines || k < cosines; k += 4) {
        three_ups_upu_s_sincos(k < sines ? 4 : 0, k < cosines ? 4 : 0, angle + k, sine + k, cosine + k);
    }
}
#endif

/* Of angles, which a function gives for one state, so many sines and cosines of eight: once for all who call it. */
#define THREE_UPS_UPU_S_SINES(angles, SIZE, given, inputs) \
__attribute__((noinline)) static void angles##_of_eight(size_t stride, THREE_UPS_UPU_S_ALL given, size_t sines, \
    size_t cosines, \
    double *restrict sine, double *restrict cosine) \
{ \
    double angle[SIZE]; \
    for (size_t lane = 0; lane < 8; ++lane) { \
        angles(stride, 8, THREE_UPS_UPU_S_ALL inputs, angle + lane); \
    } \
    three_ups_upu_s_sincos_block(sines, cosines, angle, sine, cosine); \
}

/* Both batch functions of a function: its block; how many inputs, outputs, and entries of each; their declared
   arguments; inputs and outputs by name; those of a call for one state. */
#define THREE_UPS_UPU_S_BATCH(function, block, table, given, read, written, state) \
static int function##_called(const double *const *in, double *const *out) \
{ \
    return function state; \
} \
static const three_ups_upu_s_batched function##_batched = {THREE_UPS_UPU_S_ALL table, function##_called, block}; \
int function##_batch(size_t count, THREE_UPS_UPU_S_ALL given, int *restrict status) \
{ \
    const double *const in[] = {THREE_UPS_UPU_S_ALL read}; \
    double *const out[] = {THREE_UPS_UPU_S_ALL written}; \
    return three_ups_upu_s_states(&function##_batched, count, 0, in, out, status); \
} \
int function##_batch_soa(size_t count, size_t stride, THREE_UPS_UPU_S_ALL given, int *restrict status) \
{ \
    const double *const in[] = {THREE_UPS_UPU_S_ALL read}; \
    double *const out[] = {THREE_UPS_UPU_S_ALL written}; \
    if (stride == 0 && count > 0) { \
        return 2; \
    } \
    return three_ups_upu_s_states(&function##_batched, count, stride, in, out, status); \
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
#undef STAGE
#undef LIMBS
#undef FIRST_LIMB
#undef NEXT_LIMB
#undef OWN
#undef GIVEN
#undef ALONE
#undef EACH4
#undef LIMB4
#undef NUMBER4
#undef OF4
#undef IN_EACH4
#undef WRITE4
#undef SQRT4
#undef SMALL4
#undef FINITE_UNLESS4
#undef FINITE4

#if defined(__GNUC__) && (defined(__SSE2__) || defined(__aarch64__)) && !defined(THREE_UPS_UPU_S_SCALAR) && \
    !defined(THREE_UPS_UPU_S_STATE_BY_STATE)
#define THREE_UPS_UPU_S_VECTORS
/* ... and here as many states as a vector holds: entry k of an argument lies at k * stride. */
#define BODY(function) __attribute__((noinline)) static void function##_wide
#define REAL three_ups_upu_s_wide
#define READ(array, k) (*(const three_ups_upu_s_wide_there *)&(array)[(k) * stride])
#define SINES(array, k) (*(const three_ups_upu_s_wide_there *)&(array)[(k) * 8])
#define WRITE(array, k, x) (*(three_ups_upu_s_wide_there *)&(array)[(k) * stride] = (x))
#define CONSTANT(x) ((x) - THREE_UPS_UPU_S_ZERO)
#define SQRT(x) three_ups_upu_s_wide_sqrt(x)
#define ABS(x) three_ups_upu_s_wide_abs((x) - THREE_UPS_UPU_S_ZERO)
#define LESS(a, b) three_ups_upu_s_wide_less((a) - THREE_UPS_UPU_S_ZERO, (b) - THREE_UPS_UPU_S_ZERO)
#define SELECT(condition, a, b) three_ups_upu_s_wide_select((condition) - THREE_UPS_UPU_S_ZERO, (a) - \
    THREE_UPS_UPU_S_ZERO, (b) - THREE_UPS_UPU_S_ZERO)
#define FOURS three_ups_upu_s_wide
#define FOUR(array, k) \
    ((READ(array, k) + READ(array, (k) + 1)) + (READ(array, (k) + 2) + READ(array, (k) + 3)))
#define SUM_OF_FOUR(x) (x)
#define SMALL(pivot, limit) ((three_ups_upu_s_wide_mask)((pivot) <= (limit)) & (three_ups_upu_s_wide_mask)((pivot) \
    >= -(limit)))
#define OR |
/* All bits set are a NaN. */
#define FINITE_UNLESS(small, sum) \
    (void)stride, *(three_ups_upu_s_wide_there *)total = (three_ups_upu_s_wide)((three_ups_upu_s_wide_mask)(sum) | \
        (small))
#define FINITE(sum) (void)stride, *(three_ups_upu_s_wide_there *)total = (sum)
#define UNCHECKED() (void)stride, *(three_ups_upu_s_wide_there *)total = THREE_UPS_UPU_S_ZERO
#define NOT_BELOW(x, low, status) checked0 = (three_ups_upu_s_wide)((three_ups_upu_s_wide_mask)checked0 | \
    ~(three_ups_upu_s_wide_mask)((x) >= (low)))
#define NOT_ABOVE(x, high, status) checked0 = (three_ups_upu_s_wide)((three_ups_upu_s_wide_mask)checked0 | \
    ~(three_ups_upu_s_wide_mask)((x) <= (high)))
#define RESULT(checked, array, k, x) \
    { const REAL result_ = (x); WRITE(array, k, result_); checked = checked + result_; }
/* Stages are what equal limbs do, written once: here of the limb with the number `limb`. Values have the
   names of the theory without the limb's. OWN(x): what a limb hands on; limbs.x[0]: that of the first limb;
   GIVEN(x): what each limb is given; sign1 ...: 1 or -1 by limb, where equal limbs mirror each other. */
#define STAGE(function, n) static inline THREE_UPS_UPU_S_INLINE void three_ups_upu_s_##function##_wide_limb##n
#define LIMBS(function) three_ups_upu_s_##function##_wide_limbs
#define FIRST_LIMB(k, function, n, ...) three_ups_upu_s_##function##_wide_limb##n(k, __VA_ARGS__)
#define NEXT_LIMB(k, function, n, ...) three_ups_upu_s_##function##_wide_limb##n(k, __VA_ARGS__)
#define OWN(x) own->x[limb]
#define GIVEN(x) (x)[limb]
#define ALONE(x) (x)
#define EACH4 three_ups_upu_s_wide_each4
#define LIMB4 REAL
#define NUMBER4 double
#define OF4(a, b, c, d) (limb == 0 ? (a) : limb == 1 ? (b) : limb == 2 ? (c) : (d))
#define IN_EACH4(read, array, first, step) read(array, (first) + (step) * limb)
#define WRITE4(array, a, b, c, d, x) WRITE(array, OF4(a, b, c, d), x)
#define SQRT4(x) SQRT(x)
#define SMALL4(x, a, b, c, d) (SMALL((x)[0], a) OR SMALL((x)[1], b) OR SMALL((x)[2], c) OR SMALL((x)[3], d))
#define FINITE_UNLESS4(small, sum, each) FINITE_UNLESS(small, sum)
#define FINITE4(sum, each) FINITE(sum)
#include "three_ups_upu_s_kinematics.c"
#include "three_ups_upu_s_loops.c"
#include "three_ups_upu_s_momentum.c"
#include "three_ups_upu_s_inverse_dynamics.c"
#include "three_ups_upu_s_reactions.c"
#include "three_ups_upu_s_forward_dynamics.c"
#include "three_ups_upu_s_margins.c"
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
#undef STAGE
#undef LIMBS
#undef FIRST_LIMB
#undef NEXT_LIMB
#undef OWN
#undef GIVEN
#undef ALONE
#undef EACH4
#undef LIMB4
#undef NUMBER4
#undef OF4
#undef IN_EACH4
#undef WRITE4
#undef SQRT4
#undef SMALL4
#undef FINITE_UNLESS4
#undef FINITE4

THREE_UPS_UPU_S_SINES(three_ups_upu_s_angles0, 64, (const double *restrict q), (q + lane))
THREE_UPS_UPU_S_SINES(three_ups_upu_s_angles2, 64, (const double *restrict q), (q + lane))
THREE_UPS_UPU_S_SINES(three_ups_upu_s_angles4, 32, (const double *restrict q), (q + lane))
THREE_UPS_UPU_S_SINES(three_ups_upu_s_angles8, 40, (const double *restrict q), (q + lane))
THREE_UPS_UPU_S_SINES(three_ups_upu_s_angles10, 16, (const double *restrict q), (q + lane))
THREE_UPS_UPU_S_SINES(three_ups_upu_s_angles12, 64, (const double *restrict q), (q + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_body_poses,
    const double *restrict q = in[0]; double *restrict poses = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, poses + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_body_twists,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict twists = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, v + lane, twists + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_body_twist_rates,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict a = in[2];
        double *restrict twist_rates = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, v + lane, a + lane, twist_rates + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_forward_kinematics,
    const double *restrict q = in[0]; double *restrict positions = out[0];,
    (stride, q + lane, positions + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_point_motion,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict a = in[2];
        double *restrict positions = out[0]; double *restrict velocities = out[1]; double *restrict
        accelerations = out[2];
    three_ups_upu_s_zero_block(velocities + 6 * stride, 12, stride);
    three_ups_upu_s_zero_block(accelerations + 6 * stride, 12, stride);,
    (stride, q + lane, v + lane, a + lane, positions + lane, velocities + lane, accelerations + lane, total +
        lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_joint_screws,
    const double *restrict q = in[0]; double *restrict screws = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, screws + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_joint_points,
    const double *restrict q = in[0]; double *restrict points = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, points + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_platform_jacobian,
    const double *restrict q = in[0]; double *restrict jacobian = out[0];
    three_ups_upu_s_zero_block(jacobian, 72, stride);,
    (stride, q + lane, jacobian + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_joint_rates,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict rates = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, v + lane, rates + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_drive_rates,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict rates = out[0];,
    (stride, q + lane, v + lane, rates + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_closure,
    const double *restrict q = in[0]; double *restrict residual_ = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, residual_ + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_closure_jacobian,
    const double *restrict q = in[0]; double *restrict jacobian = out[0];
    three_ups_upu_s_zero_block(jacobian + 4 * stride, 10, stride);
    three_ups_upu_s_zero_block(jacobian + 17 * stride, 9, stride);
    three_ups_upu_s_zero_block(jacobian + 27 * stride, 18, stride);
    three_ups_upu_s_zero_block(jacobian + 46 * stride, 11, stride);
    three_ups_upu_s_zero_block(jacobian + 58 * stride, 11, stride);
    three_ups_upu_s_zero_block(jacobian + 70 * stride, 17, stride);
    three_ups_upu_s_zero_block(jacobian + 88 * stride, 11, stride);
    three_ups_upu_s_zero_block(jacobian + 100 * stride, 11, stride);
    three_ups_upu_s_zero_block(jacobian + 112 * stride, 17, stride);
    three_ups_upu_s_zero_block(jacobian + 130 * stride, 11, stride);
    three_ups_upu_s_zero_block(jacobian + 142 * stride, 11, stride);
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, jacobian + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_closure_bias,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict bias = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, v + lane, bias + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_velocity,
    const double *restrict q = in[0]; const double *restrict y_dot = in[1]; double *restrict v = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, y_dot + lane, v + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_null_space,
    const double *restrict q = in[0]; double *restrict null_space = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, null_space + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_acceleration,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict y_ddot = in[2];
        double *restrict a = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, v + lane, y_ddot + lane, a + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_momentum_screws,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict momenta = out[0];
        double *restrict total_ = out[1];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, v + lane, momenta + lane, total_ + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_momentum_rates,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict a = in[2];
        double *restrict momentum_rates = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, v + lane, a + lane, momentum_rates + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_energy,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict energy = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles2_of_eight(stride, q, 32, 64, sine, cosine);,
    (stride, q + lane, v + lane, energy + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_mass_matrix,
    const double *restrict q = in[0]; double *restrict mass_matrix = out[0];
    three_ups_upu_s_zero_block(mass_matrix + 1 * stride, 15, stride);
    three_ups_upu_s_zero_block(mass_matrix + 17 * stride, 15, stride);
    three_ups_upu_s_zero_block(mass_matrix + 33 * stride, 15, stride);
    three_ups_upu_s_zero_block(mass_matrix + 49 * stride, 15, stride);
    three_ups_upu_s_zero_block(mass_matrix + 65 * stride, 15, stride);
    three_ups_upu_s_zero_block(mass_matrix + 81 * stride, 15, stride);
    three_ups_upu_s_zero_block(mass_matrix + 97 * stride, 15, stride);
    three_ups_upu_s_zero_block(mass_matrix + 113 * stride, 15, stride);
    three_ups_upu_s_zero_block(mass_matrix + 129 * stride, 15, stride);
    three_ups_upu_s_zero_block(mass_matrix + 145 * stride, 15, stride);
    three_ups_upu_s_zero_block(mass_matrix + 161 * stride, 15, stride);
    three_ups_upu_s_zero_block(mass_matrix + 177 * stride, 15, stride);
    three_ups_upu_s_zero_block(mass_matrix + 193 * stride, 15, stride);
    three_ups_upu_s_zero_block(mass_matrix + 209 * stride, 15, stride);
    double sine[32]; double cosine[32];
    three_ups_upu_s_angles4_of_eight(stride, q, 0, 32, sine, cosine);,
    (stride, q + lane, mass_matrix + lane, cosine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_bias,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict bias = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, v + lane, bias + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_inverse_dynamics,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict a = in[2];
        double *restrict u = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, v + lane, a + lane, u + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_inverse_dynamics_independent,
    const double *restrict q = in[0]; const double *restrict y_dot = in[1]; const double *restrict y_ddot =
        in[2]; double *restrict u = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, y_dot + lane, y_ddot + lane, u + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_inverse_dynamics_preload,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict a = in[2];
        const double *restrict weights = in[3]; const double *restrict preload = in[4]; double *restrict u =
        out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, v + lane, a + lane, weights + lane, preload + lane, u + lane, sine + lane, cosine +
        lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_joint_reactions,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict a = in[2];
        double *restrict u = out[0]; double *restrict reactions = out[1];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, v + lane, a + lane, u + lane, reactions + lane, sine + lane, cosine + lane, total +
        lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_forward_dynamics,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict u = in[2];
        double *restrict a = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, v + lane, u + lane, a + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_forward_dynamics_independent,
    const double *restrict q = in[0]; const double *restrict y_dot = in[1]; const double *restrict u = in[2];
        double *restrict y_ddot = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, y_dot + lane, u + lane, y_ddot + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_forward_dynamics_reactions,
    const double *restrict q = in[0]; const double *restrict v = in[1]; const double *restrict u = in[2];
        double *restrict a = out[0]; double *restrict reactions = out[1];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, v + lane, u + lane, a + lane, reactions + lane, sine + lane, cosine + lane, total +
        lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_close_position,
    const double *restrict q = in[0]; double *restrict q_next = out[0]; double *restrict residual_ = out[1];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, q_next + lane, residual_ + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_close_velocity,
    const double *restrict q = in[0]; const double *restrict v = in[1]; double *restrict v_next = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles0_of_eight(stride, q, 64, 64, sine, cosine);,
    (stride, q + lane, v + lane, v_next + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_drive_positions,
    const double *restrict pose = in[0]; double *restrict positions = out[0];,
    (stride, pose + lane, positions + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_inverse_velocity,
    const double *restrict pose = in[0]; const double *restrict rate = in[1]; double *restrict v = out[0];,
    (stride, pose + lane, rate + lane, v + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_inverse_dynamics_platform,
    const double *restrict pose = in[0]; const double *restrict rate = in[1]; const double *restrict
        acceleration = in[2]; double *restrict u = out[0];,
    (stride, pose + lane, rate + lane, acceleration + lane, u + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_limb_margins,
    const double *restrict q = in[0]; double *restrict margins = out[0];
    double sine[40]; double cosine[40];
    three_ups_upu_s_angles8_of_eight(stride, q, 16, 40, sine, cosine);,
    (stride, q + lane, margins + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_constraint_margin,
    const double *restrict q = in[0]; double *restrict margins = out[0];
    double sine[16]; double cosine[16];
    three_ups_upu_s_angles10_of_eight(stride, q, 16, 16, sine, cosine);,
    (stride, q + lane, margins + lane, sine + lane, cosine + lane, total + lane))

THREE_UPS_UPU_S_SIDE_BY_SIDE(three_ups_upu_s_actuation_margins,
    const double *restrict q = in[0]; double *restrict margins = out[0];
    double sine[64]; double cosine[64];
    three_ups_upu_s_angles12_of_eight(stride, q, 40, 64, sine, cosine);,
    (stride, q + lane, margins + lane, sine + lane, cosine + lane, total + lane))
#endif

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_body_poses, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_body_poses_block),
    (1, 1, {16, 108}), (const double *restrict q, double *restrict poses), (q), (poses), (in[0], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_body_twists, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_body_twists_block),
    (2, 1, {16, 15, 54}), (const double *restrict q, const double *restrict v, double *restrict twists),
    (q, v), (twists), (in[0], in[1], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_body_twist_rates,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_body_twist_rates_block), (3, 1, {16, 15, 15, 54}),
    (const double *restrict q, const double *restrict v, const double *restrict a, double *restrict
    twist_rates),
    (q, v, a), (twist_rates), (in[0], in[1], in[2], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_forward_kinematics,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_forward_kinematics_block), (1, 1, {16, 30}),
    (const double *restrict q, double *restrict positions), (q), (positions), (in[0], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_point_motion, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_point_motion_block),
    (3, 3, {16, 15, 15, 30, 30, 30}),
    (const double *restrict q, const double *restrict v, const double *restrict a, double *restrict positions,
    double *restrict velocities, double *restrict accelerations),
    (q, v, a), (positions, velocities, accelerations), (in[0], in[1], in[2], out[0], out[1], out[2]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_joint_screws, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_joint_screws_block),
    (1, 1, {16, 156}), (const double *restrict q, double *restrict screws), (q), (screws), (in[0], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_joint_points, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_joint_points_block),
    (1, 1, {16, 39}), (const double *restrict q, double *restrict points), (q), (points), (in[0], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_platform_jacobian,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_platform_jacobian_block), (1, 1, {16, 90}),
    (const double *restrict q, double *restrict jacobian), (q), (jacobian), (in[0], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_joint_displacements, NULL, (1, 1, {16, 26}),
    (const double *restrict q, double *restrict displacements), (q), (displacements), (in[0], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_joint_rates, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_joint_rates_block),
    (2, 1, {16, 15, 26}), (const double *restrict q, const double *restrict v, double *restrict rates),
    (q, v), (rates), (in[0], in[1], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_drive_rates, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_drive_rates_block),
    (2, 1, {16, 15, 4}), (const double *restrict q, const double *restrict v, double *restrict rates), (q, v),
    (rates), (in[0], in[1], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_closure, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_closure_block),
    (1, 1, {16, 13}), (const double *restrict q, double *restrict residual_), (q), (residual_),
    (in[0], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_closure_jacobian,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_closure_jacobian_block), (1, 1, {16, 195}),
    (const double *restrict q, double *restrict jacobian), (q), (jacobian), (in[0], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_closure_bias, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_closure_bias_block),
    (2, 1, {16, 15, 13}), (const double *restrict q, const double *restrict v, double *restrict bias), (q, v),
    (bias), (in[0], in[1], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_velocity, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_velocity_block),
    (2, 1, {16, 2, 15}), (const double *restrict q, const double *restrict y_dot, double *restrict v),
    (q, y_dot), (v), (in[0], in[1], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_null_space, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_null_space_block),
    (1, 1, {16, 30}), (const double *restrict q, double *restrict null_space), (q), (null_space),
    (in[0], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_acceleration, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_acceleration_block),
    (3, 1, {16, 15, 2, 15}),
    (const double *restrict q, const double *restrict v, const double *restrict y_ddot, double *restrict a),
    (q, v, y_ddot), (a), (in[0], in[1], in[2], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_momentum_screws,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_momentum_screws_block), (2, 2, {16, 15, 54, 6}),
    (const double *restrict q, const double *restrict v, double *restrict momenta, double *restrict total_),
    (q, v), (momenta, total_), (in[0], in[1], out[0], out[1]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_momentum_rates,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_momentum_rates_block), (3, 1, {16, 15, 15, 54}),
    (const double *restrict q, const double *restrict v, const double *restrict a, double *restrict
    momentum_rates),
    (q, v, a), (momentum_rates), (in[0], in[1], in[2], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_energy, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_energy_block),
    (2, 1, {16, 15, 2}), (const double *restrict q, const double *restrict v, double *restrict energy),
    (q, v), (energy), (in[0], in[1], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_mass_matrix, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_mass_matrix_block),
    (1, 1, {16, 225}), (const double *restrict q, double *restrict mass_matrix), (q), (mass_matrix),
    (in[0], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_bias, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_bias_block),
    (2, 1, {16, 15, 15}), (const double *restrict q, const double *restrict v, double *restrict bias), (q, v),
    (bias), (in[0], in[1], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_inverse_dynamics,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_inverse_dynamics_block), (3, 1, {16, 15, 15, 4}),
    (const double *restrict q, const double *restrict v, const double *restrict a, double *restrict u),
    (q, v, a), (u), (in[0], in[1], in[2], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_inverse_dynamics_independent,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_inverse_dynamics_independent_block), (3, 1, {16, 2, 2, 4}),
    (const double *restrict q, const double *restrict y_dot, const double *restrict y_ddot, double *restrict
    u),
    (q, y_dot, y_ddot), (u), (in[0], in[1], in[2], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_inverse_dynamics_preload,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_inverse_dynamics_preload_block), (5, 1, {16, 15, 15, 4, 4, 4}),
    (const double *restrict q, const double *restrict v, const double *restrict a, const double *restrict
    weights, const double *restrict preload, double *restrict u),
    (q, v, a, weights, preload), (u), (in[0], in[1], in[2], in[3], in[4], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_joint_reactions,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_joint_reactions_block), (3, 2, {16, 15, 15, 4, 78}),
    (const double *restrict q, const double *restrict v, const double *restrict a, double *restrict u, double
    *restrict reactions),
    (q, v, a), (u, reactions), (in[0], in[1], in[2], out[0], out[1]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_forward_dynamics,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_forward_dynamics_block), (3, 1, {16, 15, 4, 15}),
    (const double *restrict q, const double *restrict v, const double *restrict u, double *restrict a),
    (q, v, u), (a), (in[0], in[1], in[2], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_forward_dynamics_independent,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_forward_dynamics_independent_block), (3, 1, {16, 2, 4, 2}),
    (const double *restrict q, const double *restrict y_dot, const double *restrict u, double *restrict
    y_ddot),
    (q, y_dot, u), (y_ddot), (in[0], in[1], in[2], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_forward_dynamics_reactions,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_forward_dynamics_reactions_block), (3, 2, {16, 15, 4, 15, 78}),
    (const double *restrict q, const double *restrict v, const double *restrict u, double *restrict a, double
    *restrict reactions),
    (q, v, u), (a, reactions), (in[0], in[1], in[2], out[0], out[1]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_close_position,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_close_position_block), (1, 2, {16, 16, 1}),
    (const double *restrict q, double *restrict q_next, double *restrict residual_), (q), (q_next, residual_),
    (in[0], out[0], out[1]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_close_velocity,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_close_velocity_block), (2, 1, {16, 15, 15}),
    (const double *restrict q, const double *restrict v, double *restrict v_next), (q, v), (v_next),
    (in[0], in[1], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_inverse_kinematics, NULL, (1, 1, {4, 16}),
    (const double *restrict pose, double *restrict q), (pose), (q), (in[0], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_drive_positions,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_drive_positions_block), (1, 1, {4, 4}),
    (const double *restrict pose, double *restrict positions), (pose), (positions), (in[0], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_inverse_velocity,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_inverse_velocity_block), (2, 1, {4, 3, 15}),
    (const double *restrict pose, const double *restrict rate, double *restrict v), (pose, rate), (v),
    (in[0], in[1], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_inverse_dynamics_platform,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_inverse_dynamics_platform_block), (3, 1, {4, 3, 3, 4}),
    (const double *restrict pose, const double *restrict rate, const double *restrict acceleration, double
    *restrict u),
    (pose, rate, acceleration), (u), (in[0], in[1], in[2], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_assemble, NULL, (2, 1, {2, 16, 16}),
    (const double *restrict y, const double *restrict guess, double *restrict q), (y, guess), (q),
    (in[0], in[1], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_limb_margins, THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_limb_margins_block),
    (1, 1, {16, 5}), (const double *restrict q, double *restrict margins), (q), (margins), (in[0], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_constraint_margin,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_constraint_margin_block), (1, 1, {16, 1}),
    (const double *restrict q, double *restrict margins), (q), (margins), (in[0], out[0]))

THREE_UPS_UPU_S_BATCH(three_ups_upu_s_actuation_margins,
    THREE_UPS_UPU_S_BLOCK(three_ups_upu_s_actuation_margins_block), (1, 1, {16, 6}),
    (const double *restrict q, double *restrict margins), (q), (margins), (in[0], out[0]))
