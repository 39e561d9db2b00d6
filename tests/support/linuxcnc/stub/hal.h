/* What a kinematics module calls of HAL, for tests without LinuxCNC; the types are those of its hal.h. */
#ifndef STUB_HAL_H
#define STUB_HAL_H
#include <stdbool.h>
#include <stdint.h>
#define hal_float_t volatile double
#define hal_s32_t volatile int32_t
#define hal_u32_t volatile uint32_t
#define hal_bit_t volatile bool
typedef enum { HAL_IN = 16, HAL_OUT = 32 } hal_pin_dir_t;
void *hal_malloc(long size);
int hal_init(const char *name);
int hal_exit(int comp_id);
int hal_ready(int comp_id);
int hal_pin_float_newf(hal_pin_dir_t dir, hal_float_t **pin, int comp_id, const char *format, ...);
int hal_pin_s32_newf(hal_pin_dir_t dir, hal_s32_t **pin, int comp_id, const char *format, ...);
int hal_pin_u32_newf(hal_pin_dir_t dir, hal_u32_t **pin, int comp_id, const char *format, ...);
int hal_pin_bit_newf(hal_pin_dir_t dir, hal_bit_t **pin, int comp_id, const char *format, ...);
#endif
