/* No closed form: paths find all zeros. */
static int closed_zeros(double (*goal)[3], double (*zeros)[WIDTH])
{
    (void)goal;
    (void)zeros;
    return -1;
}
