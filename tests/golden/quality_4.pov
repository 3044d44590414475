// golden: +W96 +H72 -A +Q4; psnr >= 60; shadows
#version 3.7;
#include "include/quality.inc"
