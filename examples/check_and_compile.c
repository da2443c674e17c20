/* Checks a machine, prints its findings as JSON, and writes its image:
 *   check_and_compile INPUT IMAGE.axim
 * Exit status: 0, 1 for lists with errors, 2 where there is nothing to check. */
#include <axisc.h>
#include <stdio.h>

static int write_image(const char* path, const axisc_bytes* image) {
  FILE* file = fopen(path, "wb");
  size_t written = file != NULL ? fwrite(image->data, 1, image->size, file) : 0;
  if (file != NULL && fclose(file) == 0 && written == image->size) return 0;
  perror(path);
  return 2;
}

int main(int argc, char** argv) {
  axisc_workspace* workspace = NULL;
  axisc_bytes findings = {NULL, 0}, image = {NULL, 0};
  int result, status = 2;
  if (argc != 3) {
    fprintf(stderr, "usage: check_and_compile INPUT IMAGE.axim\n");
    return 2;
  }
  result = axisc_open("{\"language\": \"en\", \"cycle_time\": \"1ms\"}", NULL, &workspace);
  if (result == AXISC_OK) result = axisc_check(workspace, argv[1], &findings);
  if (result >= 0) printf("%s", findings.data);
  if (result == AXISC_OK) result = axisc_compile(workspace, argv[1], NULL, &image, NULL);
  if (result == AXISC_OK) status = write_image(argv[2], &image);
  if (result == AXISC_FINDINGS) status = 1;
  if (result < 0) fprintf(stderr, "%s", axisc_error(workspace));
  axisc_free(&findings);
  axisc_free(&image);
  axisc_close(workspace);
  return status;
}
