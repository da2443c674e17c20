/* An image from a file, at an address that the runtime accepts. A controller has its image in flash instead.
 */
#ifndef AXISRT_EXAMPLES_IMAGE_FILE_H
#define AXISRT_EXAMPLES_IMAGE_FILE_H

#include <stddef.h>

typedef struct image_file {
  void* bytes; /* to be given to free() */
  size_t size;
} image_file;

/* Prints why and returns 0 if the file cannot be read. */
int load_image_file(const char* path, image_file* file);

/* Memory at a multiple of AXISRT_ALIGNMENT, to be given to free(); null if there is none. */
void* aligned_memory(size_t size);

#endif
