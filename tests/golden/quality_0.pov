// golden: +W96 +H72 -A +Q0; psnr >= 60; pigments only, quick colours
#version 3.7;
#include "include/quality.inc"
