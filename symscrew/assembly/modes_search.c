/* ---- All zeros: paths from those of a general mechanism of the same structure, LANES of them at once. ---- */

typedef struct {
    Lanes z[WIDTH], rate[WIDTH], old[WIDTH], old_rate[WIDTH];
    double s[LANES], before[LANES], h[LANES], rest[LANES];
    int path[LANES], steps[LANES], since[LANES];
} Batch;

enum { END_NONE = 0, END_THERE, END_LOST, END_BEHIND };

#if N_PAIRS
/* Axes that two bodies share stay as long as one another along a path: with a quaternion p = (a, b, c, 0) of each,
   p k p* |q|^2 and q k q* |p|^2 are, and these quaternions go straight. They stand behind the slots. */
static void axis_of(const Lanes *p, const Lanes *q, Lanes *axis)
{
    const Lanes aa = lanes_mul(p[0], p[0]), rest = lanes_add(lanes_mul(p[1], p[1]), lanes_mul(p[2], p[2]));
    const Lanes size = lanes_add(lanes_mul(q[0], q[0]), lanes_add(lanes_mul(q[1], q[1]), lanes_mul(q[2], q[2])));
    const Lanes made[3] = {lanes_times(2.0, lanes_mul(p[0], p[2])), lanes_times(-2.0, lanes_mul(p[0], p[1])),
        lanes_sub(aa, rest)};
    for (int i = 0; i < 3; ++i) {
        Lanes sum = lanes_of(0.0);
        for (int j = 0; j < 3; ++j) {
            sum = lanes_add(sum, lanes_times(aside[j][i], made[j]));
        }
        axis[i] = lanes_mul(sum, size);
    }
}

/* The quaternions of two axes of one length, with one sign for the root of their square: the larger of both sums. */
static void spinors_of(const double *w, const double *u, double *p, double *q)
{
    double there[3], here[3], size = 0.0;
    for (int i = 0; i < 3; ++i) {
        there[i] = here[i] = 0.0;
        for (int j = 0; j < 3; ++j) {
            there[i] += aside[i][j] * w[j];
            here[i] += aside[i][j] * u[j];
        }
        size += there[i] * there[i];
    }
    size = sqrt(size);
    const double plus = fabs(size + there[2]) < fabs(size + here[2]) ? fabs(size + there[2]) : fabs(size + here[2]);
    const double less = fabs(there[2] - size) < fabs(here[2] - size) ? fabs(there[2] - size) : fabs(here[2] - size);
    const double root = plus < less ? -size : size;
    const double one[3] = {root + there[2], -there[1], there[0]}, two[3] = {root + here[2], -here[1], here[0]};
    const double first = sqrt(one[0] * one[0] + one[1] * one[1] + one[2] * one[2]);
    const double second = sqrt(two[0] * two[0] + two[1] * two[1] + two[2] * two[2]);
    for (int i = 0; i < 3; ++i) {
        p[i] = one[i] / first;
        q[i] = two[i] / second;
    }
}
#endif

/* Where a way leads, and how far it goes round through complex numbers: on another way singular places are others. */
typedef struct {
    double goal[N_NUMBERS][3], bend;
} Path;

/* Numbers in the slots at s: from the general mechanism (0) to this one (1). */
static void slots_at(Wide s, const Path *way, Lanes (*slots)[3])
{
    const Wide detour = way->bend * s * (1.0 - s);
    for (int k = 0; k < N_NUMBERS; ++k) {
        for (int i = 0; i < 3; ++i) {
            const double re = way->goal[k][i] - start_slots[k][i][0], im = start_slots[k][i][1];
            slots[k][i].re = start_slots[k][i][0] + s * re + detour * im;
            slots[k][i].im = im - s * im + detour * re;
        }
    }
#if N_PAIRS
    for (int pair = 0; pair < N_PAIRS; ++pair) {
        axis_of(slots[N_SLOTS + 2 * pair], slots[N_SLOTS + 2 * pair + 1], slots[pair_slots[pair][0]]);
        axis_of(slots[N_SLOTS + 2 * pair + 1], slots[N_SLOTS + 2 * pair], slots[pair_slots[pair][1]]);
    }
#endif
}

/* Solves for two right sides in place, rows exchanged lane by lane; where a pivot is lost the numbers are none. */
static void solved(Lanes (*a)[WIDTH + 2])
{
    for (int j = 0; j < WIDTH; ++j) {
        Wide best = lanes_square(a[j][j]);
        for (int i = j + 1; i < WIDTH; ++i) {
            const Wide size = lanes_square(a[i][j]);
            const Mask larger = ABOVE(size, best);
            best = CHOOSE(larger, size, best);
            for (int k = j; k < WIDTH + 2; ++k) {
                const Lanes one = a[j][k], two = a[i][k];
                a[j][k].re = CHOOSE(larger, two.re, one.re);
                a[j][k].im = CHOOSE(larger, two.im, one.im);
                a[i][k].re = CHOOSE(larger, one.re, two.re);
                a[i][k].im = CHOOSE(larger, one.im, two.im);
            }
        }
        const Wide norm = 1.0 / best;
        const Lanes inverse = {a[j][j].re * norm, -a[j][j].im * norm};
        for (int k = j + 1; k < WIDTH + 2; ++k) {
            a[j][k] = lanes_mul(a[j][k], inverse);
        }
        for (int i = j + 1; i < WIDTH; ++i) {
            const Lanes factor = a[i][j];
            for (int k = j + 1; k < WIDTH + 2; ++k) {
                a[i][k] = lanes_sub(a[i][k], lanes_mul(factor, a[j][k]));
            }
        }
    }
    for (int j = WIDTH - 2; j >= 0; --j) {
        for (int k = j + 1; k < WIDTH; ++k) {
            a[j][WIDTH] = lanes_sub(a[j][WIDTH], lanes_mul(a[j][k], a[k][WIDTH]));
            a[j][WIDTH + 1] = lanes_sub(a[j][WIDTH + 1], lanes_mul(a[j][k], a[k][WIDTH + 1]));
        }
    }
}

/* A step of Newton's method at s and, where asked for, dz/ds. */
static void path_step(const Lanes *z, Wide s, const Path *way, Lanes *step, Lanes *rate)
{
    Lanes slots[N_NUMBERS][3], value[UNKNOWNS], more[UNKNOWNS], less[UNKNOWNS], jacobian[UNKNOWNS][WIDTH];
    Lanes a[WIDTH][WIDTH + 2];
    slots_at(s, way, slots);
    lanes_equations(slots, z, path_mix, value, jacobian);
    if (rate) {
        slots_at(s + DIFFERENCE, way, slots);
        lanes_equations(slots, z, path_mix, more, (Lanes (*)[WIDTH])0);
        slots_at(s - DIFFERENCE, way, slots);
        lanes_equations(slots, z, path_mix, less, (Lanes (*)[WIDTH])0);
    }
    for (int i = 0; i < UNKNOWNS; ++i) {
        for (int j = 0; j < WIDTH; ++j) {
            a[i][j] = jacobian[i][j];
        }
        a[i][WIDTH] = lanes_times(-1.0, value[i]);
        a[i][WIDTH + 1] = rate ? lanes_times(0.5 / DIFFERENCE, lanes_sub(less[i], more[i])) : lanes_of(0.0);
    }
    for (int group = 0; group < N_GROUPS; ++group) { /* the plane in which a group's coordinates stay */
        const int row = UNKNOWNS + group;
        Lanes sum = lanes_of(-1.0);
        for (int j = 0; j < WIDTH; ++j) {
            a[row][j] = lanes_of(0.0);
        }
        for (int j = group_start[group]; j < group_start[group] + group_width[group]; ++j) {
            a[row][j].re = wide(patch[j][0]);
            a[row][j].im = wide(patch[j][1]);
            sum = lanes_add(sum, lanes_mul(a[row][j], z[j]));
        }
        a[row][WIDTH] = lanes_times(-1.0, sum);
        a[row][WIDTH + 1] = lanes_of(0.0);
    }
    solved(a);
    for (int j = 0; j < WIDTH; ++j) {
        step[j] = a[j][WIDTH];
        if (rate) {
            rate[j] = a[j][WIDTH + 1];
        }
    }
}

static Wide path_size(const Lanes *z)
{
    Wide sum = wide(0.0);
    for (int j = 0; j < WIDTH; ++j) {
        sum = sum + lanes_square(z[j]);
    }
    return sum;
}

static void begin_path(Batch *batch, int lane, int path)
{
    batch->path[lane] = path;
    batch->s[lane] = 0.0;
    batch->before[lane] = -1.0;
    batch->h[lane] = path < 0 ? 0.0 : 0.02;
    batch->rest[lane] = 1.0;
    batch->steps[lane] = batch->since[lane] = 0;
    for (int j = 0; j < WIDTH; ++j) {
        const int from = path < 0 ? 0 : path;
        ((double *)&batch->z[j].re)[lane] = start_zeros[from][j][0];
        ((double *)&batch->z[j].im)[lane] = start_zeros[from][j][1];
        ((double *)&batch->rate[j].re)[lane] = ((double *)&batch->rate[j].im)[lane] = 0.0;
        ((double *)&batch->old[j].re)[lane] = ((double *)&batch->old[j].im)[lane] = 0.0;
        ((double *)&batch->old_rate[j].re)[lane] = ((double *)&batch->old_rate[j].im)[lane] = 0.0;
    }
}

/* The next points: cubic through the last two with their rates (a straight step from the first). */
static void predict(const Batch *batch, Wide *at, Lanes *z)
{
    Wide tau, inverse, gap;
    for (int lane = 0; lane < LANES; ++lane) {
        const double d = batch->before[lane] < 0.0 ? 0.0 : batch->s[lane] - batch->before[lane];
        ((double *)&tau)[lane] = batch->h[lane];
        ((double *)&gap)[lane] = d;
        ((double *)&inverse)[lane] = d > 0.0 ? 1.0 / d : 0.0;
        ((double *)at)[lane] = batch->s[lane] + batch->h[lane];
    }
    for (int j = 0; j < WIDTH; ++j) {
        Lanes chord = lanes_sub(batch->z[j], batch->old[j]);
        chord.re = chord.re * inverse;
        chord.im = chord.im * inverse;
        Lanes two = lanes_sub(batch->rate[j], chord), first = lanes_sub(chord, batch->old_rate[j]);
        two.re = two.re * inverse;
        two.im = two.im * inverse;
        first.re = first.re * inverse;
        first.im = first.im * inverse;
        Lanes three = lanes_sub(two, first);
        three.re = three.re * inverse;
        three.im = three.im * inverse;
        z[j].re = batch->z[j].re + tau * (batch->rate[j].re + tau * (two.re + (tau + gap) * three.re));
        z[j].im = batch->z[j].im + tau * (batch->rate[j].im + tau * (two.im + (tau + gap) * three.im));
    }
}

/* Follows the listed paths; ends[path] says how each ended, at zeros[path]. */
static void follow_paths(const int *list, int count, double tolerance, const Path *way, int *ends,
    double (*zeros)[WIDTH][2])
{
    Batch batch;
    int next = 0, going = 0;
    for (int lane = 0; lane < LANES; ++lane) {
        begin_path(&batch, lane, next < count ? list[next] : -1);
        going += next < count;
        ++next;
    }
    Wide at;
    Lanes z[WIDTH], step[WIDTH], rate[WIDTH];
    for (int lane = 0; lane < LANES; ++lane) {
        ((double *)&at)[lane] = 0.0;
    }
    path_step(batch.z, at, way, step, batch.rate);
    while (going > 0) {
        predict(&batch, &at, z);
        path_step(z, at, way, step, (Lanes *)0);
        const Wide first = path_size(step), whole = path_size(z);
        for (int j = 0; j < WIDTH; ++j) {
            z[j] = lanes_add(z[j], step[j]);
        }
        path_step(z, at, way, step, rate);
        const Wide second = path_size(step);
        int fresh = 0;
        for (int j = 0; j < WIDTH; ++j) {
            z[j] = lanes_add(z[j], step[j]);
        }
        for (int lane = 0; lane < LANES; ++lane) {
            const int path = batch.path[lane];
            if (path < 0) {
                continue;
            }
            const double size = ((const double *)&whole)[lane];
            const double one = sqrt(((const double *)&first)[lane] / size);
            const double two = sqrt(((const double *)&second)[lane] / size);
            const int good = one < tolerance && (two < 0.02 * one || two < 1e-10);
            const double h = batch.h[lane];
            ++batch.steps[lane];
            if (good) {
                batch.before[lane] = batch.s[lane];
                batch.s[lane] = ((const double *)&at)[lane];
                for (int j = 0; j < WIDTH; ++j) {
                    ((double *)&batch.old[j].re)[lane] = ((const double *)&batch.z[j].re)[lane];
                    ((double *)&batch.old[j].im)[lane] = ((const double *)&batch.z[j].im)[lane];
                    ((double *)&batch.old_rate[j].re)[lane] = ((const double *)&batch.rate[j].re)[lane];
                    ((double *)&batch.old_rate[j].im)[lane] = ((const double *)&batch.rate[j].im)[lane];
                    ((double *)&batch.z[j].re)[lane] = ((const double *)&z[j].re)[lane];
                    ((double *)&batch.z[j].im)[lane] = ((const double *)&z[j].im)[lane];
                    ((double *)&batch.rate[j].re)[lane] = ((const double *)&rate[j].re)[lane];
                    ((double *)&batch.rate[j].im)[lane] = ((const double *)&rate[j].im)[lane];
                }
            }
            const double ratio = one > 0.0 ? sqrt(sqrt(0.5 * tolerance / one)) : 2.0;
            const double least = good ? 0.5 : 0.1, most = good ? 2.0 : 0.5;
            double wanted = h * (ratio > least ? (ratio < most ? ratio : most) : least);
            wanted = wanted < LONGEST_STEP ? wanted : LONGEST_STEP;
            const double left = 1.0 - batch.s[lane];
            int end = END_NONE;
            const int halved = left > CRAWL || left < 0.5 * batch.rest[lane];
            batch.rest[lane] = halved ? left : batch.rest[lane];
            batch.since[lane] = halved ? 0 : batch.since[lane] + 1;
            if (!(left > 0.0)) {
                end = END_THERE;
            } else if (batch.steps[lane] >= MOST_STEPS || batch.since[lane] >= MOST_CRAWL ||
                       !(wanted > SHORTEST_STEP * left)) {
                end = left > BEHIND ? END_BEHIND : END_LOST;
            }
            batch.h[lane] = wanted < left ? wanted : left;
            if (end != END_NONE) {
                ends[path] = end;
                for (int j = 0; j < WIDTH; ++j) {
                    zeros[path][j][0] = ((const double *)&batch.z[j].re)[lane];
                    zeros[path][j][1] = ((const double *)&batch.z[j].im)[lane];
                }
                begin_path(&batch, lane, next < count ? list[next] : -1);
                fresh += next < count;
                going -= next >= count;
                ++next;
            }
        }
        if (fresh > 0) { /* rates of paths that begin now; those of the others stay */
            for (int lane = 0; lane < LANES; ++lane) {
                ((double *)&at)[lane] = batch.s[lane];
            }
            path_step(batch.z, at, way, step, rate);
            for (int lane = 0; lane < LANES; ++lane) {
                for (int j = 0; j < WIDTH && batch.steps[lane] == 0; ++j) {
                    ((double *)&batch.rate[j].re)[lane] = ((const double *)&rate[j].re)[lane];
                    ((double *)&batch.rate[j].im)[lane] = ((const double *)&rate[j].im)[lane];
                }
            }
        }
    }
}

/* Whether two ends are one point: all groups are multiples of one another. */
static int same_end(double (*a)[2], double (*b)[2])
{
    for (int group = 0; group < N_GROUPS; ++group) {
        double re = 0.0, im = 0.0, one = 0.0, two = 0.0;
        for (int j = group_start[group]; j < group_start[group] + group_width[group]; ++j) {
            re += a[j][0] * b[j][0] + a[j][1] * b[j][1];
            im += a[j][0] * b[j][1] - a[j][1] * b[j][0];
            one += a[j][0] * a[j][0] + a[j][1] * a[j][1];
            two += b[j][0] * b[j][0] + b[j][1] * b[j][1];
        }
        if (re * re + im * im < (1.0 - 1e-11) * one * two) {
            return 0;
        }
    }
    return 1;
}

/* How far a point is from no displacement at all: the least |x^2| of groups of length one. */
static double displaces(double (*z)[2])
{
    double least = 1.0;
    for (int group = 0; group < N_GROUPS; ++group) {
        const int start = group_start[group], kind = group_kind[group];
        const int count = kind == GROUP_FREE || kind == GROUP_BALL ? 4 : kind == GROUP_SLIDE ? 1 : 2;
        double re = 0.0, im = 0.0, size = 0.0;
        for (int j = 0; j < group_width[group]; ++j) {
            const double a = z[start + j][0], b = z[start + j][1];
            size += a * a + b * b;
            re += j < count ? a * a - b * b : 0.0;
            im += j < count ? 2.0 * a * b : 0.0;
        }
        const double found = sqrt(re * re + im * im) / size;
        least = found < least ? found : least;
    }
    return least;
}

/* The same point with coordinates that are as real as can be: the part that is not. */
static double realised(double (*z)[2], double *real)
{
    double worst = 0.0;
    for (int group = 0; group < N_GROUPS; ++group) {
        int best = group_start[group];
        const int end = best + group_width[group];
        double size = 0.0;
        for (int j = group_start[group]; j < end; ++j) {
            const double now = z[j][0] * z[j][0] + z[j][1] * z[j][1];
            best = now > size ? j : best;
            size = now > size ? now : size;
        }
        for (int j = group_start[group]; j < end; ++j) {
            const double off = fabs(z[j][1] * z[best][0] - z[j][0] * z[best][1]) / size;
            real[j] = (z[j][0] * z[best][0] + z[j][1] * z[best][1]) / size;
            worst = off > worst ? off : worst;
        }
    }
    return worst;
}

/* Certifies a zero and puts it to the modes, unless it is there; 1 where there is no certificate. */
static int added(
    const double *drives, const Place *places, Ball (*slots)[3], const double *z, MODE *modes, int *count)
{
    MODE *mode = &modes[*count];
    if (settled(drives, places, slots, z, mode)) {
        return 1;
    }
    for (int i = 0; i < *count; ++i) {
        double far = ONE_OF_EACH ? 0.0 : 1.0; /* limbs may hold one pose of the platform in several ways */
        for (int j = 0; j < 12; ++j) {
            far += fabs(modes[i].pose[j] - mode->pose[j]) / (j < 9 ? 1.0 : SIZE);
        }
        if (far < 1e-9) {
            return 0;
        }
    }
    ++*count;
    return 0;
}

/* Ends of all paths on one way, and how many stay behind; how many are where another one is, of which one jumped. */
static int all_ends(const Path *way, int *ends, double (*zeros)[WIDTH][2], int *behind)
{
    int list[N_PATHS + LANES], size = N_PATHS;
    double tolerance = TOLERANCE;
    for (int k = 0; k < N_PATHS; ++k) {
        list[k] = k;
    }
    for (int attempt = 0; attempt < 3 && size > 0; ++attempt) {
        follow_paths(list, size, tolerance, way, ends, zeros);
        size = 0;
        for (int k = 0; k < N_PATHS; ++k) {
            int twice = 0;
            for (int i = 0; i < N_PATHS && ends[k] == END_THERE; ++i) {
                twice += i != k && ends[i] == END_THERE && same_end(zeros[i], zeros[k]);
            }
            if (twice && displaces(zeros[k]) > 1e-7) {
                list[size++] = k;
            }
        }
        tolerance *= 0.03;
    }
    *behind = 0;
    for (int k = 0; k < N_PATHS; ++k) {
        *behind += ends[k] == END_BEHIND;
    }
    return size;
}

/* Part of a number that is its error, from which it would not be seen which zeros are real: where two are near they
   change by its root, and they are taken to be real to 1e-5. */
#define LOOSE 1e-10

int MODES(const double *drives, MODE *modes, int *count)
{
    Ball balls[N_DRIVES], slots[N_SLOTS][3];
    Place places[N_BODIES];
    Path way;
    double zeros[N_PATHS][WIDTH][2], closed[N_PATHS][WIDTH], real[WIDTH], sum = 0.0;
    int ends[N_PATHS], lost = 0, loose = 0;
    *count = 0;
    for (int k = 0; k < N_DRIVES; ++k) {
        sum += 0.0 * drives[k];
    }
    if (!isfinite(sum)) {
        return 2;
    }
    exactly(drives, balls);
    slots_of(balls, places, slots);
    for (int k = 0; k < N_SLOTS; ++k) {
        for (int i = 0; i < 3; ++i) {
            way.goal[k][i] = slots[k][i].m;
            loose |= !(slots[k][i].r < LOOSE * (1.0 + fabs(slots[k][i].m))); /* of many turns */
        }
    }
#if N_PAIRS
    for (int pair = 0; pair < N_PAIRS; ++pair) {
        spinors_of(way.goal[pair_slots[pair][0]], way.goal[pair_slots[pair][1]], way.goal[N_SLOTS + 2 * pair],
            way.goal[N_SLOTS + 2 * pair + 1]);
    }
#endif
    const int known = closed_zeros(way.goal, closed);
    for (int k = 0; k < known; ++k) {
        const int before = *count;
        lost += added(drives, places, slots, closed[k], modes, count) || *count == before; /* two came to one */
    }
    if (known >= 0) {
        return lost > 0 || loose ? MODES_INCOMPLETE : 0;
    }
    static const double bends[] = {0.0, 0.4, -0.4};
    for (int k = 0, behind = 1; k < 3 && behind > 0; ++k) {
        way.bend = bends[k];
        lost = all_ends(&way, ends, zeros, &behind);
    }
    for (int k = 0; k < N_PATHS; ++k) {
        if (ends[k] != END_THERE) {
            /* one that was left far from infinity comes to a singular end; one behind does not show where it ends */
            lost += ends[k] == END_BEHIND || displaces(zeros[k]) > 1e-4;
            continue;
        }
        if (displaces(zeros[k]) < 1e-11 || realised(zeros[k], real) > 1e-7) {
            continue;
        }
        lost += added(drives, places, slots, real, modes, count);
    }
    return lost > 0 || loose ? MODES_INCOMPLETE : 0;
}
