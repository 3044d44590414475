// bench: +W240 +H180 -A; a room lit through a window, light of two bounces
#version 3.7;
global_settings { assumed_gamma 1
  radiosity { count 200 nearest_count 8 error_bound 0.5 recursion_limit 2 pretrace_start 0.08 pretrace_end 0.02
    low_error_factor 0.6 brightness 1 } }
camera { location <-2.2, 1.6, -2.6> look_at <0.6, 1.1, 1> angle 68 }
light_source { <-2.9, 6, -9> rgb <2.4, 2.2, 1.9> }
difference {
  box { <-3, 0, -3>, <3, 3, 3> }
  box { <-2.9, 0.1, -2.9>, <2.9, 2.9, 2.9> pigment { rgb <0.9, 0.87, 0.82> } }
  box { <-2, 1, -4>, <1, 2.4, -2.5> }
  pigment { rgb <0.9, 0.87, 0.82> } }
box { <1.2, 0.1, 0.6>, <2, 1.3, 1.4> rotate y*12 pigment { rgb <0.75, 0.25, 0.18> } }
sphere { <-0.6, 0.7, 1>, 0.6 pigment { rgb <0.3, 0.45, 0.75> } }
cylinder { <0.5, 0.1, -0.4>, <0.5, 0.9, -0.4>, 0.3 pigment { rgb <0.35, 0.6, 0.3> } }
torus { 0.5, 0.12 translate <-0.6, 1.5, 1> pigment { rgb <0.8, 0.7, 0.3> } }
