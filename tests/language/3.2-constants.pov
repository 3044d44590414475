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
