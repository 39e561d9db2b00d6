/* ---- Numbers in the slots of the closure's equations, for drives between bounds. ---- */

/* A constant of the description, which a double holds to half a unit. */
static Ball read(double c)
{
    const Ball x = {c, 0.0, UNIT * fabs(c)};
    return x;
}

/* Cosine and sine by the library, right to two units in the last place of 1, and their tangents. */
static Ball ball_cos(Ball a)
{
    const Ball x = {cos(a.m), -sin(a.m) * a.c, 0.5 * a.c * a.c + a.r + 4.5e-16 * (1.0 + fabs(a.c)) + TINY};
    return x;
}

static Ball ball_sin(Ball a)
{
    const Ball x = {sin(a.m), cos(a.m) * a.c, 0.5 * a.c * a.c + a.r + 4.5e-16 * (1.0 + fabs(a.c)) + TINY};
    return x;
}

typedef struct {
    Ball turn[9], shift[3]; /* by rows */
} Place;

static void moved(const Place *place, const Ball *at, Ball *out)
{
    for (int i = 0; i < 3; ++i) {
        out[i] = place->shift[i];
        for (int j = 0; j < 3; ++j) {
            out[i] = ball_add(out[i], ball_mul(place->turn[3 * i + j], at[j]));
        }
    }
}

/* The place behind a held joint: turned about an axis through a point, or slid along the axis. */
static void behind_joint(const Place *near, int step, Ball value, Place *far)
{
    Ball axis[3], point[3], local[3], turned[3];
    for (int k = 0; k < 3; ++k) {
        axis[k] = read(step_axis[step][k]);
        point[k] = read(step_point[step][k]);
    }
    *far = *near;
    if (step_kind[step] == STEP_SLIDE) {
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                far->shift[i] = ball_add(far->shift[i], ball_mul(near->turn[3 * i + j], ball_mul(axis[j], value)));
            }
        }
        return;
    }
    const Ball c = ball_cos(value), s = ball_sin(value), less = ball_sub(ball_of(1.0), c);
    Ball own[9];
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            own[3 * i + j] = ball_mul(ball_mul(axis[i], axis[j]), less);
        }
        own[4 * i] = ball_add(own[4 * i], c);
    }
    for (int i = 0; i < 3; ++i) { /* + axis x, times the sine */
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const Ball part = ball_mul(axis[i], s);
        own[3 * k + j] = ball_add(own[3 * k + j], part);
        own[3 * j + k] = ball_sub(own[3 * j + k], part);
    }
    for (int i = 0; i < 3; ++i) {
        local[i] = point[i];
        for (int j = 0; j < 3; ++j) {
            local[i] = ball_sub(local[i], ball_mul(own[3 * i + j], point[j]));
        }
    }
    moved(near, local, turned);
    for (int i = 0; i < 3; ++i) {
        far->shift[i] = turned[i];
        for (int j = 0; j < 3; ++j) {
            Ball sum = ball_of(0.0);
            for (int k = 0; k < 3; ++k) {
                sum = ball_add(sum, ball_mul(near->turn[3 * i + k], own[3 * k + j]));
            }
            far->turn[3 * i + j] = sum;
        }
    }
}

/* Displacements of what is held: of the drives, and polynomials of those before where couplings settle more. */
static void displaced(const Ball *drives, Ball *held)
{
    for (int k = 0; k < N_DRIVES; ++k) {
        held[k] = ball_mul(ball_sub(drives[k], read(drive_reference[k])), read(1.0 / drive_unit[k]));
    }
#if N_FOLLOWERS
    for (int k = 0; k < N_FOLLOWERS; ++k) {
        held[N_DRIVES + k] = ball_of(0.0);
        for (int term = follower_first[k]; term < follower_first[k + 1]; ++term) {
            Ball sum = ball_of(0.0);
            for (int j = MOST_POWERS - 1; j >= 0; --j) {
                sum = ball_mul(ball_add(sum, read(term_powers[term][j])), held[term_held[term]]);
            }
            held[N_DRIVES + k] = ball_add(held[N_DRIVES + k], sum);
        }
    }
#endif
}

/* Where bodies are inside what is held together. */
static void places_of(const Ball *drives, Place *places)
{
    Ball held[N_DRIVES + N_FOLLOWERS];
    displaced(drives, held);
    for (int body = 0; body < N_BODIES; ++body) {
        for (int k = 0; k < 9; ++k) {
            places[body].turn[k] = ball_of(k % 4 ? 0.0 : 1.0);
        }
        for (int k = 0; k < 3; ++k) {
            places[body].shift[k] = ball_of(0.0);
        }
    }
    for (int step = 0; step < N_STEPS; ++step) {
        const Place near = places[step_near[step]];
        if (step_kind[step] == STEP_STILL) {
            places[step_far[step]] = near;
            continue;
        }
        const int place = step_held[step];
        const Ball value = place < 0 ? ball_of(0.0) : ball_times(step_sign[step], held[place]);
        behind_joint(&near, step, value, &places[step_far[step]]);
    }
}

static void slots_of(const Ball *drives, Place *places, Ball (*slots)[3])
{
    places_of(drives, places);
#ifdef COUPLINGS
    Ball held[N_DRIVES + N_FOLLOWERS];
    displaced(drives, held);
#endif
    for (int slot = 0; slot < N_SLOTS; ++slot) {
        const Place *place = &places[slot_body[slot]];
        Ball at[3], ends[2][3];
        for (int k = 0; k < 3; ++k) {
            at[k] = read(slot_at[slot][k]);
        }
        if (slot_kind[slot] == SLOT_POINT) {
            moved(place, at, slots[slot]);
        } else if (slot_kind[slot] == SLOT_AXIS) {
            for (int i = 0; i < 3; ++i) {
                slots[slot][i] = ball_of(0.0);
                for (int j = 0; j < 3; ++j) {
                    slots[slot][i] = ball_add(slots[slot][i], ball_mul(place->turn[3 * i + j], at[j]));
                }
            }
        } else if (slot_kind[slot] == SLOT_NUMBER) {
            slots[slot][0] = at[0];
            slots[slot][1] = slots[slot][2] = ball_of(0.0);
#ifdef COUPLINGS
        } else if (slot_kind[slot] == SLOT_TURNED || slot_kind[slot] == SLOT_SLID) {
            const Ball known = held[slot_second[slot]];
            const int turns = slot_kind[slot] == SLOT_TURNED;
            slots[slot][0] = turns ? ball_cos(known) : ball_of(1.0);
            slots[slot][1] = turns ? ball_sin(known) : known;
            slots[slot][2] = ball_of(0.0);
#endif
        } else { /* the square of a rod's length */
            Ball other[3];
            for (int k = 0; k < 3; ++k) {
                other[k] = read(slot_other[slot][k]);
            }
            moved(place, at, ends[0]);
            moved(&places[slot_second[slot]], other, ends[1]);
            Ball sum = ball_of(0.0);
            for (int k = 0; k < 3; ++k) {
                const Ball way = ball_sub(ends[0][k], ends[1][k]);
                sum = ball_add(sum, ball_mul(way, way));
            }
            slots[slot][0] = sum;
            slots[slot][1] = slots[slot][2] = ball_of(0.0);
        }
    }
}

/* ---- Certificates: Krawczyk's test in balls. K(B) = z - Y F(z) + (1 - Y dF(B)) (B - z) inside B: one zero in B. ---- */

typedef struct {
    int fixed[N_GROUPS]; /* the coordinate of each group that is 1 */
    int open[UNKNOWNS];
    double mix[N_LOOPS + 1][3][4]; /* three of four rows of points that meet: not that of the largest part of x */
    double inverse[UNKNOWNS][UNKNOWNS];
} Chart;

/* Groups scaled so that their largest coordinates are 1. */
static void chart_of(double *z, Ball (*slots)[3], Chart *chart)
{
    int count = 0;
    for (int group = 0; group < N_GROUPS; ++group) {
        int best = group_start[group];
        for (int k = best; k < group_start[group] + group_width[group]; ++k) {
            best = fabs(z[k]) > fabs(z[best]) ? k : best;
        }
        const double scale = z[best];
        chart->fixed[group] = best;
        for (int k = group_start[group]; k < group_start[group] + group_width[group]; ++k) {
            z[k] = k == best ? 1.0 : z[k] / scale;
            if (k != best) {
                chart->open[count++] = k;
            }
        }
    }
    for (int loop = 0; loop < N_LOOPS; ++loop) {
        const int first = loop_first[loop], size = loop_first[loop + 1] - first;
        Ball g[8], own[8], next[8], at[WIDTH];
        for (int k = 0; k < WIDTH; ++k) {
            at[k] = ball_of(z[k]);
        }
        for (int k = 0; k < size; ++k) {
            ball_motion(way_group[first + k], way_back[first + k], slots, at, own);
            if (k > 0) {
                ball_product(g, own, next);
            }
            for (int i = 0; i < 8; ++i) {
                g[i] = k > 0 ? next[i] : own[i];
            }
        }
        int drop = 0, row = 0;
        for (int i = 1; i < 4; ++i) {
            drop = fabs(g[i].m) > fabs(g[drop].m) ? i : drop;
        }
        for (int i = 0; i < 4; ++i) {
            for (int r = 0; r < 3; ++r) {
                chart->mix[loop][r][i] = i != drop && r == row ? 1.0 : 0.0;
            }
            row += i != drop;
        }
    }
}

/* y = the inverse of a, destroyed; 1 where it is singular. */
static int inverted(double (*a)[UNKNOWNS], double (*y)[UNKNOWNS])
{
    for (int i = 0; i < UNKNOWNS; ++i) {
        for (int j = 0; j < UNKNOWNS; ++j) {
            y[i][j] = i == j ? 1.0 : 0.0;
        }
    }
    for (int j = 0; j < UNKNOWNS; ++j) {
        int best = j;
        for (int i = j + 1; i < UNKNOWNS; ++i) {
            best = fabs(a[i][j]) > fabs(a[best][j]) ? i : best;
        }
        if (!(fabs(a[best][j]) > 1e-14)) {
            return 1;
        }
        for (int k = 0; k < UNKNOWNS; ++k) {
            const double one = a[j][k], two = y[j][k];
            a[j][k] = a[best][k];
            a[best][k] = one;
            y[j][k] = y[best][k];
            y[best][k] = two;
        }
        const double scale = 1.0 / a[j][j];
        for (int k = 0; k < UNKNOWNS; ++k) {
            a[j][k] *= scale;
            y[j][k] *= scale;
        }
        for (int i = 0; i < UNKNOWNS; ++i) {
            const double factor = a[i][j];
            for (int k = 0; k < UNKNOWNS && i != j; ++k) {
                a[i][k] -= factor * a[j][k];
                y[i][k] -= factor * y[j][k];
            }
        }
    }
    return 0;
}

static const double nowhere[WIDTH] = {0.0};

/* Newton's iteration in doubles: a guess, which a box judges, and the inverse of the derivative. 1 where it does not
   converge. */
static int polished(Ball (*slots)[3], double *z, Chart *chart)
{
    double numbers[N_SLOTS][3], value[UNKNOWNS], jacobian[UNKNOWNS][WIDTH], square[UNKNOWNS][UNKNOWNS];
    for (int k = 0; k < N_SLOTS; ++k) {
        for (int i = 0; i < 3; ++i) {
            numbers[k][i] = slots[k][i].m;
        }
    }
    for (int count = 0; count < MOST_NEWTON; ++count) {
        double size = 0.0;
        plain_equations(numbers, z, (const double (*)[3][4])chart->mix, value, jacobian);
        for (int i = 0; i < UNKNOWNS; ++i) {
            for (int j = 0; j < UNKNOWNS; ++j) {
                square[i][j] = jacobian[i][chart->open[j]];
            }
        }
        if (inverted(square, chart->inverse)) {
            return 1;
        }
        for (int i = 0; i < UNKNOWNS; ++i) {
            double step = 0.0;
            for (int j = 0; j < UNKNOWNS; ++j) {
                step -= chart->inverse[i][j] * value[j];
            }
            z[chart->open[i]] += step;
            size = fabs(step) > size ? fabs(step) : size;
        }
        if (!(size < 10.0)) {
            return 1;
        }
        if (size < 1e-9) { /* the next step would be below rounding, or not come closer */
            return 0;
        }
    }
    return 1;
}

/* Whether a box around z + t way, as far as `least` or twice a step, holds one zero for every t and all numbers in the
   slots; its radius, and a bound on how far the zeros are from the middle of the box. Y is the inverse at z. */
static int boxed(Ball (*slots)[3], const double *z, const double *way, const Chart *chart, double least,
    double *radius, double *error)
{
    Ball step[UNKNOWNS], at[WIDTH], value[UNKNOWNS], jacobian[UNKNOWNS][WIDTH];
    double longest = 0.0, most = 0.0;
    for (int k = 0; k < WIDTH; ++k) {
        at[k] = ball_of(z[k]);
        at[k].c = way[k];
    }
    ball_equations(slots, at, (const double (*)[3][4])chart->mix, value, (Ball (*)[WIDTH])0);
    for (int i = 0; i < UNKNOWNS; ++i) { /* - Y F along z + t way */
        step[i] = ball_of(0.0);
        for (int j = 0; j < UNKNOWNS; ++j) {
            step[i] = ball_sub(step[i], ball_times(chart->inverse[i][j], value[j]));
        }
        longest = ball_size(step[i]) > longest ? ball_size(step[i]) : longest;
    }
    longest *= SLACK;
    *radius = 2.0 * longest > least ? 2.0 * longest : least;
    for (int i = 0; i < UNKNOWNS; ++i) {
        at[chart->open[i]].r = *radius;
    }
    ball_equations(slots, at, (const double (*)[3][4])chart->mix, value, jacobian);
    for (int i = 0; i < UNKNOWNS; ++i) {
        double sum = 0.0;
        for (int j = 0; j < UNKNOWNS; ++j) {
            Ball entry = ball_of(i == j ? 1.0 : 0.0);
            for (int k = 0; k < UNKNOWNS; ++k) {
                entry = ball_sub(entry, ball_times(chart->inverse[i][k], jacobian[k][chart->open[j]]));
            }
            sum += ball_size(entry);
        }
        sum *= SLACK;
        if (!((ball_size(step[i]) + sum * *radius) * SLACK < *radius)) {
            return 0;
        }
        most = sum > most ? sum : most;
    }
    *error = longest / (1.0 - most) * SLACK;
    return most < 1.0;
}

/* ---- A mode, and where it stands. ---- */

/* Rotation by columns, then displacement of what is at O [m], of the platform from the reference. */
static void pose_of(const Place *places, Ball (*slots)[3], const double *z, double *pose)
{
    Ball at[WIDTH], g[8], own[8], next[8];
    for (int k = 0; k < WIDTH; ++k) {
        at[k] = ball_of(z[k]);
    }
    for (int k = 0; k < 8; ++k) {
        g[k] = ball_of(k ? 0.0 : 1.0);
    }
    for (int k = 0; k < N_CHAIN; ++k) {
        ball_motion(platform_chain[k], 0, slots, at, own);
        ball_product(g, own, next);
        for (int i = 0; i < 8; ++i) {
            g[i] = next[i];
        }
    }
    const double w = g[0].m, x = g[1].m, y = g[2].m, v = g[3].m;
    const double norm = 1.0 / (w * w + x * x + y * y + v * v);
    const double turn[9] = {
        1.0 - 2.0 * (y * y + v * v) * norm, 2.0 * (x * y - w * v) * norm, 2.0 * (x * v + w * y) * norm,
        2.0 * (x * y + w * v) * norm, 1.0 - 2.0 * (x * x + v * v) * norm, 2.0 * (y * v - w * x) * norm,
        2.0 * (x * v - w * y) * norm, 2.0 * (y * v + w * x) * norm, 1.0 - 2.0 * (x * x + y * y) * norm};
    const double a = g[4].m, b = g[5].m, c = g[6].m, d = g[7].m;
    const double shift[3] = { /* 2 y x* */
        2.0 * (b * w - a * x - c * v + d * y) * norm, 2.0 * (c * w - a * y - d * x + b * v) * norm,
        2.0 * (d * w - a * v - b * y + c * x) * norm};
    const Place *inside = &places[PLATFORM_BODY];
    double whole[9], way[3], turned[9];
    for (int i = 0; i < 3; ++i) {
        way[i] = shift[i];
        for (int j = 0; j < 3; ++j) {
            way[i] += turn[3 * i + j] * inside->shift[j].m;
            whole[3 * i + j] = 0.0;
            for (int k = 0; k < 3; ++k) {
                whole[3 * i + j] += turn[3 * i + k] * inside->turn[3 * k + j].m;
            }
        }
    }
    for (int i = 0; i < 3; ++i) { /* from the frame that coordinates are counted in, about the centre */
        for (int j = 0; j < 3; ++j) {
            turned[3 * i + j] = 0.0;
            for (int k = 0; k < 3; ++k) {
                for (int l = 0; l < 3; ++l) {
                    turned[3 * i + j] += frame[k][i] * whole[3 * k + l] * frame[l][j];
                }
            }
            pose[i + 3 * j] = turned[3 * i + j];
        }
    }
    for (int i = 0; i < 3; ++i) {
        double moved_by = centre[i];
        for (int j = 0; j < 3; ++j) {
            moved_by += frame[j][i] * way[j] - turned[3 * i + j] * centre[j];
        }
        pose[9 + i] = moved_by * SIZE;
    }
}

static void exactly(const double *drives, Ball *balls)
{
    for (int k = 0; k < N_DRIVES; ++k) {
        balls[k] = ball_of(drives[k]);
    }
}

/* Certifies the zero z of these drives and writes the mode; 1 where there is no certificate. */
static int settled(
    const double *drives, const Place *places, Ball (*slots)[3], const double *z, MODE *mode)
{
    Chart chart;
    double radius = 0.0, error = 0.0;
    for (int k = 0; k < WIDTH; ++k) {
        mode->z[k] = z[k];
    }
    chart_of(mode->z, slots, &chart);
    if (polished(slots, mode->z, &chart)) {
        return 1;
    }
    mode->certified = boxed(slots, mode->z, nowhere, &chart, LEAST_BOX, &radius, &error);
    mode->error = mode->certified ? error : 0.0;
    for (int k = 0; k < N_DRIVES; ++k) {
        mode->drives[k] = drives[k];
    }
    pose_of(places, slots, mode->z, mode->pose);
    return mode->certified ? 0 : 1;
}

/* One step straight to other drives, proved: for all drives between, one zero lies in a box around the straight way of
   the zeros, and the mode's lies in it at the start. */
static int stepped(MODE *mode, const double *drives)
{
    Ball balls[N_DRIVES], slots[N_SLOTS][3], middle_slots[N_SLOTS][3];
    Place places[N_BODIES];
    MODE next;
    Chart chart;
    double middle[N_DRIVES], z[WIDTH], way[WIDTH], radius = 0.0, error = 0.0, farthest = 0.0;
    exactly(drives, balls);
    slots_of(balls, places, slots);
    if (settled(drives, places, slots, mode->z, &next)) {
        return 1;
    }
    for (int k = 0; k < N_DRIVES; ++k) {
        middle[k] = 0.5 * (drives[k] + mode->drives[k]);
        balls[k].m = middle[k];
        balls[k].c = 0.5 * (drives[k] - mode->drives[k]);
        balls[k].r = 2.0 * UNIT * (fabs(drives[k]) + fabs(mode->drives[k]));
    }
    slots_of(balls, places, slots);
    exactly(middle, balls);
    slots_of(balls, places, middle_slots);
    for (int k = 0; k < WIDTH; ++k) {
        z[k] = mode->z[k];
    }
    chart_of(z, middle_slots, &chart);
    if (polished(middle_slots, z, &chart)) {
        return 1;
    }
    /* both ends in this chart: a scale by a coordinate that is the largest, or nearly so, at most quadruples errors */
    for (int group = 0; group < N_GROUPS; ++group) {
        const double one = mode->z[chart.fixed[group]], two = next.z[chart.fixed[group]];
        if (!(fabs(one) > 0.75 && fabs(two) > 0.75)) {
            return 1;
        }
        for (int k = group_start[group]; k < group_start[group] + group_width[group]; ++k) {
            const double first = mode->z[k] / one, last = next.z[k] / two;
            way[k] = k == chart.fixed[group] ? 0.0 : 0.5 * (last - first);
            const double off = fabs(z[k] - way[k] - first), beyond = fabs(z[k] + way[k] - last);
            farthest = off > farthest ? off : farthest;
            farthest = beyond > farthest ? beyond : farthest;
        }
    }
    const double needed = (farthest + 4.0 * (mode->error + next.error)) * SLACK + 1e-15;
    if (!boxed(slots, z, way, &chart, 1.5 * needed, &radius, &error) || !(needed < radius)) {
        return 1;
    }
    *mode = next;
    return 0;
}

int NEAREST(MODE *mode, const double *drives)
{
    MODE now = *mode;
    double target[N_DRIVES], part = 1.0, done = 0.0, sum = 0.0;
    for (int k = 0; k < N_DRIVES; ++k) {
        sum += 0.0 * drives[k];
    }
    if (!isfinite(sum)) {
        return 2;
    }
    if (!mode->certified) {
        return MODES_NOT_CERTIFIED;
    }
    for (int count = 0; count < MOST_PARTS && done < 1.0; ++count) {
        const double until = done + part < 1.0 ? done + part : 1.0;
        for (int k = 0; k < N_DRIVES; ++k) {
            target[k] = until < 1.0 ? mode->drives[k] + (drives[k] - mode->drives[k]) * until : drives[k];
        }
        if (stepped(&now, target) == 0) {
            done = until;
            part *= 2.0;
        } else {
            part *= 0.5;
        }
    }
    if (done < 1.0) {
        return MODES_REFUSED;
    }
    *mode = now;
    return 0;
}
