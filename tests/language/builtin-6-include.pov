// Built-in functions §6: what functions.inc declares beside the internal functions.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"

//= f_snoise3d
#debug concat(str(f_snoise3d(0.3,1.7,-2.2), 0, 9), " ", str(f_snoise3d(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.057702956 -0.142679358

//= f_agate
#debug concat(str(f_agate(0.3,1.7,-2.2), 0, 9), " ", str(f_agate(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.729962908 0.124299898

//= f_boxed
#debug concat(str(f_boxed(0.3,1.7,-2.2), 0, 9), " ", str(f_boxed(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.000000000 0.670000000

//= f_bozo
#debug concat(str(f_bozo(0.3,1.7,-2.2), 0, 9), " ", str(f_bozo(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.528851478 0.428660321

//= f_bumps
#debug concat(str(f_bumps(0.3,1.7,-2.2), 0, 9), " ", str(f_bumps(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.528851478 0.428660321

//= f_spotted
#debug concat(str(f_spotted(0.3,1.7,-2.2), 0, 9), " ", str(f_spotted(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.528851478 0.428660321

//= f_brick
#debug concat(str(f_brick(0.3,1.7,-2.2), 0, 9), " ", str(f_brick(0.11,0.22,0.33), 0, 9), "\n")
// expect: 1.000000000 1.000000000

//= f_checker
#debug concat(str(f_checker(0.3,1.7,-2.2), 0, 9), " ", str(f_checker(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.000000000 0.000000000

//= f_crackle
#debug concat(str(f_crackle(0.3,1.7,-2.2), 0, 9), " ", str(f_crackle(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.105890465 0.079245808

//= f_cylindrical
#debug concat(str(f_cylindrical(0.3,1.7,-2.2), 0, 9), " ", str(f_cylindrical(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.000000000 0.652149457

//= f_dents
#debug concat(str(f_dents(0.3,1.7,-2.2), 0, 9), " ", str(f_dents(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.147911236 0.078766193

//= f_gradientX
#debug concat(str(f_gradientX(0.3,1.7,-2.2), 0, 9), " ", str(f_gradientX(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.300000000 0.110000000

//= f_gradientY
#debug concat(str(f_gradientY(0.3,1.7,-2.2), 0, 9), " ", str(f_gradientY(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.700000000 0.220000000

//= f_gradientZ
#debug concat(str(f_gradientZ(0.3,1.7,-2.2), 0, 9), " ", str(f_gradientZ(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.800020000 0.330000000

//= f_granite
#debug concat(str(f_granite(0.3,1.7,-2.2), 0, 9), " ", str(f_granite(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.266961562 0.537483316

//= f_leopard
#debug concat(str(f_leopard(0.3,1.7,-2.2), 0, 9), " ", str(f_leopard(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.025460310 0.047241160

//= f_mandel
#debug concat(str(f_mandel(0.3,1.7,-2.2), 0, 9), " ", str(f_mandel(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.000000000 1.000000000

//= f_marble
#debug concat(str(f_marble(0.3,1.7,-2.2), 0, 9), " ", str(f_marble(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.600000000 0.220000000

//= f_onion
#debug concat(str(f_onion(0.3,1.7,-2.2), 0, 9), " ", str(f_onion(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.796426291 0.411582313

//= f_planar
#debug concat(str(f_planar(0.3,1.7,-2.2), 0, 9), " ", str(f_planar(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.000000000 0.780000000

//= f_radial
#debug concat(str(f_radial(0.3,1.7,-2.2), 0, 9), " ", str(f_radial(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.228420094 0.801208191

//= f_ripples
#debug concat(str(f_ripples(0.3,1.7,-2.2), 0, 9), " ", str(f_ripples(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.547867806 0.671721636

//= f_spherical
#debug concat(str(f_spherical(0.3,1.7,-2.2), 0, 9), " ", str(f_spherical(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.000000000 0.588417687

//= f_spiral1
#debug concat(str(f_spiral1(0.3,1.7,-2.2), 0, 9), " ", str(f_spiral1(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.941335525 0.856747720

//= f_spiral2
#debug concat(str(f_spiral2(0.3,1.7,-2.2), 0, 9), " ", str(f_spiral2(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.977580449 0.697385350

//= f_waves
#debug concat(str(f_waves(0.3,1.7,-2.2), 0, 9), " ", str(f_waves(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.653609206 0.769910122

//= f_wood
#debug concat(str(f_wood(0.3,1.7,-2.2), 0, 9), " ", str(f_wood(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.547484700 0.491934955

//= f_wrinkles
#debug concat(str(f_wrinkles(0.3,1.7,-2.2), 0, 9), " ", str(f_wrinkles(0.11,0.22,0.33), 0, 9), "\n")
// expect: 0.574601317 0.510015017

//= f_hexagon
#debug concat(vstr(5, f_hexagon(0.3,1.7,-2.2), ",", 0, 3), " ", vstr(5, f_hexagon(0.11,0.22,0.33), ",", 0, 3), "\n")
// expect: 1.000,1.000,1.000,0.000,0.000 0.000,0.000,0.000,0.000,0.000

//= f_sine_wave
#debug concat(str(f_sine_wave(0.3,1.7,2.2), 0, 9), "\n")
// expect: 1.489721356

//= f_scallop_wave
#debug concat(str(f_scallop_wave(0.3,1.7,2.2), 0, 9), " ", str(f_scallop_wave(1.3,-1.7,2.2), 0, 9), "\n")
// expect: 1.489721356 0.723824796

//= eval_pigment
#declare P = pigment { gradient x color_map { [0 rgb 0] [1 rgb <1,0.5,0.25>] } } #debug concat(vstr(5, eval_pigment(P, <0.5,0,0>), ",", 0, 6), "\n")
// expect: 0.500000,0.250000,0.125000,0.000000,0.000000

//= read once
#include "functions.inc" #debug concat(str(f_r(1,2,2), 0, 3), str(version, 0, 2), "\n")
// expect: 3.0003.70

//= declared names stay
#declare f_r = function { x }
// error: D0204 at 1:10

//= @ by its name
#debug concat(str(defined(@), 0, 0), "\n")
// each: f_algbr_cyl1 f_algbr_cyl2 f_algbr_cyl3 f_algbr_cyl4 f_bicorn f_bifolia f_blob f_blob2 f_boy_surface f_comma f_cross_ellipsoids f_crossed_trough f_cubic_saddle f_cushion f_devils_curve f_devils_curve_2d
// each: f_dupin_cyclid f_ellipsoid f_enneper f_flange_cover f_folium_surface f_folium_surface_2d f_glob f_heart f_helical_torus f_helix1 f_helix2 f_hex_x f_hex_y f_hetero_mf f_hunt_surface f_hyperbolic_torus f_isect_ellipsoids
// each: f_kampyle_of_eudoxus f_kampyle_of_eudoxus_2d f_klein_bottle f_kummer_surface_v1 f_kummer_surface_v2 f_lemniscate_of_gerono f_lemniscate_of_gerono_2d f_mesh1 f_mitre f_nodal_cubic f_odd f_ovals_of_cassini f_paraboloid
// each: f_parabolic_torus f_ph f_pillow f_piriform f_piriform_2d f_poly4 f_polytubes f_quantum f_quartic_paraboloid f_quartic_saddle f_quartic_cylinder f_r f_ridge f_ridged_mf f_rounded_box f_sphere f_spikes f_spikes_2d f_spiral
// each: f_steiners_roman f_strophoid f_strophoid_2d f_superellipsoid f_th f_torus f_torus2 f_torus_gumdrop f_umbrella f_witch_of_agnesi f_witch_of_agnesi_2d f_noise3d f_noise_generator
// expect: 1
