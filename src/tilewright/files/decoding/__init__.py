"""From the bytes of an image file to pixels, and to what the file states of them."""
