/* Holds a file open as programs do that share it with nobody: hold_open FILE MILLISECONDS */
#include <stdlib.h>
#include <windows.h>

int main(int argc, char* argv[]) {
  HANDLE file = INVALID_HANDLE_VALUE;
  if (argc != 3) return 2;
  file = CreateFileA(argv[1], GENERIC_READ, 0, NULL, OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, NULL);
  if (file == INVALID_HANDLE_VALUE) return 1;
  Sleep((DWORD)atoi(argv[2]));
  return CloseHandle(file) ? 0 : 1;
}
