#include "image_file.h"

#include "axisrt.h"

#include <stdio.h>
#include <stdlib.h>

void* aligned_memory(size_t size) {
  /* aligned_alloc wants whole multiples. */
  return aligned_alloc(AXISRT_ALIGNMENT, (size + AXISRT_ALIGNMENT - 1) / AXISRT_ALIGNMENT * AXISRT_ALIGNMENT);
}

static int read_all(FILE* stream, image_file* file) {
  long size = 0;
  if (fseek(stream, 0, SEEK_END) != 0) return 0;
  size = ftell(stream);
  if (size <= 0 || fseek(stream, 0, SEEK_SET) != 0) return 0;
  file->size = (size_t)size;
  file->bytes = aligned_memory(file->size);
  return file->bytes != NULL && fread(file->bytes, 1, file->size, stream) == file->size;
}

int load_image_file(const char* path, image_file* file) {
  FILE* const stream = fopen(path, "rb");
  int good = 0;
  file->bytes = NULL;
  file->size = 0;
  if (stream != NULL) {
    good = read_all(stream, file);
    fclose(stream);
  }
  if (!good) fprintf(stderr, "%s cannot be read\n", path);
  return good;
}
