// Built-in functions §2: arity.
#version 3.7;
global_settings { assumed_gamma 1 }

//= f_algbr_cyl1 takes 8 arguments
#declare F = function { internal(0) } #declare G = function(A) { F(1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_algbr_cyl2 takes 8 arguments
#declare F = function { internal(1) } #declare G = function(A) { F(1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_algbr_cyl3 takes 8 arguments
#declare F = function { internal(2) } #declare G = function(A) { F(1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_algbr_cyl4 takes 8 arguments
#declare F = function { internal(3) } #declare G = function(A) { F(1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_bicorn takes 5 arguments
#declare F = function { internal(4) } #declare G = function(A) { F(1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_bifolia takes 5 arguments
#declare F = function { internal(5) } #declare G = function(A) { F(1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_blob takes 8 arguments
#declare F = function { internal(6) } #declare G = function(A) { F(1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_blob2 takes 7 arguments
#declare F = function { internal(7) } #declare G = function(A) { F(1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_boy_surface takes 5 arguments
#declare F = function { internal(8) } #declare G = function(A) { F(1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_comma takes 4 arguments
#declare F = function { internal(9) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_cross_ellipsoids takes 7 arguments
#declare F = function { internal(10) } #declare G = function(A) { F(1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_crossed_trough takes 4 arguments
#declare F = function { internal(11) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_cubic_saddle takes 4 arguments
#declare F = function { internal(12) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_cushion takes 4 arguments
#declare F = function { internal(13) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_devils_curve takes 4 arguments
#declare F = function { internal(14) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_devils_curve_2d takes 9 arguments
#declare F = function { internal(15) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_dupin_cyclid takes 9 arguments
#declare F = function { internal(16) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_ellipsoid takes 6 arguments
#declare F = function { internal(17) } #declare G = function(A) { F(1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_enneper takes 4 arguments
#declare F = function { internal(18) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_flange_cover takes 7 arguments
#declare F = function { internal(19) } #declare G = function(A) { F(1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_folium_surface takes 6 arguments
#declare F = function { internal(20) } #declare G = function(A) { F(1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_folium_surface_2d takes 9 arguments
#declare F = function { internal(21) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_glob takes 4 arguments
#declare F = function { internal(22) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_heart takes 4 arguments
#declare F = function { internal(23) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_helical_torus takes 13 arguments
#declare F = function { internal(24) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_helix1 takes 10 arguments
#declare F = function { internal(25) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_helix2 takes 10 arguments
#declare F = function { internal(26) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_hex_x takes 4 arguments
#declare F = function { internal(27) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_hex_y takes 4 arguments
#declare F = function { internal(28) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_hetero_mf takes 9 arguments
#declare F = function { internal(29) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_hunt_surface takes 4 arguments
#declare F = function { internal(30) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_hyperbolic_torus takes 6 arguments
#declare F = function { internal(31) } #declare G = function(A) { F(1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_isect_ellipsoids takes 7 arguments
#declare F = function { internal(32) } #declare G = function(A) { F(1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_kampyle_of_eudoxus takes 6 arguments
#declare F = function { internal(33) } #declare G = function(A) { F(1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_kampyle_of_eudoxus_2d takes 9 arguments
#declare F = function { internal(34) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_klein_bottle takes 4 arguments
#declare F = function { internal(35) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_kummer_surface_v1 takes 4 arguments
#declare F = function { internal(36) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_kummer_surface_v2 takes 7 arguments
#declare F = function { internal(37) } #declare G = function(A) { F(1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_lemniscate_of_gerono takes 4 arguments
#declare F = function { internal(38) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_lemniscate_of_gerono_2d takes 9 arguments
#declare F = function { internal(39) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_mesh1 takes 8 arguments
#declare F = function { internal(40) } #declare G = function(A) { F(1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_mitre takes 4 arguments
#declare F = function { internal(41) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_nodal_cubic takes 4 arguments
#declare F = function { internal(42) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_odd takes 4 arguments
#declare F = function { internal(43) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_ovals_of_cassini takes 7 arguments
#declare F = function { internal(44) } #declare G = function(A) { F(1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_paraboloid takes 4 arguments
#declare F = function { internal(45) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_parabolic_torus takes 6 arguments
#declare F = function { internal(46) } #declare G = function(A) { F(1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_ph takes 3 arguments
#declare F = function { internal(47) } #declare G = function(A) { F(1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_pillow takes 4 arguments
#declare F = function { internal(48) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_piriform takes 4 arguments
#declare F = function { internal(49) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_piriform_2d takes 10 arguments
#declare F = function { internal(50) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_poly4 takes 8 arguments
#declare F = function { internal(51) } #declare G = function(A) { F(1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_polytubes takes 9 arguments
#declare F = function { internal(52) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_quantum takes 4 arguments
#declare F = function { internal(53) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_quartic_paraboloid takes 4 arguments
#declare F = function { internal(54) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_quartic_saddle takes 4 arguments
#declare F = function { internal(55) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_quartic_cylinder takes 6 arguments
#declare F = function { internal(56) } #declare G = function(A) { F(1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_r takes 3 arguments
#declare F = function { internal(57) } #declare G = function(A) { F(1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_ridge takes 9 arguments
#declare F = function { internal(58) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_ridged_mf takes 9 arguments
#declare F = function { internal(59) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_rounded_box takes 7 arguments
#declare F = function { internal(60) } #declare G = function(A) { F(1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_sphere takes 4 arguments
#declare F = function { internal(61) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_spikes takes 8 arguments
#declare F = function { internal(62) } #declare G = function(A) { F(1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_spikes_2d takes 7 arguments
#declare F = function { internal(63) } #declare G = function(A) { F(1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_spiral takes 9 arguments
#declare F = function { internal(64) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_steiners_roman takes 4 arguments
#declare F = function { internal(65) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_strophoid takes 7 arguments
#declare F = function { internal(66) } #declare G = function(A) { F(1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_strophoid_2d takes 10 arguments
#declare F = function { internal(67) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_superellipsoid takes 5 arguments
#declare F = function { internal(68) } #declare G = function(A) { F(1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_th takes 3 arguments
#declare F = function { internal(69) } #declare G = function(A) { F(1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_torus takes 5 arguments
#declare F = function { internal(70) } #declare G = function(A) { F(1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_torus2 takes 6 arguments
#declare F = function { internal(71) } #declare G = function(A) { F(1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_torus_gumdrop takes 4 arguments
#declare F = function { internal(72) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_umbrella takes 4 arguments
#declare F = function { internal(73) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_witch_of_agnesi takes 5 arguments
#declare F = function { internal(74) } #declare G = function(A) { F(1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_witch_of_agnesi_2d takes 9 arguments
#declare F = function { internal(75) } #declare G = function(A) { F(1,1,1,1,1,1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1,1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_noise3d takes 3 arguments
#declare F = function { internal(76) } #declare G = function(A) { F(1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= f_noise_generator takes 4 arguments
#declare F = function { internal(78) } #declare G = function(A) { F(1,1,1,1) }
#debug concat("right", "\n")
#declare H = function(A) { F(1,1,1,1,1) }
// expect: right
// error: D0202 at 3:28

//= internal 77 takes three
#declare F = function { internal(77) }
#debug concat(str(F(1,2,3), 0, 6), "\n")
// expect: 0.000000

//= too few arguments
#declare F = function { internal(61) } #declare A = F(1,2,3);
// error: D0202 at 1:53

//= numbers of functions are truncated
#declare F = function { internal(57.5) }
#debug concat(str(F(1,2,2), 0, 6), "\n")
// expect: 3.000000
