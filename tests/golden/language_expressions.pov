// golden: +W96 +H72 -A; psnr >= 50; the same objects must come out, so only last-bit rounding may differ
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0.013, 0.007, -10> look_at <0.013, 0.007, 0> right 8*x up 6*y }  // off the grid: no pixel on an edge
light_source { <-6, 8, -12> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
#default { finish { ambient 0.25 } }
// Bars as long as the values of operators and float functions.
#declare N = 0;
#macro Bar(V)
  box { <-3.8 + 2.6*div(N, 12), 2.7 - 0.46*mod(N, 12), 0>, <-3.8 + 2.6*div(N, 12) + 0.05 + V, 2.7 - 0.46*mod(N, 12) - 0.35, 1> pigment { rgb <0.9 - div(N, 12)*0.3, 0.5, 0.2 + mod(N, 12)/15> } }
  #declare N = N + 1;
#end
Bar(1 + 2*3/8 - 0.5) Bar(-(-1.2)) Bar((2 > 1) + (1 = 2)) Bar((3 > 2 ? 0.7 : 1.9)) Bar(abs(-0.9)) Bar(sqrt(2)) Bar(pow(2, 0.5) - 0.5) Bar(exp(0.4)) Bar(ln(5)) Bar(log(30)) Bar(sin(1)) Bar(cos(0.5))
Bar(atan2(1, 0.5)) Bar(floor(1.7)) Bar(ceil(1.2)) Bar(int(-1.5) + 2) Bar(mod(7.3, 2)) Bar(div(9, 5)) Bar(min(1.2, 0.4, 0.9)) Bar(max(0.3, 1.6)) Bar(degrees(0.02)) Bar(radians(60)) Bar(tan(0.8)) Bar(asin(0.9))
Bar(vlength(<1, 0.5, 0.2>)) Bar(vdot(<1, 2, 0>, <0.3, 0.4, 5>)) Bar(vcross(x, y).z) Bar(vrotate(x, 30*z).y) Bar(vaxis_rotate(<1, 0, 0>, y + x, 70).x) Bar(vnormalize(<3, 4, 0>).y*2) Bar((<1, 2, 3>*<0.2, 0.1, 0.3>).z) Bar(select(-1, 0.2, 0.8, 1.5) + 0.4) Bar(asc("A")/60) Bar(val("1.25")) Bar(strlen("twelve letters")/10) Bar(sinh(0.7))
