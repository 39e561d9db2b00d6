/* The closure's equations and their derivative for numbers of one kind: NUM with ADD, SUB, MUL, TIMES (by a double) and
   OF (a double). Displacements are dual quaternions x + eps y, linear in the coordinates of each joint. */

/* a b of quaternions, added to `out` where `more` is 1. */
static inline void FN(quaternion)(const NUM *a, const NUM *b, int more, NUM *out)
{
    NUM c[4];
    c[0] = SUB(SUB(MUL(a[0], b[0]), MUL(a[1], b[1])), ADD(MUL(a[2], b[2]), MUL(a[3], b[3])));
    c[1] = ADD(ADD(MUL(a[0], b[1]), MUL(a[1], b[0])), SUB(MUL(a[2], b[3]), MUL(a[3], b[2])));
    c[2] = ADD(SUB(MUL(a[0], b[2]), MUL(a[1], b[3])), ADD(MUL(a[2], b[0]), MUL(a[3], b[1])));
    c[3] = ADD(ADD(MUL(a[0], b[3]), MUL(a[1], b[2])), SUB(MUL(a[3], b[0]), MUL(a[2], b[1])));
    for (int k = 0; k < 4; ++k) {
        out[k] = more ? ADD(out[k], c[k]) : c[k];
    }
}

/* a b of dual quaternions. */
static void FN(product)(const NUM *a, const NUM *b, NUM *out)
{
    FN(quaternion)(a, b, 0, out);
    FN(quaternion)(a, b + 4, 0, out + 4);
    FN(quaternion)(a + 4, b, 1, out + 4);
}

/* The difference and the sum of two points: x p - a x of a quaternion x is linear in these. */
static inline void FN(pair)(const NUM *p, const NUM *a, NUM *d, NUM *s)
{
    for (int k = 0; k < 3; ++k) {
        d[k] = SUB(p[k], a[k]);
        s[k] = ADD(p[k], a[k]);
    }
}

/* x p - a x + 2 y: what a point p of the displaced body is off the point a, times x; 2 y only where y is given. Its
   scalar is - v . d, its vector w d + v x s, with x = (w, v). Of a planar displacement v is along the normal, and what
   comes out is in the plane. */
static inline void FN(off)(const NUM *x, const NUM *y, const NUM *d, const NUM *s, NUM *out)
{
#if PLANAR
    out[0] = out[3] = OF(0.0);
    out[1] = SUB(MUL(x[0], d[0]), MUL(x[3], s[1]));
    out[2] = ADD(MUL(x[0], d[1]), MUL(x[3], s[0]));
#else
    out[0] = SUB(OF(0.0), ADD(ADD(MUL(x[1], d[0]), MUL(x[2], d[1])), MUL(x[3], d[2])));
    out[1] = ADD(MUL(x[0], d[0]), SUB(MUL(x[2], s[2]), MUL(x[3], s[1])));
    out[2] = ADD(MUL(x[0], d[1]), SUB(MUL(x[3], s[0]), MUL(x[1], s[2])));
    out[3] = ADD(MUL(x[0], d[2]), SUB(MUL(x[1], s[1]), MUL(x[2], s[0])));
#endif
    for (int k = PLANAR; k < 4 - PLANAR && y; ++k) {
        out[k] = ADD(out[k], TIMES(2.0, y[k]));
    }
}

/* The transpose of the same by x, with its sign turned. */
static inline void FN(off_back)(const NUM *w, const NUM *d, const NUM *s, NUM *out)
{
#if PLANAR
    out[1] = out[2] = OF(0.0);
    out[0] = SUB(OF(0.0), ADD(MUL(w[1], d[0]), MUL(w[2], d[1])));
    out[3] = SUB(MUL(w[1], s[1]), MUL(w[2], s[0]));
#else
    FN(off)(w, (const NUM *)0, d, s, out);
#endif
}

/* Column j of the motion of a joint: its displacement is the sum of its coordinates times these. */
static void FN(column)(int group, int j, NUM (*slots)[3], NUM *out)
{
    const int kind = group_kind[group];
    for (int k = 0; k < 8; ++k) {
        out[k] = OF(0.0);
    }
#ifdef COUPLINGS
    if (kind == GROUP_TURNED || kind == GROUP_SLID) { /* as a factor of a coupling: about or along one axis for all */
        const int first = kind == GROUP_TURNED ? 3 : 5;
        out[j ? first : 0] = OF(j ? spin_size[group - N_GROUPS] : kind == GROUP_TURNED ? 1.0 : 2.0);
        return;
    }
#endif
    if (kind == GROUP_FREE) {
        out[j] = OF(1.0);
    } else if (kind == GROUP_PLANAR) {
        out[planar_place[j]] = OF(1.0);
    } else if (kind == GROUP_BALL) {
        NUM x[4] = {OF(0.0), OF(0.0), OF(0.0), OF(0.0)}, turned[4], d[3], s[3];
        const NUM *p = slots[group_slots[group][0]];
        x[j] = OF(1.0);
        FN(pair)(p, p, d, s);
        FN(off)(x, (const NUM *)0, d, s, turned); /* x p - p x */
        out[j] = OF(2.0);
        for (int k = 0; k < 4; ++k) {
            out[4 + k] = SUB(OF(0.0), turned[k]);
        }
    } else if (j == 0) {
        out[0] = OF(kind == GROUP_SLIDE ? 2.0 : 1.0);
    } else {
        const NUM *w = slots[group_slots[group][0]];
        if (kind == GROUP_SLIDE) {
            for (int k = 0; k < 3; ++k) {
                out[5 + k] = w[k];
            }
            return;
        }
        const NUM *p = slots[group_slots[group][1]];
        for (int k = 0; k < 3; ++k) {
            const int l = (k + 1) % 3, m = (k + 2) % 3;
            out[1 + k] = w[k];
            out[5 + k] = SUB(MUL(p[l], w[m]), MUL(p[m], w[l]));
        }
    }
}

/* The displacement of a joint, or its inverse where it is passed back. */
static void FN(motion)(int group, int back, NUM (*slots)[3], const NUM *z, NUM *out)
{
    NUM part[8];
    const NUM *own = z + group_start[group];
    for (int k = 0; k < 8; ++k) {
        out[k] = group_kind[group] == GROUP_FREE ? own[k] : OF(0.0);
    }
    for (int j = 0; j < group_width[group] && group_kind[group] != GROUP_FREE; ++j) {
        if (group_kind[group] == GROUP_PLANAR) {
            out[planar_place[j]] = own[j];
            continue;
        }
        FN(column)(group, j, slots, part);
        for (int k = 0; k < 8; ++k) {
            out[k] = ADD(out[k], MUL(part[k], own[j]));
        }
    }
    for (int k = 0; k < 8 && back; ++k) {
        out[k] = k % 4 ? SUB(OF(0.0), out[k]) : out[k];
    }
}

/* A form at the displacement g: its rows (values), and their gradients by g; `mix` leaves three of four rows. */
static int FN(form)(int form, NUM (*slots)[3], const NUM *g, const double (*mix)[4], NUM *value, NUM (*slope)[8])
{
    const int kind = form_kind[form];
    const NUM *p = slots[form_slots[form][0]], *a = slots[form_slots[form][1]];
    NUM w[4], d[3], s[3];
    FN(pair)(p, a, d, s);
    if (kind == FORM_DISTANCE) { /* half of |x p + 2 y - a x|^2 - L^2 |x|^2, the second factor Study's condition */
        const NUM *square = slots[form_slots[form][2]];
        FN(off)(g, g + 4, d, s, w);
        NUM total = OF(0.0), size = OF(0.0), back[4];
        for (int k = 0; k < 4; ++k) {
            total = PLANAR && k % 3 == 0 ? total : ADD(total, MUL(w[k], w[k]));
            size = PLANAR && k % 3 ? size : ADD(size, MUL(g[k], g[k]));
            slope[0][4 + k] = TIMES(2.0, w[k]);
        }
        /* w by x is x p - a x: its transpose takes w to -(w p - a w) */
        FN(off_back)(w, d, s, back);
        for (int k = 0; k < 4; ++k) {
            slope[0][k] = PLANAR && k % 3 ? back[k] : SUB(OF(0.0), ADD(back[k], MUL(square[0], g[k])));
        }
        value[0] = TIMES(0.5, SUB(total, MUL(square[0], size)));
        return 1;
    }
    if (kind == FORM_ANGLE) { /* half of a . x p x* - k |x|^2 */
        NUM u[4] = {OF(0.0), a[0], a[1], a[2]}, v[4] = {OF(0.0), p[0], p[1], p[2]}, back[4], turned[4];
        const NUM *k = slots[form_slots[form][2]];
        FN(quaternion)(u, g, 0, back); /* u . x v x* = (u x) . (x v), and its gradient - 2 u x v by x */
        FN(quaternion)(back, v, 0, turned);
        value[0] = OF(0.0);
        for (int i = 0; i < 4; ++i) {
            slope[0][i] = SUB(OF(0.0), ADD(turned[i], MUL(k[0], g[i])));
            slope[0][4 + i] = OF(0.0);
            value[0] = ADD(value[0], TIMES(0.5, MUL(slope[0][i], g[i])));
        }
        return 1;
    }
#ifdef COUPLINGS
    if (kind == FORM_TURNED || kind == FORM_SLID) { /* a product of turns or slides is one by what is known */
        const int along = kind == FORM_TURNED ? 3 : 5;
        for (int k = 0; k < 8; ++k) {
            slope[0][k] = k == along ? p[0] : OF(0.0);
        }
        slope[0][0] = SUB(OF(0.0), p[1]);
        value[0] = SUB(MUL(p[0], g[along]), MUL(p[1], g[0]));
        return 1;
    }
#endif
#if CROSSINGS
    if (kind == FORM_CROSSING) { /* half of u . m' + (q x u) . w' of the lines w through p and u through q: the gradient
                                    of the whole by x is - 2 (u y w + u x m + (q x u) x w), by y it is - 2 u x w */
        const NUM *of_p = slots[form_slots[form][1]], *of_u = slots[form_slots[form][2]];
        const NUM *of_q = slots[form_slots[form][3]];
        NUM u[4] = {OF(0.0), of_u[0], of_u[1], of_u[2]}, v[4] = {OF(0.0), p[0], p[1], p[2]};
        NUM m[4] = {OF(0.0)}, n[4] = {OF(0.0)}, ux[4], part[4];
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            m[1 + k] = SUB(MUL(of_p[i], p[j]), MUL(of_p[j], p[i]));
            n[1 + k] = SUB(MUL(of_q[i], of_u[j]), MUL(of_q[j], of_u[i]));
        }
        FN(quaternion)(u, g, 0, ux);
        FN(quaternion)(ux, v, 0, slope[0] + 4);
        FN(quaternion)(ux, m, 0, slope[0]);
        FN(quaternion)(u, g + 4, 0, part);
        FN(quaternion)(n, g, 1, part);
        FN(quaternion)(part, v, 1, slope[0]);
        value[0] = OF(0.0);
        for (int i = 0; i < 8; ++i) {
            slope[0][i] = SUB(OF(0.0), slope[0][i]);
            value[0] = ADD(value[0], TIMES(0.5, MUL(slope[0][i], g[i])));
        }
        return 1;
    }
#endif
    /* points that meet: x p + 2 y - a x, of a planar mechanism its middle two rows; an axis of both: x w - u x, two rows
       of four, which an antisymmetric matrix of rank two makes of x as both are as long as one another */
    const int shared = kind == FORM_PARALLEL, count = PLANAR || shared ? 2 : 3;
    NUM rows[4][8];
    FN(off)(g, shared ? (const NUM *)0 : g + 4, d, s, w);
    for (int j = 0; j < 4; ++j) {
        NUM x[4] = {OF(0.0), OF(0.0), OF(0.0), OF(0.0)}, turned[4];
        x[j] = OF(1.0);
        FN(off)(x, (const NUM *)0, d, s, turned);
        for (int i = 0; i < 4; ++i) {
            rows[i][j] = turned[i];
            rows[i][4 + j] = OF(i == j && !shared ? 2.0 : 0.0);
        }
    }
    for (int r = 0; r < count; ++r) {
        value[r] = OF(0.0);
        for (int k = 0; k < 8; ++k) {
            slope[r][k] = OF(0.0);
        }
        for (int i = 0; i < 4; ++i) {
            const double part = PLANAR ? (double)(i == r + 1) : shared ? path_mix[N_LOOPS][r][i] : mix[r][i];
            if (part != 0.0) {
                value[r] = ADD(value[r], TIMES(part, w[i]));
                for (int k = 0; k < 8; ++k) {
                    slope[r][k] = ADD(slope[r][k], TIMES(part, rows[i][k]));
                }
            }
        }
    }
    return count;
}

/* All equations at z, and their derivative, row by row, where it is asked for. */
static void FN(equations)(NUM (*slots)[3], const NUM *z, const double (*mix)[3][4], NUM *value, NUM (*jacobian)[WIDTH])
{
    int row = 0;
    for (int loop = 0; loop < N_LOOPS; ++loop) {
        const int first = loop_first[loop], count = loop_first[loop + 1] - first;
        NUM own[LONGEST][8], before[LONGEST][8], behind[LONGEST][8], slope[LARGEST_LOOP][8];
        const int begin = row;
        for (int k = 0; k < count; ++k) {
            FN(motion)(way_group[first + k], way_back[first + k], slots, z, own[k]);
            if (k == 0) {
                for (int i = 0; i < 8; ++i) {
                    before[0][i] = own[0][i];
                }
            } else {
                FN(product)(before[k - 1], own[k], before[k]);
            }
        }
        for (int form = form_first[loop]; form < form_first[loop + 1]; ++form) {
            row += FN(form)(form, slots, before[count - 1], mix[loop], value + row, slope + (row - begin));
        }
        if (!jacobian) {
            continue;
        }
        for (int i = 0; i < 8; ++i) {
            behind[count - 1][i] = own[count - 1][i];
        }
        for (int k = count - 2; k > 0; --k) {
            FN(product)(own[k], behind[k + 1], behind[k]);
        }
        for (int r = begin; r < row; ++r) {
            for (int j = 0; j < WIDTH; ++j) {
                jacobian[r][j] = OF(0.0);
            }
        }
        for (int k = 0; k < count; ++k) {
            const int group = way_group[first + k];
            for (int j = 0; j < group_width[group]; ++j) {
                const int at = group_start[group] + j;
                NUM one[8], two[8];
                const int kind = group_kind[group];
                if (count == 1 && (kind == GROUP_FREE || kind == GROUP_PLANAR)) { /* g is z itself */
                    for (int r = begin; r < row; ++r) {
                        jacobian[r][at] = slope[r - begin][kind == GROUP_FREE ? j : planar_place[j]];
                    }
                    continue;
                }
                FN(column)(group, j, slots, one);
                for (int i = 0; i < 8 && way_back[first + k]; ++i) {
                    one[i] = i % 4 ? SUB(OF(0.0), one[i]) : one[i];
                }
                if (k > 0) {
                    FN(product)(before[k - 1], one, two);
                    for (int i = 0; i < 8; ++i) {
                        one[i] = two[i];
                    }
                }
                if (k < count - 1) {
                    FN(product)(one, behind[k + 1], two);
                    for (int i = 0; i < 8; ++i) {
                        one[i] = two[i];
                    }
                }
                for (int r = begin; r < row; ++r) {
                    NUM total = MUL(slope[r - begin][0], one[0]);
                    for (int i = 1; i < 8; ++i) {
                        total = ADD(total, MUL(slope[r - begin][i], one[i]));
                    }
#ifdef COUPLINGS
                    jacobian[r][at] = ADD(jacobian[r][at], total); /* a group may be several factors */
#else
                    jacobian[r][at] = total;
#endif
                }
            }
        }
    }
    for (int group = 0; group < N_GROUPS; ++group) {
        if (group_kind[group] == GROUP_FREE) { /* Study's condition */
            const NUM *x = z + group_start[group];
            value[row] = OF(0.0);
            for (int i = 0; i < 4; ++i) {
                value[row] = ADD(value[row], MUL(x[i], x[4 + i]));
            }
            for (int j = 0; j < WIDTH && jacobian; ++j) {
                jacobian[row][j] = OF(0.0);
            }
            for (int i = 0; i < 8 && jacobian; ++i) {
                jacobian[row][group_start[group] + i] = x[(i + 4) % 8];
            }
            ++row;
        }
    }
}
