/// Makes the columns of a (rows x columns) orthogonal by rotations from the right, collected in v.
fn orthogonalise<M: Math>(rows: usize, columns: usize, a: &mut [Real], v: &mut [Real]) {
    let mut total = 0.0;
    for value in a.iter().take(rows * columns) {
        total += value * value;
    }
    for j in 0..columns {
        for i in 0..columns {
            v[i + j * columns] = if i == j { 1.0 } else { 0.0 };
        }
    }
    for _ in 0..40 {
        let mut turned = false;
        for i in 0..columns {
            for j in i + 1..columns {
                let (mut xx, mut yy, mut xy) = (0.0, 0.0, 0.0);
                for k in 0..rows {
                    let (x, y) = (a[i * rows + k], a[j * rows + k]);
                    xx += x * x;
                    yy += y * y;
                    xy += x * y;
                }
                let least = if xx < yy { xx } else { yy };
                if least <= LEAST * total || size(xy) <= EQUAL * M::sqrt(xx * yy) {
                    continue;
                }
                turned = true;
                let ratio = (yy - xx) / (2.0 * xy);
                let sign = if ratio < 0.0 { -1.0 } else { 1.0 };
                let tangent = sign / (size(ratio) + M::sqrt(1.0 + ratio * ratio));
                let cosine = 1.0 / M::sqrt(1.0 + tangent * tangent);
                let sine = cosine * tangent;
                rotate(rows, i, j, cosine, sine, a);
                rotate(columns, i, j, cosine, sine, v);
            }
        }
        if !turned {
            break;
        }
    }
}

/// Turns columns i and j of `rows` entries.
fn rotate(rows: usize, i: usize, j: usize, cosine: Real, sine: Real, a: &mut [Real]) {
    for k in 0..rows {
        let (x, y) = (a[i * rows + k], a[j * rows + k]);
        a[i * rows + k] = cosine * x - sine * y;
        a[j * rows + k] = sine * x + cosine * y;
    }
}

fn dot(x: &[Real], y: &[Real]) -> Real {
    let mut sum = 0.0;
    for (a, b) in x.iter().zip(y) {
        sum += a * b;
    }
    sum
}

/// Solves a positive definite system in place; false if a pivot is lost.
fn cholesky<M: Math>(size: usize, matrix: &mut [Real], right: &mut [Real]) -> bool {
    let mut largest = 0.0;
    for j in 0..size {
        let entry = matrix[j + j * size];
        largest = if entry > largest { entry } else { largest };
    }
    for j in 0..size {
        for i in j..size {
            let mut sum = matrix[i + j * size];
            for k in 0..j {
                sum -= matrix[i + k * size] * matrix[j + k * size];
            }
            if i == j && !(sum > LOST * largest) {
                return false;
            }
            matrix[i + j * size] = if i == j { M::sqrt(sum) } else { sum / matrix[j + j * size] };
        }
        for k in 0..j {
            right[j] -= matrix[j + k * size] * right[k];
        }
        right[j] /= matrix[j + j * size];
    }
    for j in (0..size).rev() {
        for i in j + 1..size {
            right[j] -= matrix[i + j * size] * right[i];
        }
        right[j] /= matrix[j + j * size];
    }
    true
}

/// What the second path is given, without units: matrices by columns.
struct Given<'a> {
    mass: &'a [Real],
    force: &'a [Real],
    bias: &'a [Real],
}

/// Accelerations a and multipliers from mass a = force + jacobian^T multipliers, jacobian a + bias = 0; v takes the
/// null space. Returns the rank of the jacobian, or -1 if no acceleration is unique.
fn constrained<M: Math>(
    given: &Given,
    jacobian: &mut [Real],
    v: &mut [Real],
    work: &mut [Real],
    a: &mut [Real],
    multipliers: &mut [Real],
) -> i32 {
    let (n, m) = (given.force.len(), given.bias.len());
    let (sizes, work) = work.split_at_mut(n);
    let (reduced, work) = work.split_at_mut(n * n);
    let (right, moved) = work.split_at_mut(n);
    let mut largest = 1.0; // unit screws: one is their size
    let mut rank = 0;
    orthogonalise::<M>(m, n, jacobian, v);
    for j in 0..n {
        let column = &jacobian[j * m..(j + 1) * m];
        sizes[j] = dot(column, column);
        largest = if sizes[j] > largest { sizes[j] } else { largest };
        a[j] = 0.0;
    }
    for j in 0..n {
        if sizes[j] > RANK * RANK * largest {
            let part = dot(&jacobian[j * m..(j + 1) * m], given.bias) / sizes[j];
            for k in 0..n {
                a[k] -= part * v[k + j * n];
            }
            rank += 1;
        } else {
            sizes[j] = 0.0;
        }
    }
    let count = n - rank;
    for k in 0..n {
        moved[k] = given.force[k] - dot(&given.mass[k * n..(k + 1) * n], a);
    }
    let mut free = 0;
    for j in 0..n {
        if sizes[j] > 0.0 {
            continue;
        }
        let mut other = 0;
        for i in 0..n {
            if sizes[i] > 0.0 {
                continue;
            }
            let mut sum = 0.0;
            for k in 0..n {
                sum += v[k + i * n] * dot(&given.mass[k * n..(k + 1) * n], &v[j * n..(j + 1) * n]);
            }
            reduced[other + free * count] = sum;
            other += 1;
        }
        right[free] = dot(&v[j * n..(j + 1) * n], moved);
        free += 1;
    }
    if !cholesky::<M>(count, reduced, right) {
        return -1;
    }
    free = 0;
    for j in 0..n {
        if sizes[j] > 0.0 {
            continue;
        }
        for k in 0..n {
            a[k] += right[free] * v[k + j * n];
        }
        free += 1;
    }
    for k in 0..n {
        moved[k] = dot(&given.mass[k * n..(k + 1) * n], a) - given.force[k];
    }
    for value in multipliers.iter_mut() {
        *value = 0.0;
    }
    for j in 0..n {
        if sizes[j] > 0.0 {
            let part = dot(&v[j * n..(j + 1) * n], moved) / sizes[j];
            for i in 0..m {
                multipliers[i] += part * jacobian[i + j * m];
            }
        }
    }
    rank as i32
}

/// A unit vector of multipliers that is in equilibrium by itself: orthogonal to the columns of the jacobian that count
/// and to the `found` earlier ones.
fn internal_load<M: Math>(n: usize, m: usize, jacobian: &[Real], found: usize, loads: &mut [Real]) {
    let (mut best, mut largest) = (-1.0, 1.0);
    for j in 0..n {
        let column = &jacobian[j * m..(j + 1) * m];
        let size = dot(column, column);
        largest = if size > largest { size } else { largest };
    }
    let (earlier, rest) = loads.split_at_mut(found * m);
    let load = &mut rest[..m];
    let mut chosen = 0;
    for pick in 0..m + 1 {
        let start = if pick < m { pick } else { chosen };
        for i in 0..m {
            load[i] = if i == start { 1.0 } else { 0.0 };
        }
        for _ in 0..2 {
            for j in 0..n + found {
                let column = if j < n { &jacobian[j * m..(j + 1) * m] } else { &earlier[(j - n) * m..(j - n + 1) * m] };
                let size = dot(column, column);
                if j >= n || size > RANK * RANK * largest {
                    let part = dot(column, load) / size;
                    for i in 0..m {
                        load[i] -= part * column[i];
                    }
                }
            }
        }
        let size = dot(load, load);
        if pick < m && size > best {
            best = size;
            chosen = pick;
        }
    }
    let factor = 1.0 / M::sqrt(dot(load, load));
    for value in load.iter_mut() {
        *value *= factor;
    }
}
