/* Sizes of LinuxCNC, for tests without it. */
#define EMCMOT_MAX_JOINTS 16
#define EMCMOT_MAX_AXIS 9
