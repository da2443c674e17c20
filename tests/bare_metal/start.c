/* From reset to main on a Cortex-M7: floating-point unit on, data copied from flash, the rest zeroed. */
#include <stdint.h>
#include <stdlib.h>

extern uint32_t __stack_top;
extern uint32_t __data_begin;
extern uint32_t __data_end;
extern uint32_t __data_in_flash;
extern uint32_t __bss_begin;
extern uint32_t __bss_end;

extern void initialise_monitor_handles(void);
int main(void);
void reset_handler(void);
void fault_handler(void);
void _fini(void);

static void enable_floating_point(void) {
  volatile uint32_t* const coprocessor_access = (volatile uint32_t*)0xE000ED88u; /* CPACR */
  *coprocessor_access |= 0xFu << 20; /* CP10 and CP11: full access */
  __asm__ volatile("dsb\n isb" ::: "memory");
}

void reset_handler(void) {
  uint32_t const* from = &__data_in_flash;
  uint32_t* to = &__data_begin;
  enable_floating_point();
  while (to != &__data_end) *to++ = *from++;
  for (to = &__bss_begin; to != &__bss_end;) *to++ = 0;
  initialise_monitor_handles();
  exit(main());
}

/* exit() calls it; there is nothing to undo. */
void _fini(void) {}

/* Any exception is a failure of the test: leaves the emulator with status 1. */
void fault_handler(void) {
  abort();
}

typedef void (*vector)(void);

__attribute__((section(".vectors"), used)) static struct {
  uint32_t* stack;
  vector handlers[15];
} const vectors = {&__stack_top,
                   {reset_handler, fault_handler, fault_handler, fault_handler, fault_handler, fault_handler,
                    0, 0, 0, 0, fault_handler, fault_handler, 0, fault_handler, fault_handler}};
