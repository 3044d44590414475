// golden: +W96 +H72 -A +Q5; psnr >= 60; quick colours, nothing behind surfaces
#version 3.7;
#include "include/quality.inc"
