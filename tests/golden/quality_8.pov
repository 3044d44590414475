// golden: +W96 +H72 -A +Q8; psnr >= 60; all but media
#version 3.7;
#include "include/quality.inc"
