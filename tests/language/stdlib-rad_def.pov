// The standard includes: rad_def.inc.
#version 3.7;
#include "rad_def.inc"

//= Rad_Settings
// chatty
global_settings { assumed_gamma 1 radiosity { Rad_Settings(Radiosity_Normal, off, on) } }
#debug "= read\n"
// expect: = read

//= Rad_Settings of every kind
// chatty
#for (I, Radiosity_Default, Radiosity_IndoorHQ)
  global_settings { assumed_gamma 1 radiosity { Rad_Settings(I, on, off) } }
#end
#debug "= read\n"
// expect: = read
