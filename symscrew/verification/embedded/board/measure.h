/* Instructions by the system timer, whose clock an emulator that counts instructions derives from them, and
   stack by a pattern that calls write over. */
#include <stddef.h>
#include <stdint.h>

extern uint32_t board_stack_limit;
void board_print(const char *text);

#define PATTERN 0xA5A5A5A5u
#define TIMER ((volatile uint32_t *)0xE000E010u)

static inline uint32_t now(void)
{
    return TIMER[2];
}

static void start_timer(void)
{
    TIMER[1] = 0xFFFFFFu;
    TIMER[2] = 0u;
    TIMER[0] = 5u;
}

static uint32_t *stack_here(void)
{
    uint32_t *here;
    __asm__ volatile("mov %0, sp" : "=r"(here));
    return here;
}

static __attribute__((noinline)) void paint(void)
{
    for (volatile uint32_t *at = stack_here() - 16; at > &board_stack_limit; --at) {
        *at = PATTERN;
    }
}

/* All by volatile accesses, so that the timer is not read before or after these loops.
   Bytes of the stack below `from` that were written since `paint`. */
static __attribute__((noinline)) uint32_t painted_over(const uint32_t *from)
{
    const volatile uint32_t *at = &board_stack_limit + 1;
    while (*at == PATTERN && at < from) {
        ++at;
    }
    return (uint32_t)(from - at) * 4u;
}

static void put_hex(const void *number, size_t bytes)
{
    char text[20];
    const uint8_t *byte = (const uint8_t *)number + bytes;
    size_t k = 0;
    text[k++] = ' ';
    for (size_t i = 0; i < bytes; ++i) {
        --byte;
        text[k++] = "0123456789abcdef"[*byte >> 4];
        text[k++] = "0123456789abcdef"[*byte & 15u];
    }
    text[k] = '\0';
    board_print(text);
}

static void put_word(uint32_t word)
{
    put_hex(&word, 4);
}
