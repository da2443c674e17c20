/* A controller that moves for images alone that the machine's maker has signed, and never goes back to an
 * older one.
 *
 *   signed_image IMAGE PUBLIC_KEY LOWEST_VERSION
 *
 * The maker: axisc keygen plant.key
 *
 *            axisc sign IMAGE --key plant.key
 *
 * The key is in the controller's read-only memory there, the lowest version where a restart does not lose
 * it. */
#include "axisrt.h"
#include "image_file.h"

#include <sodium.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { cycle_time_ns = 1000000 };

/* The runtime has no cryptography of its own: it hands over what is signed. 0: the signature is right. */
static int verify(void* context, const uint8_t* key_id, const void* image, size_t size,
                  const uint8_t* signature) {
  (void)key_id; /* tells several keys apart */
  return crypto_sign_verify_detached(signature, image, size, context);
}

/* The file that `axisc keygen` wrote: a word, and 32 bytes in hexadecimal. */
static int load_key(const char* path, unsigned char key[crypto_sign_PUBLICKEYBYTES]) {
  char text[2 * crypto_sign_PUBLICKEYBYTES + 1] = "";
  size_t size = 0;
  FILE* const file = fopen(path, "r");
  if (file == NULL) return 0;
  if (fscanf(file, "axisc-public-key-1 %64s", text) != 1) text[0] = 0;
  fclose(file);
  return sodium_hex2bin(key, crypto_sign_PUBLICKEYBYTES, text, strlen(text), NULL, &size, NULL) == 0 &&
         size == crypto_sign_PUBLICKEYBYTES;
}

int main(int argc, char* argv[]) {
  unsigned char key[crypto_sign_PUBLICKEYBYTES];
  image_file image = {NULL, 0};
  axisrt_config config = {0};
  axisrt* runtime = NULL;
  size_t alignment = 0;
  axisrt_status status = AXISRT_OK;
  if (argc != 4 || sodium_init() < 0 || !load_image_file(argv[1], &image) || !load_key(argv[2], key))
    return 2;
  config.size = sizeof config;
  config.cycle_time_ns = cycle_time_ns;
  config.image = image.bytes;
  config.image_size = image.size;
  config.verify_signature = verify; /* with it an image without a signature is refused, too */
  config.verify_context = key;
  status = axisrt_memory_size(&config, &config.memory_size, &alignment);
  if (status == AXISRT_OK) config.memory = aligned_memory(config.memory_size);
  if (status == AXISRT_OK) status = axisrt_create(&config, &runtime);
  /* Right, but perhaps an old one that somebody put back. */
  if (status == AXISRT_OK && axisrt_image_version(runtime) < strtoul(argv[3], NULL, 10))
    status = AXISRT_OLDER_IMAGE;
  printf("%s: %s\n", axisrt_status_name(status), axisrt_status_text(status));
  free(config.memory);
  free(image.bytes);
  return status == AXISRT_OK ? 0 : 1;
}
