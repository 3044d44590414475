// golden: +W96 +H72 -A +Q6; psnr >= 60; transparency, no reflection and bumps
#version 3.7;
#include "include/quality.inc"
