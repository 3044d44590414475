// bench: +W1920 +H1440 -A; noise: turbulent marble over the whole picture
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y direction z }
light_source { <-8, 12, -20> rgb 1 }
plane {
  z, 0
  pigment {
    marble turbulence 0.9 octaves 8
    color_map { [0 rgb <0.9, 0.9, 0.85>] [0.4 rgb <0.7, 0.7, 0.75>] [0.8 rgb <0.2, 0.3, 0.4>] [1 rgb <0.1, 0.1, 0.2>] }
    rotate <20, 35, 10> scale 0.7
  }
}
