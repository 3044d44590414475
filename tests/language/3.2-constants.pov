// Language §3.2: constants and variables.
#version 3.7;
global_settings { assumed_gamma 1 }

//= pi
#debug concat(str(pi, 0, 15), "\n")
// expect: 3.141592653589793

//= truth values
#debug concat(str(true, 0, 0), "\n")
#debug concat(str(on, 0, 0), "\n")
#debug concat(str(yes, 0, 0), "\n")
#debug concat(str(false, 0, 0), "\n")
#debug concat(str(off, 0, 0), "\n")
#debug concat(str(no, 0, 0), "\n")
// expect: 1
// expect: 1
// expect: 1
// expect: 0
// expect: 0
// expect: 0

//= the clock of a still picture
#debug concat(str(clock, 0, 6), "\n")
#debug concat(str(clock_on, 0, 6), "\n")
// expect: 0.000000
// expect: 0.000000

//= now is later than 2020 and a number of days
#debug concat(str((now > 7300), 0, 0), "\n")
#debug concat(str((now < 40000), 0, 0), "\n")
// expect: 1
// expect: 1

//= version
#debug concat(str(version, 0, 2), "\n")
// expect: 3.70

//= axes
#debug concat(vstr(3, x, ",", 0, 3), "\n")
#debug concat(vstr(3, y, ",", 0, 3), "\n")
#debug concat(vstr(3, z, ",", 0, 3), "\n")
#debug concat(vstr(4, 2*t, ",", 0, 3), "\n")
#debug concat(vstr(4, (t), ",", 0, 3), "\n")
#debug concat(vstr(2, u, ",", 0, 3), "\n")
#debug concat(vstr(2, v, ",", 0, 3), "\n")
// expect: 1.000,0.000,0.000
// expect: 0.000,1.000,0.000
// expect: 0.000,0.000,1.000
// expect: 0.000,0.000,0.000,2.000
// expect: 0.000,0.000,0.000,1.000
// expect: 1.000,0.000
// expect: 0.000,1.000

//= t may not begin a declaration
#declare A = t;
// beyond

//= size of the picture
#debug concat(str(image_width, 0, 0), "\n")
#debug concat(str(image_height, 0, 0), "\n")
// expect: 1
// expect: 1

//= the name of the scene
#debug concat(input_file_name, "\n")
// expect: case.pov

//= animation, when there is none
#debug concat(str(frame_number, 0, 0), "\n")
#debug concat(str(initial_frame, 0, 0), "\n")
#debug concat(str(final_frame, 0, 0), "\n")
#debug concat(str(initial_clock, 0, 0), "\n")
#debug concat(str(final_clock, 0, 0), "\n")
#debug concat(str(clock_delta, 0, 0), "\n")
// expect: 0
// expect: 0
// expect: 0
// expect: 0
// expect: 0
// expect: 0

//= @ may be declared anew
#declare @ = 77; #debug concat(str(@, 0, 0), "\n")
// each: image_width image_height input_file_name frame_number initial_frame final_frame initial_clock final_clock clock_delta
// expect: 77

//= @ may be removed
#undef @ #debug concat(str(defined(@), 0, 0), "\n")
// each: image_width image_height input_file_name frame_number initial_frame final_frame initial_clock final_clock clock_delta
// expect: 0

//= @ is zero in a still picture
#debug concat(str(@, 0, 6), "\n")
// each: frame_number initial_frame final_frame initial_clock final_clock clock_delta clock clock_on
// expect: 0.000000

//= now has fractions
#debug concat(str((now != int(now)), 0, 0), "\n")
// expect: 1

//= constants of vectors in sums
#debug concat(vstr(3, x + 2*y + 3*z, ",", 0, 0), vstr(2, u + 2*v, ",", 0, 0), "\n")
// expect: 1,2,31,2
