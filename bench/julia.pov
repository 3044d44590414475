// bench: +W2400 +H1800 -A; a Julia set of quaternions
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <-8, 12, -10> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
camera { location <0, 0.5, -4> look_at 0 angle 40 }
julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 12 precision 60 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.5 } }
