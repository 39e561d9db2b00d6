/* A kinematics module driven like LinuxCNC drives it, with the HAL of this file: a way of poses, inverse then forward.

   harness POSES JOINTS home_0 ... AXIS AMPLITUDE ... : ways between random poses about that of the home joints, up to
   AMPLITUDE [mm or degrees] along each AXIS (0 ... 5: X ... C), in small steps. Prints
   "poses refused wrong error inverse_us inverse_iterations forward_us forward_iterations", and the pins afterwards;
   wrong are those that came back to another pose, by more than 1e-3. */
#include <emcmotcfg.h>
#include <hal.h>
#include <kinematics.h>
#include <math.h>
#include <rtapi.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

int rtapi_app_main(void);
/* of newer sources: other modules may not have them */
__attribute__((weak)) int kinematicsJacobian(const double *joint, const EmcPose *pos, double (*jac)[EMCMOT_MAX_AXIS],
                                             const unsigned long *flags);
__attribute__((weak)) int kinematicsToolFrame(const double *joint, PmRotationMatrix *rot, const unsigned long *flags);

static union { char bytes[1 << 16]; double aligned; } store;
static size_t used;
static struct { char name[64]; void *at; char kind; } pins[256];
static int count;

void *hal_malloc(long size)
{
    void *made = store.bytes + used;
    used += ((size_t)size + 15) & ~(size_t)15;
    return made;
}
int hal_init(const char *name) { return name != NULL; }
int hal_exit(int id) { return id < 0; }
int hal_ready(int id) { return id < 0; }

static void add(void **pin, char kind, const char *format, va_list rest)
{
    *pin = hal_malloc(16);
    vsnprintf(pins[count].name, sizeof pins[count].name, format, rest);
    pins[count].kind = kind;
    pins[count++].at = *pin;
}
#define PIN(function, type, kind) \
    int function(hal_pin_dir_t dir, type **pin, int id, const char *format, ...) \
    { \
        va_list rest; \
        (void)dir; \
        (void)id; \
        va_start(rest, format); \
        add((void **)pin, kind, format, rest); \
        va_end(rest); \
        return 0; \
    }
PIN(hal_pin_float_newf, hal_float_t, 'f')
PIN(hal_pin_s32_newf, hal_s32_t, 'i')
PIN(hal_pin_u32_newf, hal_u32_t, 'i')
PIN(hal_pin_bit_newf, hal_bit_t, 'b')

static void *named(const char *end)
{
    for (int k = 0; k < count; ++k) {
        const size_t all = strlen(pins[k].name), part = strlen(end);
        if (all > part && strcmp(pins[k].name + all - part, end) == 0) {
            return pins[k].at;
        }
    }
    return NULL;
}

static double *axis(EmcPose *pose, int k)
{
    double *const axes[6] = {&pose->tran.x, &pose->tran.y, &pose->tran.z, &pose->a, &pose->b, &pose->c};
    return axes[k];
}

static double even(uint64_t *seed) /* -1 ... 1 */
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) / 4503599627370496.0 - 1.0;
}

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int main(int argc, char **argv)
{
    const int poses = atoi(argv[1]), joints = atoi(argv[2]), axes = (argc - 3 - joints) / 2;
    char **const given = argv + 3 + joints;
    double joint[16], from[6] = {0}, to[6] = {0}, worst = 0, forward = 0, inverse = 0;
    long refused = 0, forward_steps = 0, inverse_steps = 0;
    unsigned long flags = 0;
    int left = 0, total = 1;
    uint64_t seed = 7;
    EmcPose home, found;
    long wrong = 0;
    memset(&home, 0, sizeof home);
    home.tran.z = getenv("START_Z") != NULL ? atof(getenv("START_Z")) : 0.0; /* where iterations may start */
    if (rtapi_app_main() != 0 || kinematicsType() != KINEMATICS_BOTH) {
        return 2;
    }
    const volatile uint32_t *const steps = named(".last-iterations");
    for (int k = 0; k < joints; ++k) {
        joint[k] = atof(argv[3 + k]);
    }
    found = home;
    if (kinematicsForward(joint, &home, &flags, &flags) != 0) { /* genhexkins starts its first call at zero */
        home = found;
        if (kinematicsForward(joint, &home, &flags, &flags) != 0) {
            printf("home is refused\n");
            return 1;
        }
    }
    found = home;
    for (int i = 0; i < poses; ++i) { /* forward starts at the pose before, as LinuxCNC has it */
        if (left == 0) {
            double way = 0;
            for (int x = 0; x < axes; ++x) {
                from[x] = to[x];
                to[x] = even(&seed);
                way = fabs(to[x] - from[x]) > way ? fabs(to[x] - from[x]) : way;
            }
            left = total = (int)(200 * way) + 1;
        }
        --left;
        EmcPose pose = home;
        for (int x = 0; x < axes; ++x) {
            const double part = from[x] + (to[x] - from[x]) * (total - left) / total;
            *axis(&pose, atoi(given[2 * x])) += part * atof(given[2 * x + 1]);
        }
        const double start = seconds();
        const int lost = kinematicsInverse(&pose, joint, &flags, &flags);
        const double middle = seconds();
        inverse_steps += *steps;
        if (lost != 0 || kinematicsForward(joint, &found, &flags, &flags) != 0) {
            ++refused;
            continue;
        }
        forward += seconds() - middle;
        inverse += middle - start;
        forward_steps += *steps;
        double off = 0;
        for (int x = 0; x < axes; ++x) {
            const int letter = atoi(given[2 * x]);
            const double way = *axis(&found, letter) - *axis(&pose, letter);
            off = fmax(off, fabs(letter < 3 ? way : remainder(way, 360.0)));
        }
        wrong += off > 1e-3;
        worst = off > worst ? off : worst;
    }
    if (getenv("SLOPES") != NULL) { /* the Jacobian beside differences of the inverse, and the tool's frame */
        double jac[EMCMOT_MAX_JOINTS][EMCMOT_MAX_AXIS], low[16], high[16], off = 0, size = 0;
        PmRotationMatrix frame;
        if (kinematicsJacobian(joint, &found, jac, &flags) != 0 || kinematicsToolFrame(joint, &frame, &flags) != 0) {
            return 3;
        }
        for (int x = 0; x < axes; ++x) {
            EmcPose beside = found;
            const int letter = atoi(given[2 * x]);
            *axis(&beside, letter) += 1e-3;
            int lost = kinematicsInverse(&beside, high, &flags, &flags);
            *axis(&beside, letter) -= 2e-3;
            lost += kinematicsInverse(&beside, low, &flags, &flags);
            for (int k = 0; k < joints; ++k) {
                off = fmax(off, lost != 0 ? 1 : fabs((high[k] - low[k]) / 2e-3 - jac[k][letter]));
                size = fmax(size, fabs(jac[k][letter]));
            }
        }
        printf("%.3e %.3e %.17g %.17g %.17g\n", off, size, frame.z.x, frame.z.y, frame.z.z);
        printf("%.17g %.17g %.17g\n", found.a, found.b, found.c);
        return 0;
    }
    printf("%d %ld %ld %.3e %.3f %.3f %.3f %.3f\n", poses, refused, wrong, worst, 1e6 * inverse / poses,
           (double)inverse_steps / poses, 1e6 * forward / poses, (double)forward_steps / poses);
    for (int k = 0; k < count; ++k) {
        const double value = pins[k].kind == 'f' ? *(double *)pins[k].at
                             : pins[k].kind == 'i' ? *(int32_t *)pins[k].at : *(bool *)pins[k].at;
        printf("%s %.9g\n", pins[k].name, value);
    }
    return 0;
}
