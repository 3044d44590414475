// bench: +W320 +H240 -A; a turbulent cloud of emission and absorption
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.4, -4> look_at 0 angle 42 }
background { rgb <0.01, 0.012, 0.03> }
sphere { 0, 1.3 hollow pigment { rgbt 1 }
  interior { media { emission rgb <1.6, 0.9, 0.5> absorption rgb <0.3, 0.6, 1.1> method 3 intervals 1 samples 30, 30
    density { spherical turbulence 0.7 octaves 5 lambda 2.1 scale 1.25
      density_map { [0 rgb 0] [0.25 rgb <0.2, 0.1, 0.35>] [0.6 rgb <1, 0.5, 0.2>] [1 rgb 2] } }
    density { bozo turbulence 1 octaves 4 scale 0.5 color_map { [0.3 rgb 0.1] [0.7 rgb 1.4] } } } } }
