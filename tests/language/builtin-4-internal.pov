// Built-in functions §4: the internal functions, by index, at the points and parameters of §9.
#version 3.7;
global_settings { assumed_gamma 1 }

//= f_algbr_cyl1
#declare F = function { internal(0) }
#debug concat(str(F(0.3,-0.7,1.1, 0.7, 3, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.7, 3, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 0.7, 3, 1, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.7, 3, 1, 0.3, 20), 0, 9), "\n")
// expect: 0.298900000
// expect: 0.385437500
// expect: 0.117484218
// expect: 0.327755360

//= f_algbr_cyl2
#declare F = function { internal(1) }
#debug concat(str(F(0.3,-0.7,1.1, 0.7, 3, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.7, 3, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 0.7, 3, 1, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.7, 3, 1, 0.3, 20), 0, 9), "\n")
// expect: -1.134910000
// expect: -2.145788750
// expect: -2.573054789
// expect: 0.346576994

//= f_algbr_cyl3
#declare F = function { internal(2) }
#debug concat(str(F(0.3,-0.7,1.1, 0.7, 3, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.7, 3, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 0.7, 3, 1, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.7, 3, 1, 0.3, 20), 0, 9), "\n")
// expect: -0.364840000
// expect: -1.260984375
// expect: -1.432498639
// expect: 0.039220285

//= f_algbr_cyl4
#declare F = function { internal(3) }
#debug concat(str(F(0.3,-0.7,1.1, 0.7, 3, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.7, 3, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 0.7, 3, 1, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.7, 3, 1, 0.3, 20), 0, 9), "\n")
// expect: -0.343280000
// expect: -3.000000000
// expect: -0.213151149
// expect: -2.192894716

//= f_bicorn
#declare F = function { internal(4) }
#debug concat(str(F(0.3,-0.7,1.1, 0.5, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.5, 1), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 2, 1.3), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 2, 1.3), 0, 9), "\n")
// expect: -0.678500000
// expect: -1.557303125
// expect: -9.386000000
// expect: -3.312912500

//= f_bifolia
#declare F = function { internal(5) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 3), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 3), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 0.3, 2), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.3, 2), 0, 9), "\n")
// expect: -5.934100000
// expect: -2.029806250
// expect: -1.507230000
// expect: -0.839641875

//= f_blob
#declare F = function { internal(6) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 1.2, 0.8, 1.5, 0.9), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 1.2, 0.8, 1.5, 0.9), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 2, 1, 0.5, 1, 0.4), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 2, 1, 0.5, 1, 0.4), 0, 9), "\n")
// expect: -0.000000000
// expect: -0.113246208
// expect: -0.445236410
// expect: -0.741362881

//= f_blob2
#declare F = function { internal(7) }
#debug concat(str(F(0.3,-0.7,1.1, 1.2, 0.8, 1.1, 0.3), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1.2, 0.8, 1.1, 0.3), 0, 9), "\n")
// expect: -0.110396473
// expect: 0.086138312

//= f_boy_surface
#declare F = function { internal(8) }
#debug concat(str(F(0.3,-0.7,1.1, 0.001, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.001, 1), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 0.0005, 1.5), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.0005, 1.5), 0, 9), "\n")
// expect: -0.384739787
// expect: -6.023402053
// expect: -0.288554840
// expect: -4.517551539

//= f_comma
#declare F = function { internal(9) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 2.5), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 2.5), 0, 9), "\n")
// expect: 0.451318517
// expect: 0.466298571
// expect: -0.167765930
// expect: 0.807663623

//= f_cross_ellipsoids
#declare F = function { internal(10) }
#debug concat(str(F(0.3,-0.7,1.1, 0.3, 1.1, 1.3, 0.6), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.3, 1.1, 1.3, 0.6), 0, 9), "\n")
// expect: -0.071906735
// expect: 0.021930246

//= f_crossed_trough
#declare F = function { internal(11) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: 0.808900000
// expect: 0.162500000

//= f_cubic_saddle
#declare F = function { internal(12) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, -2), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, -2), 0, 9), "\n")
// expect: 0.730000000
// expect: 2.617125000
// expect: -1.460000000
// expect: -5.234250000

//= f_cushion
#declare F = function { internal(13) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: -0.384500000
// expect: -0.965206250

//= f_devils_curve
#declare F = function { internal(14) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: -1.540000000
// expect: -3.147906250

//= f_devils_curve_2d
#declare F = function { internal(15) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 1.2, 0.7, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 1.2, 0.7, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 1, 1.2, 0.7, 1, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 1.2, 0.7, 1, 0.3, 20), 0, 9), "\n")
// expect: 0.121500000
// expect: -0.244206250
// expect: 0.355289486
// expect: 0.552992507

//= f_dupin_cyclid
#declare F = function { internal(16) }
#debug concat(str(F(0.3,-0.7,1.1, 0.0001, 3, 1, 0.5, 0.3, 4), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.0001, 3, 1, 0.5, 0.3, 4), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 0.001, 1.5, 0.5, 1, 0.2, 2), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.001, 1.5, 0.5, 1, 0.2, 2), 0, 9), "\n")
// expect: -6.236111202
// expect: -6.482619808
// expect: -0.213078815
// expect: -0.511672948

//= f_ellipsoid
#declare F = function { internal(17) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 2, 0.5), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 2, 0.5), 0, 9), "\n")
// expect: 1.533786165
// expect: 1.514100393

//= f_enneper
#declare F = function { internal(18) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: -0.041968444
// expect: 3.339543576

//= f_flange_cover
#declare F = function { internal(19) }
#debug concat(str(F(0.3,-0.7,1.1, 0.3, 1.1, 1.3, 0.6), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.3, 1.1, 1.3, 0.6), 0, 9), "\n")
// expect: -0.849345177
// expect: -0.669957407

//= f_folium_surface
#declare F = function { internal(20) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.4, 0.8), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.4, 0.8), 0, 9), "\n")
// expect: 1.454000000
// expect: 3.852500000

//= f_folium_surface_2d
#declare F = function { internal(21) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.4, 0.8, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.4, 0.8, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.4, 0.8, 1, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.4, 0.8, 1, 0.3, 20), 0, 9), "\n")
// expect: -0.534400000
// expect: -3.132500000
// expect: -1.929888865
// expect: -1.570791783

//= f_glob
#declare F = function { internal(22) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: -1.694735000
// expect: -0.825175781

//= f_heart
#declare F = function { internal(23) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: -0.017303000
// expect: -10.000000000

//= f_helical_torus
#declare F = function { internal(24) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 6, 2, 0.2, 0.3, 0.5, 1.5, 4, 0.2, 0.3), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 6, 2, 0.2, 0.3, 0.5, 1.5, 4, 0.2, 0.3), 0, 9), "\n")
// expect: 1.014130897
// expect: 0.560455023

//= f_helix1
#declare F = function { internal(25) }
#debug concat(str(F(0.3,-0.7,1.1, 2, 4, 0.2, 0.8, 1, 1, 0), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 2, 4, 0.2, 0.8, 1, 1, 0), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 1, 3, 0.2, 0.6, 1.5, 0.5, 30), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 3, 0.2, 0.6, 1.5, 0.5, 30), 0, 9), "\n")
// expect: 0.140696467
// expect: 0.395792618
// expect: 0.522823393
// expect: 0.478019304

//= f_helix2
#declare F = function { internal(26) }
#debug concat(str(F(0.3,-0.7,1.1, 0, 4, 0.2, 0.1, 0, 1, 0), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0, 4, 0.2, 0.1, 0, 1, 0), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 0, 3, 0.3, 0.2, 0, 0.5, 40), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0, 3, 0.3, 0.2, 0, 0.5, 40), 0, 9), "\n")
// expect: 1.000096135
// expect: 1.143596400
// expect: 1.001859140
// expect: 1.082470811

//= f_hex_x
#declare F = function { internal(27) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: 0.756217783
// expect: 0.587435565

//= f_hex_y
#declare F = function { internal(28) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: 0.090192379
// expect: 0.217468245

//= f_hetero_mf
#declare F = function { internal(29) }
#debug concat(str(F(0.3,-0.7,1.1, 0.5, 2, 4.5, 0.7, 1, 2), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.5, 2, 4.5, 0.7, 1, 2), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 0.1, 3, 7, 0.7, 0.7, 3), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.1, 3, 7, 0.7, 0.7, 3), 0, 9), "\n")
// expect: 1.649067781
// expect: 1.709349601
// expect: 4.975983274
// expect: 4.080654510

//= f_hunt_surface
#declare F = function { internal(30) }
#debug concat(str(F(0.3,-0.7,1.1, 0.001), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.001), 0, 9), "\n")
// expect: -1.346514556
// expect: 3.211667660

//= f_hyperbolic_torus
#declare F = function { internal(31) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.6, 0.3), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.6, 0.3), 0, 9), "\n")
// expect: -1.742400000
// expect: -0.933456250

//= f_isect_ellipsoids
#declare F = function { internal(32) }
#debug concat(str(F(0.3,-0.7,1.1, 0.3, 1.1, 1.3, 0.6), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.3, 1.1, 1.3, 0.6), 0, 9), "\n")
// expect: 0.316356110
// expect: 0.403675374

//= f_kampyle_of_eudoxus
#declare F = function { internal(33) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.3, 0.8), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.3, 0.8), 0, 9), "\n")
// expect: -1.700000000
// expect: 0.952500000

//= f_kampyle_of_eudoxus_2d
#declare F = function { internal(34) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.3, 0.8, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.3, 0.8, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.3, 0.8, 1, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.3, 0.8, 1, 0.3, 20), 0, 9), "\n")
// expect: -0.498640000
// expect: 1.162500000
// expect: 0.417481533
// expect: -0.287640274

//= f_klein_bottle
#declare F = function { internal(35) }
#debug concat(str(F(0.3,-0.7,1.1, 0.1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.1), 0, 9), "\n")
// expect: -1.454237900
// expect: 0.866136473

//= f_kummer_surface_v1
#declare F = function { internal(36) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: -0.176400000
// expect: -0.644006250

//= f_kummer_surface_v2
#declare F = function { internal(37) }
#debug concat(str(F(0.3,-0.7,1.1, 1, -0.7, -0.9, 0.4), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, -0.7, -0.9, 0.4), 0, 9), "\n")
// expect: 1.304410000
// expect: 0.764233750

//= f_lemniscate_of_gerono
#declare F = function { internal(38) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: -1.618100000
// expect: -1.398906250

//= f_lemniscate_of_gerono_2d
#declare F = function { internal(39) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 1.2, 0.6, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 1.2, 0.6, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 1, 1.2, 0.6, 1, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 1.2, 0.6, 1, 0.3, 20), 0, 9), "\n")
// expect: -0.446260000
// expect: -0.228906250
// expect: 0.008114179
// expect: -0.373502929

//= f_mesh1
#declare F = function { internal(40) }
#debug concat(str(F(0.3,-0.7,1.1, 0.5, 0.6, 1, 0.2, 1.1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.5, 0.6, 1, 0.2, 1.1), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 0.15, 0.15, 1, 0.02, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.15, 0.15, 1, 0.02, 1), 0, 9), "\n")
// expect: 0.652526316
// expect: 0.333016516
// expect: 0.681835757
// expect: 0.390000000

//= f_mitre
#declare F = function { internal(41) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: -0.987400000
// expect: -10.000000000

//= f_nodal_cubic
#declare F = function { internal(42) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: -5.608000000
// expect: 1.160000000

//= f_odd
#declare F = function { internal(43) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: -0.384500000
// expect: -0.965206250

//= f_ovals_of_cassini
#declare F = function { internal(44) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.6, 0.4, 3), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.6, 0.4, 3), 0, 9), "\n")
// expect: -3.058500000
// expect: -3.729506250

//= f_paraboloid
#declare F = function { internal(45) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: -2.000000000
// expect: -1.522500000

//= f_parabolic_torus
#declare F = function { internal(46) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.6, 0.3), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.6, 0.3), 0, 9), "\n")
// expect: -0.930100000
// expect: -0.942981250

//= f_ph
#declare F = function { internal(47) }
#debug concat(str(F(0.3,-0.7,1.1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6), 0, 9), "\n")
// expect: 2.121403268
// expect: 1.289934747

//= f_pillow
#declare F = function { internal(48) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: -0.077700000
// expect: 0.514106250

//= f_piriform
#declare F = function { internal(49) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: 1.681100000
// expect: 4.914531250

//= f_piriform_2d
#declare F = function { internal(50) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 1.1, -0.8, 0.9, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 1.1, -0.8, 0.9, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 1, 1.1, -0.8, 0.9, 1, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 1.1, -0.8, 0.9, 1, 0.3, 20), 0, 9), "\n")
// expect: -0.471191800
// expect: -3.482265625
// expect: 0.107067903
// expect: -0.338896267

//= f_poly4
#declare F = function { internal(51) }
#debug concat(str(F(0.3,-0.7,1.1, 0.2, 0.1, 0.3, -0.2, 0.05), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.2, 0.1, 0.3, -0.2, 0.05), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, -9, 1, 0, 0, 0), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, -9, 1, 0, 0, 0), 0, 9), "\n")
// expect: 0.782570425
// expect: 1.110062462
// expect: 6.140175425
// expect: 6.386542462

//= f_polytubes
#declare F = function { internal(52) }
#debug concat(str(F(0.3,-0.7,1.1, 5, 0.2, 0.1, 0.3, -0.2, 0.05), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 5, 0.2, 0.1, 0.3, -0.2, 0.05), 0, 9), "\n")
// expect: 0.800718637
// expect: 1.113124658

//= f_quantum
#declare F = function { internal(53) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: 1.172477277
// expect: 0.600094113

//= f_quartic_paraboloid
#declare F = function { internal(54) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: -2.172200000
// expect: -2.171006250

//= f_quartic_saddle
#declare F = function { internal(55) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: 0.756000000
// expect: -1.911806250

//= f_quartic_cylinder
#declare F = function { internal(56) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.9, 0.5), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.9, 0.5), 0, 9), "\n")
// expect: -0.759500000
// expect: -0.585725000

//= f_r
#declare F = function { internal(57) }
#debug concat(str(F(0.3,-0.7,1.1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6), 0, 9), "\n")
// expect: 1.337908816
// expect: 1.443086969

//= f_ridge
#declare F = function { internal(58) }
#debug concat(str(F(0.3,-0.7,1.1, 2, 4, 0.5, 0.3, 0.6, 2), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 2, 4, 0.5, 0.3, 0.6, 2), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 2.2, 4.6, 0.6, 0.7, 0.4, 3), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 2.2, 4.6, 0.6, 0.7, 0.4, 3), 0, 9), "\n")
// expect: -0.103101762
// expect: -0.049833663
// expect: -0.730527787
// expect: -0.780201908

//= f_ridged_mf
#declare F = function { internal(59) }
#debug concat(str(F(0.3,-0.7,1.1, 1.1, 2.1, 7, 0.7, 0.8, 2), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1.1, 2.1, 7, 0.7, 0.8, 2), 0, 9), "\n")
// expect: 0.391745583
// expect: 0.273337069

//= f_rounded_box
#declare F = function { internal(60) }
#debug concat(str(F(0.3,-0.7,1.1, 0.2, 0.8, 0.7, 0.6), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.2, 0.8, 0.7, 0.6), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 0, 0.5, 0.5, 0.5), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0, 0.5, 0.5, 0.5), 0, 9), "\n")
// expect: 0.528009989
// expect: 0.480072525
// expect: 0.632454532
// expect: 0.756636298

//= f_sphere
#declare F = function { internal(61) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: 0.337908816
// expect: 0.443086969

//= f_spikes
#declare F = function { internal(62) }
#debug concat(str(F(0.3,-0.7,1.1, 0.1, 1.2, 1.3, 0.8, 0.9), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.1, 1.2, 1.3, 0.8, 0.9), 0, 9), "\n")
// expect: 1.573786920
// expect: 1.504399256

//= f_spikes_2d
#declare F = function { internal(63) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 4, 5, 0.6), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 4, 5, 0.6), 0, 9), "\n")
// expect: -0.817714991
// expect: 0.488608353

//= f_spiral
#declare F = function { internal(64) }
#debug concat(str(F(0.3,-0.7,1.1, 0.3, 0.1, 1.4, 0, 0, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.3, 0.1, 1.4, 0, 0, 1), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 0.4, 0.1, 1.5, 0, 0, 0.5), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.4, 0.1, 1.5, 0, 0, 0.5), 0, 9), "\n")
// expect: 0.615379073
// expect: 0.322111113
// expect: 0.600710665
// expect: 0.302415644

//= f_steiners_roman
#declare F = function { internal(65) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: -0.514900000
// expect: -0.570100000

//= f_strophoid
#declare F = function { internal(66) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.8, 0.4, 0.9), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.8, 0.4, 0.9), 0, 9), "\n")
// expect: -0.089810000
// expect: -1.427531250

//= f_strophoid_2d
#declare F = function { internal(67) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.8, 0.4, 0.9, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.8, 0.4, 0.9, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.8, 0.4, 0.9, 1, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.8, 0.4, 0.9, 1, 0.3, 20), 0, 9), "\n")
// expect: 0.031190000
// expect: -0.833531250
// expect: 1.654651285
// expect: 1.337121878

//= f_superellipsoid
#declare F = function { internal(68) }
#debug concat(str(F(0.3,-0.7,1.1, 0.3, 0.6), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.3, 0.6), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 1), 0, 9), "\n")
// expect: -0.168205449
// expect: -0.281621861
// expect: -0.337908816
// expect: -0.443086969

//= f_th
#declare F = function { internal(69) }
#debug concat(str(F(0.3,-0.7,1.1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6), 0, 9), "\n")
// expect: 0.266252049
// expect: -1.123276352

//= f_torus
#declare F = function { internal(70) }
#debug concat(str(F(0.3,-0.7,1.1, 0.9, 0.3), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.9, 0.3), 0, 9), "\n")
// expect: 0.440056913
// expect: 0.329859959

//= f_torus2
#declare F = function { internal(71) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.9, 0.3), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.9, 0.3), 0, 9), "\n")
// expect: -2.088100000
// expect: -1.625106250

//= f_torus_gumdrop
#declare F = function { internal(72) }
#debug concat(str(F(0.3,-0.7,1.1, 0.1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 0.1), 0, 9), "\n")
// expect: 0.460660000
// expect: -0.000972500

//= f_umbrella
#declare F = function { internal(73) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
// expect: -0.937000000
// expect: -1.418500000

//= f_witch_of_agnesi
#declare F = function { internal(74) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.4), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.4), 0, 9), "\n")
// expect: 1.590000000
// expect: -0.529000000

//= f_witch_of_agnesi_2d
#declare F = function { internal(75) }
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.4, 0.6, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.4, 0.6, 0, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 1, 0.4, 0.6, 1, 0.3, 20), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1, 0.4, 0.6, 1, 0.3, 20), 0, 9), "\n")
// expect: 0.775000000
// expect: -0.089000000
// expect: 1.051432316
// expect: -0.104009781

//= f_noise3d
#declare F = function { internal(76) }
#debug concat(str(F(0.3,-0.7,1.1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6), 0, 9), "\n")
// expect: 0.440069916
// expect: 0.399898322

//= f_noise_generator
#declare F = function { internal(78) }
#debug concat(str(F(0.3,-0.7,1.1, 1), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 1), 0, 9), "\n")
#debug concat(str(F(0.3,-0.7,1.1, 2), 0, 9), "\n")
#debug concat(str(F(-1.25,0.4,0.6, 2), 0, 9), "\n")
// expect: 0.345946209
// expect: 0.263939234
// expect: 0.440069916
// expect: 0.399898322
