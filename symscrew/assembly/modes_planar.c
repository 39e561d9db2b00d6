/* ---- A planar platform on three rods in closed form: differences of the three circles give its place for each angle, the
   third circle a trigonometric polynomial of degree 3 in the angle, so one of degree 6 in w = exp(i angle). ---- */

#define TURN 6.28318530717958647692

enum { SAMPLES = 7, DEGREE = 6 };

/* What is left of the third circle at an angle, and where the platform is (the place times the determinant). */
static double planar_left(double (*goal)[3], double angle, double *place, double *determinant)
{
    const double c = cos(angle), s = sin(angle);
    double u[3][2], square[3], row[2][2], right[2];
    for (int k = 0; k < 3; ++k) {
        const double *p = goal[form_slots[k][0]], *a = goal[form_slots[k][1]];
        u[k][0] = c * p[0] - s * p[1] - a[0];
        u[k][1] = s * p[0] + c * p[1] - a[1];
        square[k] = goal[form_slots[k][2]][0];
    }
    for (int k = 0; k < 2; ++k) {
        right[k] = square[k + 1] - square[0];
        for (int i = 0; i < 2; ++i) {
            row[k][i] = 2.0 * (u[k + 1][i] - u[0][i]);
            right[k] += u[0][i] * u[0][i] - u[k + 1][i] * u[k + 1][i];
        }
    }
    *determinant = row[0][0] * row[1][1] - row[0][1] * row[1][0];
    place[0] = right[0] * row[1][1] - right[1] * row[0][1];
    place[1] = row[0][0] * right[1] - row[1][0] * right[0];
    const double x = place[0] + *determinant * u[0][0], y = place[1] + *determinant * u[0][1];
    return x * x + y * y - square[0] * *determinant * *determinant;
}

/* All real zeros, or -1 where this way does not tell: a self-motion, or circles with a common chord. */
static int closed_zeros(double (*goal)[3], double (*zeros)[WIDTH])
{
    double value[SAMPLES], place[2], determinant, largest = 0.0, sizes = 0.0;
    double re[DEGREE + 1], im[DEGREE + 1], w[DEGREE][2];
    for (int k = 0; k < SAMPLES; ++k) {
        value[k] = planar_left(goal, TURN * k / SAMPLES, place, &determinant);
        sizes += place[0] * place[0] + place[1] * place[1] + determinant * determinant;
    }
    for (int m = 0; m <= 3; ++m) {
        double a = 0.0, b = 0.0;
        for (int k = 0; k < SAMPLES; ++k) {
            a += value[k] * cos(TURN * m * k / SAMPLES) / SAMPLES;
            b -= value[k] * sin(TURN * m * k / SAMPLES) / SAMPLES;
        }
        re[3 + m] = re[3 - m] = a;
        im[3 + m] = b;
        im[3 - m] = -b;
        largest = fabs(a) + fabs(b) > largest ? fabs(a) + fabs(b) : largest;
    }
    if (!(largest > 1e-12 * sizes)) {
        return -1;
    }
    int low = 0, high = DEGREE, count = 0;
    while (high > 3 && fabs(re[high]) + fabs(im[high]) < 1e-12 * largest) { /* zeros at infinity come in pairs */
        --high;
        ++low;
    }
    const int degree = high - low;
    for (int k = 0; k < degree; ++k) {
        w[k][0] = 1.1 * cos(TURN * k / degree + 0.4);
        w[k][1] = 1.1 * sin(TURN * k / degree + 0.4);
    }
    double longest = 1.0;
    int moving = 1;
    for (int turn = 0; turn < 60 && moving; ++turn) { /* Aberth's method, all zeros at once, of third order */
        longest = 0.0;
        moving = 0;
        for (int k = 0; k < degree; ++k) {
            double pr = re[high], pi = im[high], dr = 0.0, di = 0.0;
            for (int i = high - 1; i >= low; --i) {
                const double nr = dr * w[k][0] - di * w[k][1] + pr, ni = dr * w[k][1] + di * w[k][0] + pi;
                const double qr = pr * w[k][0] - pi * w[k][1] + re[i], qi = pr * w[k][1] + pi * w[k][0] + im[i];
                dr = nr;
                di = ni;
                pr = qr;
                pi = qi;
            }
            double norm = pr * pr + pi * pi;
            if (!(norm > 0.0)) {
                continue;
            }
            /* step = 1 / (P' / P - sum of 1 / (w - others)) */
            double sr = (dr * pr + di * pi) / norm, si = (di * pr - dr * pi) / norm;
            for (int i = 0; i < degree; ++i) {
                const double x = w[k][0] - w[i][0], y = w[k][1] - w[i][1], far = x * x + y * y;
                if (i != k && far > 0.0) {
                    sr -= x / far;
                    si += y / far;
                }
            }
            norm = sr * sr + si * si;
            if (!(norm > 0.0)) {
                continue;
            }
            w[k][0] -= sr / norm;
            w[k][1] += si / norm;
            const double step = 1.0 / (norm * (w[k][0] * w[k][0] + w[k][1] * w[k][1]));
            /* double zeros come slowly: those off the circle need only to be known to be off it */
            moving |= step >= (fabs(w[k][0] * w[k][0] + w[k][1] * w[k][1] - 1.0) < 1e-2 ? 1e-20 : 1e-13);
            longest = step > longest ? step : longest;
        }
    }
    if (!(longest < 1e-12)) { /* squared: a zero that still moves by a millionth may come to the circle, or leave it */
        return -1;
    }
    for (int k = 0; k < degree; ++k) {
        const double size = sqrt(w[k][0] * w[k][0] + w[k][1] * w[k][1]);
        if (!(fabs(size - 1.0) < 1e-5)) {
            continue;
        }
        const double angle = atan2(w[k][1], w[k][0]);
        planar_left(goal, angle, place, &determinant);
        if (!(determinant * determinant > 1e-16 * (place[0] * place[0] + place[1] * place[1]))) {
            return -1;
        }
        const double c = cos(0.5 * angle), s = sin(0.5 * angle);
        const double x = place[0] / determinant, y = place[1] / determinant;
        zeros[count][0] = c;
        zeros[count][1] = s;
        zeros[count][2] = 0.5 * (x * c + y * s);
        zeros[count][3] = 0.5 * (y * c - x * s);
        ++count;
    }
    return (degree - count) % 2 ? -1 : count; /* zeros off the circle come in pairs, mirrored in it */
}
