/* Images in flash, as the compiler wrote them, aligned as the runtime demands. */
  .section .images, "a"
  .balign 64
  .global image_complete
image_complete:
  .incbin "mill.axim"
  .global image_complete_end
image_complete_end:
  .balign 64
  .global image_stripped
image_stripped:
  .incbin "mill-stripped.axim"
  .global image_stripped_end
image_stripped_end:
