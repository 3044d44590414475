// The standard includes: rand.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "rand.inc"

//= Prob
#declare S = seed(1);
#debug concat(str(Prob(0.5, S), 0, 9), "\n")
#debug concat(str(Prob(0.5, S), 0, 9), "\n")
#debug concat(str(Prob(0.5, S), 0, 9), "\n")
// expect: 1.000000000
// expect: 1.000000000
// expect: 0.000000000

//= SRand
#declare S = seed(1);
#debug concat(str(SRand(S), 0, 9), "\n")
#debug concat(str(SRand(S), 0, 9), "\n")
#debug concat(str(SRand(S), 0, 9), "\n")
// expect: -0.156014249
// expect: -0.025757604
// expect: 0.331792431

//= RRand
#declare S = seed(1);
#debug concat(str(RRand(2, 5, S), 0, 9), "\n")
#debug concat(str(RRand(2, 5, S), 0, 9), "\n")
#debug concat(str(RRand(2, 5, S), 0, 9), "\n")
// expect: 3.265978626
// expect: 3.461363595
// expect: 3.997688647

//= Rand_Cauchy
#declare S = seed(1);
#debug concat(str(Rand_Cauchy(0, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Cauchy(0, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Cauchy(0, 1, S), 0, 9), "\n")
// expect: -0.250093446
// expect: -0.040482041
// expect: 0.574127509

//= Rand_Normal
#declare S = seed(1);
#debug concat(str(Rand_Normal(0, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Normal(5, 2, S), 0, 9), "\n")
#debug concat(str(Rand_Normal(0, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Normal(5, 2, S), 0, 9), "\n")
#debug concat(str(Rand_Normal(0, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Normal(5, 2, S), 0, 9), "\n")
// expect: -0.052356197
// expect: 7.451226708
// expect: 1.261467644
// expect: 9.458059485
// expect: 0.001119391
// expect: 4.584914525

//= Rand_Gauss
#declare S = seed(1);
#debug concat(str(Rand_Gauss(0, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Gauss(0, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Gauss(5, 2, S), 0, 9), "\n")
#debug concat(str(Rand_Gauss(0, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Gauss(0, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Gauss(5, 2, S), 0, 9), "\n")
#debug concat(str(Rand_Gauss(0, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Gauss(0, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Gauss(5, 2, S), 0, 9), "\n")
// expect: -1.019559052
// expect: 0.543995194
// expect: 2.250045691
// expect: -2.355127033
// expect: -1.564798307
// expect: 8.528253072
// expect: -0.471111416
// expect: 1.522029540
// expect: 7.300464477

//= Rand_Student
#declare S = seed(1);
#debug concat(str(Rand_Student(4, S), 0, 9), "\n")
#debug concat(str(Rand_Student(4, S), 0, 9), "\n")
#debug concat(str(Rand_Student(4, S), 0, 9), "\n")
// expect: -1.195564007
// expect: 0.696870902
// expect: 1.112847746

//= Rand_Chi_Square
#declare S = seed(1);
#debug concat(str(Rand_Chi_Square(3, S), 0, 9), "\n")
#debug concat(str(Rand_Chi_Square(4.7, S), 0, 9), "\n")
#debug concat(str(Rand_Chi_Square(3, S), 0, 9), "\n")
#debug concat(str(Rand_Chi_Square(4.7, S), 0, 9), "\n")
#debug concat(str(Rand_Chi_Square(3, S), 0, 9), "\n")
#debug concat(str(Rand_Chi_Square(4.7, S), 0, 9), "\n")
// expect: 2.501721725
// expect: 2.908969026
// expect: 1.828128497
// expect: 1.102727859
// expect: 3.204946805
// expect: 4.071230530

//= Rand_F_Dist
#declare S = seed(1);
#debug concat(str(Rand_F_Dist(4, 3, S), 0, 9), "\n")
#debug concat(str(Rand_F_Dist(4, 3, S), 0, 9), "\n")
#debug concat(str(Rand_F_Dist(4, 3, S), 0, 9), "\n")
// expect: 0.645002156
// expect: 1.243367855
// expect: 0.590413656

//= Rand_Gamma
#declare S = seed(1);
#debug concat(str(Rand_Gamma(2, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Gamma(1, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Gamma(.5, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Gamma(0.8, 2, S), 0, 9), "\n")
#debug concat(str(Rand_Gamma(4.5, 3, S), 0, 9), "\n")
#debug concat(str(Rand_Gamma(2, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Gamma(1, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Gamma(.5, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Gamma(0.8, 2, S), 0, 9), "\n")
#debug concat(str(Rand_Gamma(4.5, 3, S), 0, 9), "\n")
#debug concat(str(Rand_Gamma(2, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Gamma(1, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Gamma(.5, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Gamma(0.8, 2, S), 0, 9), "\n")
#debug concat(str(Rand_Gamma(4.5, 3, S), 0, 9), "\n")
// expect: 1.667814483
// expect: 0.406621453
// expect: 2.856597953
// expect: 4.598503566
// expect: 18.817481202
// expect: 2.692344797
// expect: 0.692457611
// expect: 0.361222757
// expect: 0.989095410
// expect: 9.798893488
// expect: 0.201142007
// expect: 1.550216843
// expect: 0.204057634
// expect: 2.440125175
// expect: 5.995259537

//= Rand_Beta
#declare S = seed(1);
#debug concat(str(Rand_Beta(2, 3, S), 0, 9), "\n")
#debug concat(str(Rand_Beta(2, 3, S), 0, 9), "\n")
#debug concat(str(Rand_Beta(2, 3, S), 0, 9), "\n")
// expect: 0.415714123
// expect: 0.524303057
// expect: 0.412641968

//= Rand_Triangle
#declare S = seed(1);
#debug concat(str(Rand_Triangle(0, 1, .3, S), 0, 9), "\n")
#debug concat(str(Rand_Triangle(0, 1, .3, S), 0, 9), "\n")
#debug concat(str(Rand_Triangle(0, 1, .3, S), 0, 9), "\n")
#debug concat(str(Rand_Triangle(0, 1, .3, S), 0, 9), "\n")
#debug concat(str(Rand_Triangle(0, 1, .3, S), 0, 9), "\n")
#debug concat(str(Rand_Triangle(0, 1, .3, S), 0, 9), "\n")
// expect: 0.363914324
// expect: 0.400821261
// expect: 0.516396186
// expect: 0.869663258
// expect: 0.333544508
// expect: 0.791646999

//= Rand_Erlang
#declare S = seed(1);
#debug concat(str(Rand_Erlang(1, 3, S), 0, 9), "\n")
#debug concat(str(Rand_Erlang(1, 3, S), 0, 9), "\n")
#debug concat(str(Rand_Erlang(1, 3, S), 0, 9), "\n")
// expect: 1.988630621
// expect: 1.095128969
// expect: 3.875088414

//= Rand_Exp
#declare S = seed(1);
#debug concat(str(Rand_Exp(2, S), 0, 9), "\n")
#debug concat(str(Rand_Exp(2, S), 0, 9), "\n")
#debug concat(str(Rand_Exp(2, S), 0, 9), "\n")
// expect: 0.431383424
// expect: 0.359621160
// expect: 0.203310726

//= Rand_Lognormal
#declare S = seed(1);
#debug concat(str(Rand_Lognormal(0, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Lognormal(0, 1, S), 0, 9), "\n")
#debug concat(str(Rand_Lognormal(0, 1, S), 0, 9), "\n")
// expect: 0.360753979
// expect: 1.722876356
// expect: 0.252845372

//= Rand_Pareto
#declare S = seed(1);
#debug concat(str(Rand_Pareto(2, S), 0, 9), "\n")
#debug concat(str(Rand_Pareto(2, S), 0, 9), "\n")
#debug concat(str(Rand_Pareto(2, S), 0, 9), "\n")
// expect: 1.539385674
// expect: 1.432786515
// expect: 1.225453190

//= Rand_Weibull
#declare S = seed(1);
#debug concat(str(Rand_Weibull(2, 3, S), 0, 9), "\n")
#debug concat(str(Rand_Weibull(2, 3, S), 0, 9), "\n")
#debug concat(str(Rand_Weibull(2, 3, S), 0, 9), "\n")
// expect: 1.903974578
// expect: 1.791932887
// expect: 1.481699354

//= Rand_Bernoulli
#declare S = seed(1);
#debug concat(str(Rand_Bernoulli(0.5, S), 0, 9), "\n")
#debug concat(str(Rand_Bernoulli(0.5, S), 0, 9), "\n")
#debug concat(str(Rand_Bernoulli(0.5, S), 0, 9), "\n")
// expect: 1.000000000
// expect: 1.000000000
// expect: 0.000000000

//= Rand_Binomial
#declare S = seed(1);
#debug concat(str(Rand_Binomial(10, 0.3, S), 0, 9), "\n")
#debug concat(str(Rand_Binomial(10, 0.3, S), 0, 9), "\n")
#debug concat(str(Rand_Binomial(10, 0.3, S), 0, 9), "\n")
// expect: 2.000000000
// expect: 2.000000000
// expect: 3.000000000

//= Rand_Geo
#declare S = seed(1);
#debug concat(str(Rand_Geo(0.2, S), 0, 9), "\n")
#debug concat(str(Rand_Geo(0.2, S), 0, 9), "\n")
#debug concat(str(Rand_Geo(0.2, S), 0, 9), "\n")
// expect: 3.000000000
// expect: 3.000000000
// expect: 1.000000000

//= Rand_Poisson
#declare S = seed(1);
#debug concat(str(Rand_Poisson(3, S), 0, 9), "\n")
#debug concat(str(Rand_Poisson(3, S), 0, 9), "\n")
#debug concat(str(Rand_Poisson(3, S), 0, 9), "\n")
// expect: 5.000000000
// expect: 4.000000000
// expect: 7.000000000

//= VRand
#declare S = seed(1);
#debug concat(vstr(3, VRand(S), " ", 0, 9), "\n")
#debug concat(vstr(3, VRand(S), " ", 0, 9), "\n")
#debug concat(vstr(3, VRand(S), " ", 0, 9), "\n")
// expect: 0.421992875 0.487121198 0.665896216
// expect: 0.975731905 0.365481539 0.937984324
// expect: 0.297774397 0.718960470 0.096934443

//= VRand_In_Box
#declare S = seed(1);
#debug concat(vstr(3, VRand_In_Box(<1,2,3>, <4,4,4>, S), " ", 0, 9), "\n")
#debug concat(vstr(3, VRand_In_Box(<1,2,3>, <4,4,4>, S), " ", 0, 9), "\n")
#debug concat(vstr(3, VRand_In_Box(<1,2,3>, <4,4,4>, S), " ", 0, 9), "\n")
// expect: 2.265978626 2.974242396 3.665896216
// expect: 3.927195715 2.730963078 3.937984324
// expect: 1.893323191 3.437920940 3.096934443

//= VRand_In_Sphere
#declare S = seed(1);
#debug concat(vstr(3, VRand_In_Sphere(S), " ", 0, 9), "\n")
#debug concat(vstr(3, VRand_In_Sphere(S), " ", 0, 9), "\n")
#debug concat(vstr(3, VRand_In_Sphere(S), " ", 0, 9), "\n")
// expect: -0.705264837 0.057194851 0.248867498
// expect: -0.317478450 0.357919711 0.868824511
// expect: -0.076576623 -0.387655184 -0.538312918

//= VRand_On_Sphere
#declare S = seed(1);
#debug concat(vstr(3, VRand_On_Sphere(S), " ", 0, 9), "\n")
#debug concat(vstr(3, VRand_On_Sphere(S), " ", 0, 9), "\n")
#debug concat(vstr(3, VRand_On_Sphere(S), " ", 0, 9), "\n")
// expect: -0.881977433 0.470587244 -0.025757604
// expect: -0.155168752 -0.265780504 0.951463810
// expect: -0.320088999 0.360862799 0.875968648

//= RRand of vectors
#declare S = seed(1);
#debug concat(vstr(3, RRand(x, <2,3,4>, S), " ", 0, 9), "\n")
#debug concat(vstr(3, RRand(x, <2,3,4>, S), " ", 0, 9), "\n")
#debug concat(vstr(3, RRand(x, <2,3,4>, S), " ", 0, 9), "\n")
// expect: 1.421992875 1.265978626 1.687971501
// expect: 1.487121198 1.461363595 1.948484793
// expect: 1.665896216 1.997688647 2.663584863

//= VRand_In_Obj
#declare S = seed(1);
#declare O = intersection { box { -1, 1 } plane { <1,1,1>, -0.5 } }
#debug concat(vstr(3, VRand_In_Obj(O, S), " ", 0, 9), "\n")
#debug concat(vstr(3, VRand_In_Obj(O, S), " ", 0, 9), "\n")
#debug concat(vstr(3, VRand_In_Obj(O, S), " ", 0, 9), "\n")
// expect: -0.120247712 -0.476321088 -0.424478809
// expect: -0.766006108 -0.817072585 -0.732671560
// expect: -0.891454288 -0.746598170 0.655299897

//= Rand_Spline
#declare S = seed(1);
#declare L = spline { linear_spline 0, 0.2*y 1, y }
#debug concat(str(Rand_Spline(L, S), 0, 9), "\n")
#debug concat(str(Rand_Spline(L, S), 0, 9), "\n")
#debug concat(str(Rand_Spline(L, S), 0, 9), "\n")
#debug concat(str(cVal, 0, 9), "\n")
// expect: 0.421992875
// expect: 0.528583667
// expect: 0.965810043
// expect: 0.965810043

//= streams
#debug concat(str(rand(RdmA), 0, 9), "\n")
#debug concat(str(rand(RdmB), 0, 9), "\n")
#debug concat(str(rand(RdmC), 0, 9), "\n")
#debug concat(str(rand(RdmD), 0, 9), "\n")
// expect: 0.288036074
// expect: 0.689497360
// expect: 0.202912715
// expect: 0.960339672

//= Gauss_Next is shared by all streams
#declare S = seed(1); #declare T = seed(2);
#debug concat(str(Rand_Gauss(0, 1, S), 0, 9), "\n")
#debug concat(str(Gauss_Next, 0, 9), "\n")
#debug concat(str(Rand_Gauss(0, 1, T), 0, 9), "\n")
#debug concat(str(Rand_Gauss(0, 1, T), 0, 9), "\n")
// expect: -1.019559052
// expect: 0.543995194
// expect: 0.543995194
// expect: 0.662844032
