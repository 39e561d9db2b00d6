/* The start of a Cortex-M program without an operating system: vectors, memory, floating-point unit. */
#include <stdint.h>

extern uint32_t board_stack_top, board_data_load, board_data_start, board_data_end, board_bss_start, board_bss_end;

int main(void);
void board_reset(void);
void board_fault(void);
void board_exit(int code);

/* Semihosting: the operation `what` is done by the debugger or emulator. */
static int board_ask(int what, const void *with)
{
    register int operation __asm__("r0") = what;
    register const void *argument __asm__("r1") = with;
    __asm__ volatile("bkpt 0xab" : "+r"(operation) : "r"(argument) : "memory");
    return operation;
}

void board_print(const char *text);
void board_print(const char *text)
{
    (void)board_ask(0x04, text);
}

void board_exit(int code)
{
    const uint32_t reason[2] = {0x20026u, (uint32_t)code}; /* ADP_Stopped_ApplicationExit */
    (void)board_ask(0x20, reason);
    for (;;) {
    }
}

void board_fault(void)
{
    board_print("fault\n");
    board_exit(3);
}

void board_reset(void)
{
    *(volatile uint32_t *)0xE000ED88u |= 0xFu << 20; /* coprocessors 10 and 11: the floating-point unit */
    __asm__ volatile("dsb\n\tisb");
    const uint32_t *from = &board_data_load;
    for (uint32_t *to = &board_data_start; to < &board_data_end; ++to) {
        *to = *from++;
    }
    for (uint32_t *to = &board_bss_start; to < &board_bss_end; ++to) {
        *to = 0;
    }
    board_exit(main());
}

typedef void (*vector)(void);
__attribute__((section(".vectors"), used)) static const vector board_vectors[16] = {
    (vector)(uintptr_t)&board_stack_top, board_reset, board_fault, board_fault, board_fault, board_fault, board_fault,
    board_fault, board_fault, board_fault, board_fault, board_fault, board_fault, board_fault, board_fault, board_fault,
};
