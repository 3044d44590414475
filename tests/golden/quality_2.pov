// golden: +W96 +H72 -A +Q2; psnr >= 60; light without shadows
#version 3.7;
#include "include/quality.inc"
