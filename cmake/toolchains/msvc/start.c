/* What a DLL without the C library needs: an entry, the mark of floating-point numbers, memory functions, and
 * the probe of the stack that MSVC's ABI wants for frames above 4 KiB. */
#include <stddef.h>

int _fltused = 0x9875;

int DllMain(void* module, unsigned long reason, void* reserved) {
  (void)module, (void)reason, (void)reserved;
  return 1;
}

void* memcpy(void* to, void const* from, size_t size) {
  unsigned char volatile* out = to;
  unsigned char const* in = from;
  while (size-- > 0) *out++ = *in++;
  return to;
}

void* memmove(void* to, void const* from, size_t size) {
  unsigned char volatile* out = to;
  unsigned char const* in = from;
  if ((size_t)to - (size_t)from >= size) return memcpy(to, from, size);
  while (size-- > 0) out[size] = in[size];
  return to;
}

void* memset(void* to, int value, size_t size) {
  unsigned char volatile* out = to;
  while (size-- > 0) *out++ = (unsigned char)value;
  return to;
}

int memcmp(void const* a, void const* b, size_t size) {
  unsigned char const* one = a;
  unsigned char const* other = b;
  for (; size > 0; --size, ++one, ++other) {
    if (*one != *other) return *one < *other ? -1 : 1;
  }
  return 0;
}

__asm__(
    ".globl __chkstk\n"
    "__chkstk:\n"
    "  push %rcx\n"
    "  push %rax\n"
    "  lea 24(%rsp), %rcx\n"
    "1: cmp $0x1000, %rax\n"
    "  jb 2f\n"
    "  sub $0x1000, %rcx\n"
    "  test %rcx, (%rcx)\n"
    "  sub $0x1000, %rax\n"
    "  jmp 1b\n"
    "2: sub %rax, %rcx\n"
    "  test %rcx, (%rcx)\n"
    "  pop %rax\n"
    "  pop %rcx\n"
    "  ret\n");
