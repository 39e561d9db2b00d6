/* Runs with other parameters by the same library: values that are constants elsewhere are put in here, those of the
 * run-time parameters and the numbers of the contacts (coulomb, fixed, stribeck, lower, upper) that follow from them. */
void PUT_PARAMETERS(const GIVEN *values, const GIVEN *numbers)
{
    for (int k = 0; k < VARIED; ++k) {
        PARAMETERS[k] = values[k];
    }
#if CONTACTS
    for (int k = 0; k < CONTACTS; ++k) {
        Contact *c = CONTACT + k;
        c->coulomb = numbers[5 * k];
        c->fixed = numbers[5 * k + 1];
        c->stribeck = numbers[5 * k + 2];
        c->lower = numbers[5 * k + 3];
        c->upper = numbers[5 * k + 4];
    }
#else
    (void)numbers;
#endif
}
